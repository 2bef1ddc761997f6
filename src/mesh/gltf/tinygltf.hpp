// tinygltf as this room uses it, everywhere with the same switches: pictures stay encoded, so
// nothing of stb is needed, and files are the caller's, so it opens none.
#pragma once

#include <fstream>  // which tinygltf's writer of files forgets under TINYGLTF_NO_FS

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
