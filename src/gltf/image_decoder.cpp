#include "gltf/image_decoder.h"

#include <algorithm>
#include <cmath>

#include <stb/stb_image.h>

namespace dimline {

namespace {

/// Pixels of the largest picture that is unpacked at all: 16,384 square would take 1 GB.
constexpr std::int64_t kMaxPixels = 8192LL * 8192LL;

/// Every 2x2 block becomes one pixel. The mean of the squares stands in for the mean in linear light (a gamma of 2 for sRGB's
/// 2.2): a plain mean of sRGB values would darken fine patterns. An odd last row or column is left out.
Image halved(const Image& image) {
  Image result;
  result.width = std::max(image.width / 2, 1U);
  result.height = std::max(image.height / 2, 1U);
  result.rgba.resize(std::size_t{result.width} * result.height * 4);
  for (std::uint32_t y = 0; y < result.height; ++y) {
    for (std::uint32_t x = 0; x < result.width; ++x) {
      const std::uint32_t x0 = std::min(2 * x, image.width - 1), x1 = std::min(2 * x + 1, image.width - 1);
      const std::uint32_t y0 = std::min(2 * y, image.height - 1), y1 = std::min(2 * y + 1, image.height - 1);
      const auto pixel = [&](std::uint32_t px, std::uint32_t py) {
        return image.rgba.data() + (std::size_t{py} * image.width + px) * 4;
      };
      const std::uint8_t* corners[] = {pixel(x0, y0), pixel(x1, y0), pixel(x0, y1), pixel(x1, y1)};
      std::uint8_t* out = result.rgba.data() + (std::size_t{y} * result.width + x) * 4;
      for (std::size_t c = 0; c < 4; ++c) {
        float sum = 0;
        for (const std::uint8_t* corner : corners) {
          const auto value = static_cast<float>(corner[c]);
          sum += c < 3 ? value * value : value;
        }
        out[c] = static_cast<std::uint8_t>((c < 3 ? std::sqrt(sum / 4) : sum / 4) + 0.5F);
      }
    }
  }
  return result;
}

}  // namespace

Result<Image> decodeImage(std::span<const std::byte> bytes, std::uint32_t maxSidePx) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (size == 0 || stbi_info_from_memory(data, size, &width, &height, &channels) == 0 || width < 1 || height < 1) {
    return Error{"it is neither a PNG nor a JPEG"};
  }
  if (std::int64_t{width} * height > kMaxPixels) return Error{"it is too large"};
  stbi_uc* pixels = stbi_load_from_memory(data, size, &width, &height, &channels, 4);
  if (pixels == nullptr) return Error{"it is damaged"};

  Image image;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.rgba.assign(pixels, pixels + std::size_t{image.width} * image.height * 4);
  stbi_image_free(pixels);
  while (image.width > maxSidePx || image.height > maxSidePx) image = halved(image);
  return image;
}

}  // namespace dimline
