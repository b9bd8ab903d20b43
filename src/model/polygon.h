#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/types.h"

namespace dimline {

/// A closed ring of points in a plane (metres). The last point is joined to the first one and not repeated.
using Ring = std::vector<Vec2>;

/// A flat region: one outer ring, and rings cut out of it. Rings may run either way round and may be concave; they
/// must not cross themselves or each other, and holes lie inside the outer ring without touching it.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// The area inside the ring, positive when it runs counter-clockwise (x right, y up).
double signedArea(std::span<const Vec2> ring);

/// The axis-aligned rectangle between two corners, counter-clockwise from `min`.
Ring rectangleRing(const Vec2& min, const Vec2& max);

/// An ellipse of that many sides (>= 3), counter-clockwise; the first point lies at `startRad` from +x.
Ring ellipseRing(const Vec2& center, const Vec2& radius, int sides, double startRad = 0);

/// Makes the outer ring counter-clockwise and the holes clockwise: the region then lies to the left of every edge.
void orient(Polygon& polygon);

/// The ring moved outwards by `distanceM` (inwards when negative) with mitred corners. Edges that shrink to nothing
/// are dropped. Empty when nothing is left, or when the ring would fall apart into several. The result runs
/// counter-clockwise.
///
///      +-----------+          +-----------+
///      |           |          | +-------+ |     offset(ring, -d): the inner ring
///      |           |    ->    | |       | |
///      +-----------+          +-----------+
Ring offset(std::span<const Vec2> ring, double distanceM);

/// Outward normals at the two ends of each edge of a counter-clockwise ring, for shading: where the ring bends by
/// less than `creaseRad`, neighbouring edges share their mean. Parallel to the ring; points must not repeat.
struct EdgeNormals {
  Vec2 start, end;
};
std::vector<EdgeNormals> edgeNormals(std::span<const Vec2> ring, double creaseRad);

/// The region cut into triangles, each counter-clockwise. Indices count the outer ring's points first and then those
/// of the holes, in order. Exactly these points are used, each ring edge belongs to one triangle, and no triangle is
/// flat, so the triangulation of a polygon can be one side of a closed solid. `polygon` must be oriented (see
/// orient).
std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon);

}  // namespace dimline
