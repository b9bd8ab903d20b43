#include "gltf/image_encoder.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace dimline {

std::vector<unsigned char> encodePng(const Image& image) {
  std::vector<unsigned char> bytes;
  const auto append = [](void* to, void* data, int size) {
    auto& all = *static_cast<std::vector<unsigned char>*>(to);
    const auto* first = static_cast<const unsigned char*>(data);
    all.insert(all.end(), first, first + size);
  };
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  if (stbi_write_png_to_func(append, &bytes, width, height, 4, image.rgba.data(), width * 4) == 0) bytes.clear();
  return bytes;
}

}  // namespace dimline
