// The one place where the header-only libraries of this folder are compiled.

// tiny_gltf.h uses streams without including them when it is told to leave files alone.
#include <fstream>
#include <sstream>

#define TINYGLTF_IMPLEMENTATION
#include "gltf/tinygltf_only.h"

// Only what glTF allows, and from memory only: the rest would be dead weight in the page.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#include <stb/stb_image.h>
