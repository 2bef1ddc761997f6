// The only file in which tinygltf is compiled.
#define TINYGLTF_IMPLEMENTATION
#include "mesh/gltf/tinygltf.hpp"
