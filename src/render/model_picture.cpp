#include "render/model_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include <glm/geometric.hpp>

namespace dimline {

namespace {

constexpr double kMaxSamples = 4096;

/// A drawing is mostly paper: colours are mixed with white, and surfaces turned away from the light keep this much of them.
constexpr float kColorShare = 0.46F;
constexpr float kDarkest = 0.66F;

/// Steps from light to dark. Few enough that a round surface falls into bands that can be outlined.
constexpr float kToneSteps = 14.0F;

float toSrgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}
float toLinear(float srgb) { return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F); }

/// Looks up what a texture shows on a triangle.
class TextureColors {
public:
  TextureColors() {
    for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = toLinear(static_cast<float>(i) / 255.0F);
  }

  /// The mean colour (linear) of an image over a triangle, by a few points spread over it, in coarse steps: a drawing shows no grain.
  [[nodiscard]] glm::vec3 mean(const Image& image, const std::array<glm::vec2, 3>& uvs) const {
    constexpr int kSteps = 5;
    constexpr float kLevels = 20.0F;
    glm::vec3 sum(0.0F);
    int count = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps - i; ++j) {
        const float u = (static_cast<float>(i) + 1.0F / 3.0F) / kSteps,
                    v = (static_cast<float>(j) + 1.0F / 3.0F) / kSteps;
        sum += at(image, uvs[0] + (uvs[1] - uvs[0]) * u + (uvs[2] - uvs[0]) * v);
        ++count;
      }
    }
    glm::vec3 color = sum / static_cast<float>(count);
    for (int c = 0; c < 3; ++c) color[c] = toLinear(std::round(toSrgb(color[c]) * kLevels) / kLevels);
    return color;
  }

private:
  [[nodiscard]] glm::vec3 at(const Image& image, const glm::vec2& uv) const {
    const auto texel = [](float share, std::uint32_t size) {
      const double turns = static_cast<double>(share) - std::floor(static_cast<double>(share));
      return std::isfinite(turns) ? std::min(static_cast<std::uint32_t>(turns * size), size - 1) : 0U;
    };
    const std::size_t i = (std::size_t{texel(uv.y, image.height)} * image.width + texel(uv.x, image.width)) * 4;
    return {linear_[image.rgba[i]], linear_[image.rgba[i + 1]], linear_[image.rgba[i + 2]]};
  }

  std::array<float, 256> linear_{};
};

/// A surface's colour on paper, sRGB 0 to 1.
glm::vec3 paperColor(const glm::vec3& linear) {
  const glm::vec3 srgb(toSrgb(linear.r), toSrgb(linear.g), toSrgb(linear.b));
  return glm::mix(glm::vec3(1.0F), glm::clamp(srgb, 0.0F, 1.0F), kColorShare);
}

std::uint32_t packRgb(const glm::vec3& color) {
  std::uint32_t rgb = 0;
  for (int c = 0; c < 3; ++c)
    rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(std::clamp(color[c], 0.0F, 1.0F) * 255.0F));
  return rgb;
}

/// Light from behind the viewer's left shoulder and from above, whichever way he looks: the faces that meet at a corner never
/// have one tone.
Vec3 towardsLight(const View& view) {
  // The way he looks, level with the ground; the mite of forward is for a viewer who lies on his side.
  const Vec3 level = glm::normalize(glm::cross(Vec3(0, 1, 0), view.right()) + view.forward() * 1e-9);
  return glm::normalize(Vec3(0, 1, 0) * 0.85 - view.right() * 0.62 +
                        level * (glm::dot(level, view.forward()) > 0 ? -0.42 : 0.42));
}

/// What each triangle looks like on paper.
class Tones {
public:
  Tones(const Scene& scene, const View& view) : scene_(scene), view_(view), light_(towardsLight(view)) {}

  [[nodiscard]] ModelPicture::Surface surface(const Mesh& mesh, std::size_t triangle, const std::array<Vec3, 3>& world,
                                              std::uint32_t part) const {
    Vec3 normal = glm::cross(world[1] - world[0], world[2] - world[0]);
    const double length = glm::length(normal);
    if (!(length > 0)) return {0, part, glm::vec3(0.0F)};
    normal /= length;
    if (glm::dot(normal, view_.directionTo(world[0])) > 0) normal = -normal;
    // Half a turn from light to dark, so that no face is lost in plain shadow.
    const auto lit = static_cast<float>(0.5 + 0.5 * glm::dot(normal, light_));
    const float tone = std::round(lit * kToneSteps) / kToneSteps;
    const Material& material = scene_.materials[mesh.materials[triangle]];
    glm::vec3 color = material.color;
    if (material.image >= 0 && !mesh.uvs.empty()) {
      color *= textures_.mean(*scene_.images[static_cast<std::size_t>(material.image)], mesh.uvs[triangle]);
    }
    return {packRgb(paperColor(color) * (kDarkest + (1.0F - kDarkest) * tone)), part, glm::vec3(normal)};
  }

private:
  const Scene& scene_;
  const View& view_;
  Vec3 light_;
  TextureColors textures_;
};

/// Numbers the parts of a mesh from `next` on: one number a triangle.
std::vector<std::uint32_t> partsOf(const Mesh& mesh, std::uint32_t& next) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::vector<std::uint32_t> number(mesh.positions.size(), ModelPicture::kNothing);
  std::vector<std::uint32_t> parts;
  for (const auto& t : mesh.triangles) {
    std::uint32_t& part = number[root(t[0])];
    if (part == ModelPicture::kNothing) part = next++;
    parts.push_back(part);
  }
  return parts;
}

/// A corner on the grid.
struct GridPoint {
  double x, y, nearness;
};

class Rasteriser {
public:
  Rasteriser(const View& view, ModelPicture& picture) : view_(view), picture_(picture) {}

  /// Draws a triangle of the world, cut at the near plane.
  void draw(const std::array<Vec3, 3>& world, std::uint32_t surface) {
    std::array<GridPoint, 4> corners;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = world[i], &b = world[(i + 1) % 3];
      const double beyondA = view_.depth(a) - view_.nearM(), beyondB = view_.depth(b) - view_.nearM();
      if (beyondA >= 0) corners[count++] = toGrid(a);
      if ((beyondA >= 0) != (beyondB >= 0)) corners[count++] = toGrid(a + (b - a) * (beyondA / (beyondA - beyondB)));
    }
    for (std::size_t i = 2; i < count; ++i) fill(corners[0], corners[i - 1], corners[i], surface);
  }

private:
  [[nodiscard]] GridPoint toGrid(const Vec3& p) const {
    const Vec2 s = view_.toScreen(p) * picture_.samplesPerPx;
    return {s.x, s.y, nearnessOf(view_, view_.depth(p))};
  }

  void fill(const GridPoint& a, const GridPoint& b, const GridPoint& c, std::uint32_t surface) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(area) > 1e-9) || !std::isfinite(area)) return;
    // Barycentric weights are linear on screen: w = w0 + x * wx + y * wy.
    const double nearX = ((b.nearness - a.nearness) * (c.y - a.y) - (c.nearness - a.nearness) * (b.y - a.y)) / area;
    const double nearY = ((c.nearness - a.nearness) * (b.x - a.x) - (b.nearness - a.nearness) * (c.x - a.x)) / area;
    const auto clampTo = [](double v, int limit) {
      return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(limit)));
    };
    const int firstX = clampTo(std::ceil(std::min({a.x, b.x, c.x}) - 0.5), picture_.width);
    const int lastX = clampTo(std::floor(std::max({a.x, b.x, c.x}) - 0.5) + 1, picture_.width);
    const int firstY = clampTo(std::ceil(std::min({a.y, b.y, c.y}) - 0.5), picture_.height);
    const int lastY = clampTo(std::floor(std::max({a.y, b.y, c.y}) - 0.5) + 1, picture_.height);
    const double sense = area > 0 ? 1 : -1;
    const auto side = [&](const GridPoint& p, const GridPoint& q, double x, double y) {
      return sense * ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x));
    };
    for (int y = firstY; y < lastY; ++y) {
      for (int x = firstX; x < lastX; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        if (side(a, b, px, py) < 0 || side(b, c, px, py) < 0 || side(c, a, px, py) < 0) continue;
        const auto nearness = static_cast<float>(a.nearness + (px - a.x) * nearX + (py - a.y) * nearY);
        const std::size_t i = picture_.at(x, y);
        if (picture_.seen[i] != ModelPicture::kNothing && picture_.nearness[i] >= nearness) continue;
        picture_.seen[i] = surface;
        picture_.nearness[i] = nearness;
      }
    }
  }

  const View& view_;
  ModelPicture& picture_;
};

}  // namespace

double nearnessOf(const View& view, double depthM) { return view.orthographic() ? -depthM : 1 / depthM; }
double depthOf(const View& view, double nearness) { return view.orthographic() ? -nearness : 1 / nearness; }

ModelPicture drawModelPicture(const Scene& scene, const View& view, double samplesPerPx) {
  ModelPicture picture;
  picture.samplesPerPx = std::min(samplesPerPx, kMaxSamples / std::max(view.widthPx(), view.heightPx()));
  picture.width = std::max(1, static_cast<int>(std::ceil(view.widthPx() * picture.samplesPerPx)));
  picture.height = std::max(1, static_cast<int>(std::ceil(view.heightPx() * picture.samplesPerPx)));
  const std::size_t samples = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.seen.assign(samples, ModelPicture::kNothing);
  picture.nearness.assign(samples, 0.0F);

  const Tones tones(scene, view);
  Rasteriser rasteriser(view, picture);
  std::uint32_t nextPart = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const std::vector<std::uint32_t> parts = partsOf(mesh, nextPart);
    const Mat4 toWorld(instance.transform);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      std::array<Vec3, 3> world;
      for (std::size_t c = 0; c < 3; ++c) {
        world[c] = Vec3(toWorld * Vec4(Vec3(mesh.positions[mesh.triangles[t][c]]), 1.0));
      }
      const auto surface = static_cast<std::uint32_t>(picture.surfaces.size());
      picture.surfaces.push_back(tones.surface(mesh, t, world, parts[t]));
      rasteriser.draw(world, surface);
    }
  }
  return picture;
}

}  // namespace dimline
