#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "gpu/gl_objects.h"
#include "render/renderer.h"
#include "support/gl_test_context.h"

namespace dimline::test {

/// A drawn picture, top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
    return glm::vec4(rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3]);
  }
  /// 0 to 255.
  [[nodiscard]] float brightness(int x, int y) const {
    const glm::vec4 c = at(x, y);
    return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
  }
  /// Mean brightness of the square of that half size around a pixel.
  [[nodiscard]] float brightnessAround(const Vec2& px, int half) const {
    float sum = 0;
    int count = 0;
    for (int y = static_cast<int>(px.y) - half; y <= static_cast<int>(px.y) + half; ++y) {
      for (int x = static_cast<int>(px.x) - half; x <= static_cast<int>(px.x) + half; ++x) {
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
        sum += brightness(x, y);
        ++count;
      }
    }
    REQUIRE(count > 0);
    return sum / static_cast<float>(count);
  }
};

/// Mean difference of two pictures' colours, 0 to 255.
inline double meanDifference(const Picture& a, const Picture& b) {
  REQUIRE(a.rgba.size() == b.rgba.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(static_cast<double>(a.rgba[i]) - b.rgba[i]);
  return sum / static_cast<double>(a.rgba.size());
}

/// A renderer in a GL context of its own, and a framebuffer to draw into.
struct PictureFixture : GlTestContext {
  std::unique_ptr<Renderer> renderer = std::make_unique<Renderer>();
  RenderOptions options;

  void setScene(const Scene& scene) const { renderer->setScene(scene); }

  Picture draw(const View& view, double ratio = 1, const Overlay& overlay = {}) {
    Picture picture;
    picture.width = static_cast<int>(std::lround(view.widthPx() * ratio));
    picture.height = static_cast<int>(std::lround(view.heightPx() * ratio));
    const Texture texture = makeTexture2D(*gl, GL_RGBA8, picture.width, picture.height, Sampling::kNearest);
    Result<Framebuffer> framebuffer = makeFramebuffer(*gl, "test", texture.id(), 0);
    if (!framebuffer) FAIL(framebuffer.error().message);
    options.framebuffer = framebuffer->id();
    options.widthPx = picture.width;
    options.heightPx = picture.height;
    options.devicePixelRatio = ratio;
    const Status status = renderer->draw(view, overlay, options);
    if (!status) FAIL(status.error().message);

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer->id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    std::vector<std::uint8_t> bottomUp(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4);
    glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, bottomUp.data());
    const std::size_t row = static_cast<std::size_t>(picture.width) * 4;
    for (std::size_t y = bottomUp.size() / row; y-- > 0;) {
      picture.rgba.insert(picture.rgba.end(), bottomUp.begin() + static_cast<std::ptrdiff_t>(y * row),
                          bottomUp.begin() + static_cast<std::ptrdiff_t>((y + 1) * row));
    }
    REQUIRE(glGetError() == GL_NO_ERROR);
    return picture;
  }
};

}  // namespace dimline::test
