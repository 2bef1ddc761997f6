// The one place where tinygltf is compiled.
#define TINYGLTF_IMPLEMENTATION
#include "mesh/gltf/tinygltf.hpp"
