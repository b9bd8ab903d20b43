#pragma once

/// tinygltf as this folder uses it: the parser alone. Files come from a resolver, images are decoded elsewhere, and only where
/// a surface shows them. Included by nobody outside src/gltf.
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
