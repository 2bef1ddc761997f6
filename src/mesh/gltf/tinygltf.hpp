// Includes tinygltf with the same switches everywhere: images stay encoded, so stb isn't needed,
// and it opens no files, since the caller provides them.
#pragma once

#include <fstream>  // which tinygltf's writer of files forgets under TINYGLTF_NO_FS

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
