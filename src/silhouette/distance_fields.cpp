#include "silhouette/distance_fields.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "silhouette/float4.h"

namespace dimline {

namespace {

/// Two nodes of the tree side by side, as they lie in memory: least, greatest, least, greatest.
float* pairAt(DistanceField::Range* tree, std::size_t node) { return reinterpret_cast<float*>(tree + node); }

/// Copies strips' values to their leaves, four at a time.
void writeLeaves(const float* values, DistanceField::Range* leaves, std::size_t firstStrip, std::size_t lastStrip) {
  for (std::size_t i = firstStrip / 4 * 4; i <= lastStrip; i += 4) {
    const Float4 four = load4(values + i);
    store4(pairAt(leaves, i), pick4<0, 4, 1, 5>(four, four));
    store4(pairAt(leaves, i + 2), pick4<2, 6, 3, 7>(four, four));
  }
}

/// Joins children to the nodes [low, high] of one level, two nodes at a time; the level has two nodes at least.
void joinLevel(DistanceField::Range* tree, std::size_t low, std::size_t high) {
  for (std::size_t i = low / 2 * 2; i <= high; i += 2) {
    const Float4 first = load4(pairAt(tree, 2 * i));
    const Float4 second = load4(pairAt(tree, 2 * i + 2));
    const Float4 even = pick4<0, 1, 4, 5>(first, second);
    const Float4 odd = pick4<2, 3, 6, 7>(first, second);
    store4(pairAt(tree, i), pick4<0, 5, 2, 7>(min4(even, odd), max4(even, odd)));
  }
}

/// A screen point as one field sees it: `along` its strips, and `away` from its viewport edge.
struct EdgePoint {
  double along;
  double away;
};

EdgePoint seenFrom(ViewportEdge edge, const DistanceFields& fields, const Vec2& p) {
  switch (edge) {
    case ViewportEdge::kLeft:
      return {p.y, p.x};
    case ViewportEdge::kRight:
      return {p.y, fields.widthPx - p.x};
    case ViewportEdge::kTop:
      return {p.x, p.y};
    case ViewportEdge::kBottom:
      return {p.x, fields.heightPx - p.y};
  }
  return {};
}

/// The strips that [low, high] along an edge has more than a touch in common with; one at least. The range lies in
/// the field.
struct Strips {
  std::size_t first;
  std::size_t last;
};

Strips stripsOf(const DistanceField& field, double low, double high) {
  const double end = static_cast<double>(field.size()) - 1;
  const double first = std::clamp(std::floor(low), 0.0, end);
  const double last = std::clamp(std::ceil(high) - 1, first, end);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

/// Whether a segment stays between its viewport edge and the field, by descending where the tree leaves that open.
class SegmentTest {
public:
  SegmentTest(const DistanceField& field, EdgePoint a, EdgePoint b) : field_(field), from_(a), to_(b) {
    if (from_.along > to_.along) std::swap(from_, to_);
    const double run = to_.along - from_.along;
    slope_ = run > 0 ? (to_.away - from_.away) / run : 0.0;
    strips_ = stripsOf(field, from_.along, to_.along);
  }

  [[nodiscard]] bool clear() const { return clear(1, 0, field_.leafCount()); }

private:
  /// The segment's distance from the viewport edge at a place along it, its own ends being exact.
  [[nodiscard]] double awayAt(double along) const {
    if (along <= from_.along) return from_.away;
    return along >= to_.along ? to_.away : from_.away + (along - from_.along) * slope_;
  }

  /// The node stands over the strips [first, first + count).
  [[nodiscard]] bool clear(std::size_t index, std::size_t first, std::size_t count) const {
    if (first > strips_.last || first + count <= strips_.first) return true;
    double low = awayAt(static_cast<double>(first));
    double high = awayAt(static_cast<double>(first + count));
    // A segment within one strip need not be a function of the place along the edge.
    if (strips_.first == strips_.last) low = from_.away, high = to_.away;
    if (low > high) std::swap(low, high);
    const DistanceField::Range& node = field_.node(index);
    if (high <= node.min) return true;
    if (count == 1 || low > node.max) return false;
    return clear(2 * index, first, count / 2) && clear(2 * index + 1, first + count / 2, count / 2);
  }

  const DistanceField& field_;
  EdgePoint from_;
  EdgePoint to_;
  double slope_ = 0;
  Strips strips_{0, 0};
};

bool inViewport(const DistanceFields& fields, const Vec2& p) {
  return p.x >= 0 && p.y >= 0 && p.x <= fields.widthPx && p.y <= fields.heightPx;
}

}  // namespace

void DistanceField::reset(std::size_t strips) {
  size_ = strips;
  leafCount_ = std::bit_ceil(std::max<std::size_t>(strips, 16));
  values_.assign(size_ + 3, kNoSilhouette);
  tree_.assign(2 * leafCount_, Range{});
}

void DistanceField::buildTree() {
  if (size_ > 0) mendTree(0, size_ - 1);
}

void DistanceField::mendTree(std::size_t first, std::size_t last) {
  if (first >= size_ || last < first) return;
  last = std::min(last, size_ - 1);
  writeLeaves(values_.data(), tree_.data() + leafCount_, first, last);
  std::size_t low = (leafCount_ + first) / 2;
  std::size_t high = (leafCount_ + last) / 2;
  for (; low > 1; low /= 2, high /= 2) joinLevel(tree_.data(), low, high);
  tree_[1] = {std::min(tree_[2].min, tree_[3].min), std::max(tree_[2].max, tree_[3].max)};
}

float DistanceField::min(std::size_t first, std::size_t last) const {
  assert(first <= last && last < size_);
  float least = kNoSilhouette;
  std::size_t low = leafCount_ + first;
  std::size_t end = leafCount_ + last + 1;
  for (; low < end; low /= 2, end /= 2) {
    if (low % 2 == 1) least = std::min(least, tree_[low++].min);
    if (end % 2 == 1) least = std::min(least, tree_[--end].min);
  }
  return least;
}

float DistanceField::max(std::size_t first, std::size_t last) const {
  assert(first <= last && last < size_);
  float greatest = -kNoSilhouette;
  std::size_t low = leafCount_ + first;
  std::size_t end = leafCount_ + last + 1;
  for (; low < end; low /= 2, end /= 2) {
    if (low % 2 == 1) greatest = std::max(greatest, tree_[low++].max);
    if (end % 2 == 1) greatest = std::max(greatest, tree_[--end].max);
  }
  return greatest;
}

void DistanceFields::reset(int width, int height) {
  assert(width >= 1 && height >= 1);
  widthPx = width;
  heightPx = height;
  for (const ViewportEdge edge : {ViewportEdge::kLeft, ViewportEdge::kRight})
    (*this)[edge].reset(static_cast<std::size_t>(height));
  for (const ViewportEdge edge : {ViewportEdge::kTop, ViewportEdge::kBottom})
    (*this)[edge].reset(static_cast<std::size_t>(width));
}

void DistanceFields::buildTrees() {
  for (DistanceField& field : fields) field.buildTree();
}

bool clears(const DistanceFields& fields, const Box2& box) {
  if (!inViewport(fields, box.min) || !inViewport(fields, box.max)) return false;
  for (const ViewportEdge edge : kViewportEdges) {
    const EdgePoint a = seenFrom(edge, fields, box.min);
    const EdgePoint b = seenFrom(edge, fields, box.max);
    const Strips strips = stripsOf(fields[edge], a.along, b.along);
    if (std::max(a.away, b.away) <= fields[edge].min(strips.first, strips.last)) return true;
  }
  return false;
}

bool clears(const DistanceFields& fields, ViewportEdge edge, const Segment2& segment) {
  if (!inViewport(fields, segment.start) || !inViewport(fields, segment.end)) return false;
  return SegmentTest(fields[edge], seenFrom(edge, fields, segment.start), seenFrom(edge, fields, segment.end)).clear();
}

}  // namespace dimline
