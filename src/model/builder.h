#pragma once

#include <deque>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "math/geometry.h"
#include "model/mesh_builder.h"
#include "model/polygon.h"
#include "model/roof.h"
#include "model/scene.h"

// Procedural modelling in the terms of shape grammars (CGA shape: Müller, Wonka and others 2006). There is always a
// current scope, an oriented box; operations move it, divide it, name it, or put geometry into it.
//
//     Builder b;
//     b.scale({8, 6, 5});                                                 // the scope: a box at the origin
//     b.name("Body");                                                     // can be dimensioned now
//     b.face(Face::kFront, [&] {                                          // component split: x right, y up, z outwards
//       b.split(Axis::kX, {fixed(0.5), floating(1), fixed(0.5)}, [&](int i) {
//         if (i == 1) b.repeat(Axis::kX, 2.0, [&](int, int) { drawWindow(b); });
//       });
//     });
//     Scene scene = b.finish();
//
// Whatever runs inside a lambda sees the scope that the operation made for it; afterwards scope and material are what
// they were. All lengths are metres, all angles radians. Sizes are given along the scope's own axes and counted from
// its origin corner. World: y up.
//
// Geometry. Each primitive adds one closed part, its faces counter-clockwise seen from outside, its points shared
// (mesh_builder.h). A primitive whose scope has no extent in a direction that it needs adds nothing, so rules need
// not guard against sizes that shrink to zero. Same calls, same bytes.

namespace dimline {

enum class Axis { kX = 0, kY = 1, kZ = 2 };

/// The faces of a scope's box: right is +x, top +y, front +z.
enum class Face { kFront, kBack, kLeft, kRight, kTop, kBottom };
inline constexpr Face kSideFaces[] = {Face::kFront, Face::kRight, Face::kBack, Face::kLeft};
inline constexpr Face kAllFaces[] = {Face::kFront, Face::kRight, Face::kBack, Face::kLeft, Face::kTop, Face::kBottom};

/// One piece of a split. Fixed pieces are metres, relative ones a share of the whole; what these leave is divided
/// among the floating ones in proportion to their weights. When fixed and relative pieces need more than there is,
/// floating ones get nothing and the others shrink, all by one factor, so that they fit. Without a floating piece,
/// what is left over stays empty, at the far end.
struct SplitSize {
  enum class Kind { kFixed, kRelative, kFloating };
  Kind kind = Kind::kFloating;
  double value = 1;
};
constexpr SplitSize fixed(double metres) { return {SplitSize::Kind::kFixed, metres}; }
constexpr SplitSize relative(double share) { return {SplitSize::Kind::kRelative, share}; }
constexpr SplitSize floating(double weight = 1) { return {SplitSize::Kind::kFloating, weight}; }

struct Interval {
  double start = 0;
  double length = 0;
  [[nodiscard]] double end() const { return start + length; }
};

/// The pieces of a length. Negative sizes count as zero.
std::vector<Interval> splitIntervals(double lengthM, std::span<const SplitSize> sizes);

/// How many pieces of about `targetM` fill a length evenly: the quotient rounded, at least one. `targetM` > 0.
int repeatCount(double lengthM, double targetM);

using MaterialId = std::uint16_t;
using PartId = std::uint32_t;

/// Linear light from the usual 0xRRGGBB.
glm::vec3 linearFromSrgb(std::uint32_t rgb);

/// Options of lathe, cylinder and the like.
struct RoundOptions {
  int segments = 24;       ///< around the axis, >= 3
  double creaseRad = 0.7;  ///< profile edges that meet at more than this are hard
};

class Builder {
public:
  Builder();

  /// Makes room for so many triangles, for a large model: what is built is not moved again and again as it grows.
  void reserve(std::size_t triangles);

  /// Hands over the scene, with bounds and scope indices filled in. The builder is empty afterwards.
  Scene finish();

  // --- The scope -------------------------------------------------------------------------------------------------------

  [[nodiscard]] const Obb& scope() const { return state().scope; }
  [[nodiscard]] const Vec3& size() const { return state().scope.size; }
  void setScope(const Obb& scope) { state().scope = scope; }

  /// Keeps a copy of scope and material, and goes back to it.
  void push();
  void pop();
  /// The same around a lambda.
  template <typename Body>
  void push(Body&& body) {
    push();
    body();
    pop();
  }

  /// Moves the origin along the scope's axes.
  void translate(const Vec3& byM);
  /// Turns the axes about one of them, counter-clockwise seen against it. `pivot` stays where it is; it is in units
  /// of the scope's size: the default is the origin corner, (0.5, 0, 0.5) the middle of the floor.
  void rotate(Axis axis, double angleRad, const Vec3& pivot = Vec3(0.0));
  /// Sets the size (the s operation of CGA shape); the origin stays.
  void scale(const Vec3& sizeM);
  /// Sets the size along one axis.
  void scale(Axis axis, double sizeM);
  /// Sets the size and keeps the middle along x and z: for something that stands in the middle of a floor.
  void scaleCentered(const Vec3& sizeM);
  /// Gives a face's scope depth: outwards from the face, or inwards when negative. The scope's z stays the outward
  /// normal.
  void extrude(double depthM);
  /// Grows a face's scope by the distance on all four sides (shrinks when negative, to nothing at most).
  void offset(double distanceM);

  /// Divides the scope along an axis and runs body(i) in each piece. Pieces of no length are left out.
  template <typename Body>
  void split(Axis axis, std::span<const SplitSize> sizes, Body&& body) {
    const std::vector<Interval> pieces = splitIntervals(size()[static_cast<int>(axis)], sizes);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].length <= 0) continue;
      push();
      slice(axis, pieces[i]);
      body(static_cast<int>(i));
      pop();
    }
  }
  template <typename Body>
  void split(Axis axis, std::initializer_list<SplitSize> sizes, Body&& body) {
    split(axis, std::span(sizes.begin(), sizes.size()), std::forward<Body>(body));
  }

  /// Divides the scope into equal pieces of about `targetM` (see repeatCount) and runs body(i, count) in each.
  template <typename Body>
  void repeat(Axis axis, double targetM, Body&& body) {
    const double length = size()[static_cast<int>(axis)];
    if (!(length > 0)) return;
    const int count = repeatCount(length, targetM);
    for (int i = 0; i < count; ++i) {
      push();
      slice(axis, {length * i / count, length / count});
      body(i, count);
      pop();
    }
  }

  /// Component split: runs the body in the 2-D scope of a face of the box. Its origin is the lower left corner seen
  /// from outside, x runs right, y up (on top: to the back; below: to the front), z is the outward normal and the
  /// size along z is 0.
  template <typename Body>
  void face(Face which, Body&& body) {
    push();
    enterFace(which);
    body();
    pop();
  }
  /// The same for several faces: body(face).
  template <typename Body>
  void faces(std::span<const Face> which, Body&& body) {
    for (const Face f : which) {
      face(f, [&] { body(f); });
    }
  }
  /// The same for the outer faces of a roof (roof.h): body(i) in a 2-D scope whose x runs along the eave, y up the
  /// slope and z outwards; its size is that of the rectangle around the face. The scope must be the one in which the
  /// roof was made.
  template <typename Body>
  void slopes(const Roof& roof, Body&& body) {
    for (std::size_t i = 0; i < roof.slopes.size(); ++i) {
      push();
      enterSlope(roof, i);
      body(static_cast<int>(i));
      pop();
    }
  }

  /// Records the scope under a name, for dimension lines to be tied to.
  void name(std::string_view name);

  // --- Colour and material ---------------------------------------------------------------------------------------------

  /// The id of a material in the scene; equal ones are one.
  MaterialId addMaterial(const Material& material);
  void material(MaterialId id) { state().material = id; }
  void material(const Material& material) { state().material = addMaterial(material); }
  [[nodiscard]] MaterialId material() const { return state().material; }
  /// The current material in another colour (linear light).
  void color(const glm::vec3& linear);

  // --- Primitives that fill the scope ------------------------------------------------------------------------------------

  void box();
  /// A box at a corner of its own, counted from the scope's origin: short for push, translate, scale, box, pop.
  void box(const Vec3& cornerM, const Vec3& sizeM);
  /// One-sided rectangle over x and y, facing +z: for what is no solid, like a picture on a wall.
  void rectangle();
  /// About the scope's y axis, elliptical when x and z differ.
  void cylinder(const RoundOptions& options = {});
  /// The same, drawn in at the top to `topShare` of the bottom's radius: 0 is a cone, between 0 and 1 a frustum.
  void cone(double topShare = 0, const RoundOptions& options = {});
  /// An ellipsoid.
  void sphere(const RoundOptions& options = {});

  // --- Primitives with a shape of their own ------------------------------------------------------------------------------

  /// Turns a profile of (radius >= 0, height) about the vertical line through the middle of the scope's floor. The
  /// profile is an open line; ends that are not on the axis are closed by flat discs. It may run either way, up or
  /// down, in and out.
  void lathe(std::span<const Vec2> profile, const RoundOptions& options = {});

  /// A prism over a polygon, from one side of the scope to the other along `axis`. The polygon's points are metres
  /// from the scope's origin, in (x, y) for axis z, (z, y) for axis x, (x, z) for axis y: the first coordinate lies
  /// level. Edges of the outline that meet at less than `creaseRad` are shaded as one curve.
  void extrudePolygon(const Polygon& polygon, Axis axis = Axis::kZ, double creaseRad = 0);
  void extrudePolygon(const Ring& outline, Axis axis = Axis::kZ, double creaseRad = 0) {
    extrudePolygon(Polygon{outline, {}}, axis, creaseRad);
  }

  /// Draws a section (metres, counter-clockwise or not; may be concave) along a path given in the scope, mitred at
  /// the bends. Where the path starts, the section's first axis points to the right of the way seen along it and its
  /// second one along `up`; after that it turns with the path and never about it. A closed path must lie in a plane
  /// that `up` is at right angles to. Bends must be less than 150 degrees.
  struct SweepOptions {
    Vec3 up{0, 1, 0};        ///< in the scope; not along the path's first segment
    bool closed = false;     ///< the path's last point is joined to its first
    double creaseRad = 0.7;  ///< section edges that meet at more than this are hard
    double bendRad = 0;      ///< where the path bends by less than this, it is shaded as one curve
    /// The section's size at each of the path's points, as factors > 0: masts and branches taper. Empty: 1 all along.
    std::span<const double> widths{};
  };
  void sweep(const Ring& section, std::span<const Vec3> path, const SweepOptions& options);
  void sweep(const Ring& section, std::span<const Vec3> path) { sweep(section, path, SweepOptions()); }

  /// A skin over ribs, as planks lie over the frames of a ship: each rib is a closed ring of points in the scope, all
  /// ribs have as many points, and neighbouring ribs are joined point by point. The first and the last rib are closed
  /// by flat faces, so each must lie in a plane unless it encloses nothing. Points that fall together are welded: ribs
  /// may end in a line, in a point, or fold together over a stretch. Ribs may run either way.
  ///
  ///       .--.   .---.   .--.         v runs from rib to rib, u along a rib; both are
  ///      /   /  /   /   /   |         counted where they are longest, so that a
  ///      '--'   '--'    '---'         pattern's lines follow the ribs' points
  ///
  struct SkinOptions {
    double creaseRad = 0.7;                  ///< faces that meet at more than this are hard
    std::span<const MaterialId> materials{};  ///< one for each strip between two neighbouring points; else the current one
  };
  void loft(std::span<const std::vector<Vec3>> ribs, const SkinOptions& options);
  void loft(std::span<const std::vector<Vec3>> ribs) { loft(ribs, SkinOptions()); }

  /// A skin of some thickness, like cloth or boarding: rows of as many points each, in the scope. Seen from its front,
  /// a row runs to the right and the next one lies above it; the thickness goes to the back. Smooth on both sides.
  /// Neighbouring points, rows or columns may fall together.
  void sheet(std::span<const std::vector<Vec3>> rows, double thicknessM, const SkinOptions& options);
  void sheet(std::span<const std::vector<Vec3>> rows, double thicknessM) { sheet(rows, thicknessM, SkinOptions()); }

  /// One part made by hand out of flat convex faces, each a ring of points in the scope, counter-clockwise seen from
  /// outside. Points that fall together are welded, and corners of a face that do are left out.
  class Solid {
  public:
    void face(std::initializer_list<Vec3> ring) { face(std::span(ring.begin(), ring.size())); }
    void face(std::span<const Vec3> ring);
    void face(std::span<const Vec3> ring, MaterialId material);

  private:
    friend class Builder;
    explicit Solid(Builder& builder) : builder_(builder) {}
    Builder& builder_;
    std::vector<std::uint32_t> ring_;
  };
  template <typename Body>
  void solid(Body&& body) {
    mesh().beginPart();
    Solid solid(*this);
    body(solid);
  }

  /// A surface that is known already, such as the leaves of a tree: points in the scope (m), and for each of them the
  /// normal to shade it with (unit length) and uv (m; none: zero). Triangles are counter-clockwise seen from outside. Nothing
  /// is welded or checked; what should be closed must be.
  struct Surface {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<std::array<std::uint32_t, 3>> triangles;
  };
  void surface(const Surface& surface);

  // --- Roofs over the scope's floor, see roof.h --------------------------------------------------------------------------

  Roof roofGable(const RoofOptions& options);
  Roof roofHip(const RoofOptions& options);
  Roof roofShed(const RoofOptions& options);
  Roof roofFlat(const FlatRoofOptions& options);

  // --- Instancing --------------------------------------------------------------------------------------------------------

  /// Makes a part that can be placed many times: the body draws and names into a scope of that size at the origin, in
  /// the current material. It may place other parts. Nothing appears before place().
  template <typename Body>
  PartId part(const Vec3& sizeM, Body&& body) {
    beginPart(sizeM);
    body();
    return endPart();
  }
  /// Puts a part at the scope's origin, along its axes. The scope's size does not count. Scopes that the part named
  /// are recorded for each placement.
  void place(PartId part);

private:
  struct State {
    Obb scope;
    MaterialId material = 0;
  };
  struct Placed {
    std::uint32_t mesh;
    Mat4 transform;
  };
  /// What is being drawn into: the scene itself, or a part. Its own mesh comes into being when something is first
  /// drawn.
  struct Target {
    std::unique_ptr<MeshBuilder> mesh;
    std::vector<Placed> placed;
    std::vector<Scope> scopes;
  };

  State& state() { return states_.back(); }
  [[nodiscard]] const State& state() const { return states_.back(); }
  [[nodiscard]] Vec3 toMesh(const Vec3& p) const;  // from metres in the scope
  [[nodiscard]] Vec3 directionToMesh(const Vec3& d) const;
  MeshBuilder& mesh();

  void slice(Axis axis, const Interval& piece);
  void enterFace(Face which);
  void enterSlope(const Roof& roof, std::size_t i);
  void beginPart(const Vec3& sizeM);
  PartId endPart();
  void revolve(std::span<const Vec2> profile, const Vec3& base, const Vec2& stretch, const RoundOptions& options);
  Roof slab(Roof roof, double dropM, const RoofOptions& options);

  std::vector<State> states_;
  std::vector<Target> targets_;  ///< the scene, then the parts being made, innermost last
  std::vector<Target> parts_;    ///< finished ones
  std::deque<Mesh> meshes_;      ///< a deque: MeshBuilders keep pointing at them
  std::vector<Material> materials_;
};

}  // namespace dimline
