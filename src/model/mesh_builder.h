#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "model/scene.h"

namespace dimline {

/// Writes triangles into a mesh, part by part. A part is one connected surface, closed wherever the thing it shows is
/// solid: its points are shared between all faces that meet there, and never with another part, so that each edge of
/// a closed part belongs to exactly two triangles. Points are doubles until they are written. All faces are
/// counter-clockwise seen from outside.
class MeshBuilder {
public:
  /// Points nearer than this are one when they are welded (m). Far below anything that is built, far above rounding.
  static constexpr double kWeldM = 1e-6;
  /// A size, or a distance between points of an outline, below this is none (m).
  static constexpr double kNothingM = 1e-9;

  explicit MeshBuilder(Mesh& mesh) : mesh_(mesh) { beginPart(); }

  void beginPart();

  /// Makes room for so many triangles in all.
  void reserve(std::size_t triangles);

  /// A new point of the part.
  std::uint32_t point(const Vec3& p);
  /// The part's point at that place, or a new one. Points added by point() are found too.
  std::uint32_t weld(const Vec3& p);

  [[nodiscard]] const Vec3& at(std::uint32_t point) const { return points_[point - firstPoint_]; }

  /// A flat convex face: shaded flat, uv from its plane (see planeUv). Points that repeat are left out; fewer than
  /// three are no face.
  void face(std::span<const std::uint32_t> ring, std::uint16_t material);

  struct Corner {
    std::uint32_t point;
    Vec3 normal;  ///< unit length
    glm::vec2 uv;
  };
  /// A triangle with its own normals and uv; none when two corners are one point.
  void triangle(const Corner& a, const Corner& b, const Corner& c, std::uint16_t material);
  /// A convex quadrilateral as two triangles, or one where two neighbouring corners are one point.
  void quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d, std::uint16_t material);

  /// Shades the current part as one curved surface: the normals at each point become the mean of those faces around it
  /// that meet the corner's own face at no more than `creaseRad`. Materials and uv stay.
  void smooth(double creaseRad);

private:
  Mesh& mesh_;
  std::uint32_t firstPoint_ = 0;
  std::size_t firstTriangle_ = 0;  // of the current part
  std::vector<Vec3> points_;  // of the current part
  std::vector<std::uint32_t> ring_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> cells_;
  std::size_t welded_ = 0;  // so many of points_ are in cells_

  // What smooth() works with, kept from part to part: a model has thousands of them.
  struct Smoothing {
    struct Face {
      Vec3 normal;
      double area;  // twice it
    };
    struct Corner {
      Vec3 weighted;  // the face's normal, as much as it counts at this corner
      std::uint32_t triangle;
      std::uint8_t corner;
    };
    std::vector<Face> faces;
    std::vector<Corner> around;  // the corners at each point, point by point
    std::vector<std::uint32_t> firstAt, next;
  } smoothing_;
};

/// The two directions in which a plane's uv run, in metres: u horizontal (to the right seen from outside), v up the
/// slope. On a level plane, u is +x, and v is -z seen from above, +z seen from below.
struct PlaneAxes {
  Vec3 u, v;
};
PlaneAxes planeAxes(const Vec3& normal);
glm::vec2 planeUv(const PlaneAxes& axes, const Vec3& p);

}  // namespace dimline
