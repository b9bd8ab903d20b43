#include "silhouette/distance_fields.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "silhouette/float4.h"

namespace dimline {

namespace {

/// The values of a block's strips folded into one, four at a time.
template <typename Fold>
float foldBlock(const float* values, Fold fold) {
  Float4 four = load4(values);
  for (std::size_t i = 4; i < DistanceField::kBlockStrips; i += 4) four = fold(four, load4(values + i));
  four = fold(four, pick4<2, 3, 0, 1>(four, four));
  return fold(four, pick4<1, 0, 3, 2>(four, four))[0];
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

  [[nodiscard]] bool clear() const { return clear(1, 0, field_.leafCount() * DistanceField::kBlockStrips); }

private:
  /// The segment's distance from the viewport edge at a place along it, its own ends being exact.
  [[nodiscard]] double awayAt(double along) const {
    if (along <= from_.along) return from_.away;
    return along >= to_.along ? to_.away : from_.away + (along - from_.along) * slope_;
  }

  /// The segment's least and greatest distance from the viewport edge over the strips [first, first + count).
  [[nodiscard]] std::pair<double, double> awayOver(std::size_t first, std::size_t count) const {
    // A segment within one strip need not be a function of the place along the edge.
    if (strips_.first == strips_.last) return std::minmax({from_.away, to_.away});
    return std::minmax({awayAt(static_cast<double>(first)), awayAt(static_cast<double>(first + count))});
  }

  /// The node stands over the strips [first, first + count).
  [[nodiscard]] bool clear(std::size_t node, std::size_t first, std::size_t count) const {
    if (first > strips_.last || first + count <= strips_.first) return true;
    const auto [low, high] = awayOver(first, count);
    if (high <= field_.least(node)) return true;
    if (low > field_.greatest(node)) return false;
    if (count == DistanceField::kBlockStrips) return clearOneByOne(std::max(first, strips_.first), std::min(first + count - 1, strips_.last));
    return clear(2 * node, first, count / 2) && clear(2 * node + 1, first + count / 2, count / 2);
  }

  [[nodiscard]] bool clearOneByOne(std::size_t first, std::size_t last) const {
    for (std::size_t strip = first; strip <= last; ++strip) {
      if (awayOver(strip, 1).second > field_.at(strip)) return false;
    }
    return true;
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
  constexpr std::size_t kReadBeyond = 3;
  const std::size_t blocks = (std::max<std::size_t>(strips, 1) + kBlockStrips - 1) / kBlockStrips;
  size_ = strips;
  leafCount_ = std::bit_ceil(blocks);
  values_.assign(blocks * kBlockStrips + kReadBeyond, kNoSilhouette);
  least_.assign(2 * leafCount_ + kReadBeyond, kNoSilhouette);
  greatest_.assign(2 * leafCount_, kNoSilhouette);
}

void DistanceField::buildTree() {
  if (size_ > 0) mendTree(0, size_ - 1);
}

void DistanceField::mendTree(std::size_t first, std::size_t last) {
  if (first >= size_ || last < first) return;
  std::size_t low = leafCount_ + first / kBlockStrips;
  std::size_t high = leafCount_ + std::min(last, size_ - 1) / kBlockStrips;
  for (std::size_t leaf = low; leaf <= high; ++leaf) {
    const float* block = values_.data() + (leaf - leafCount_) * kBlockStrips;
    least_[leaf] = foldBlock(block, min4);
    greatest_[leaf] = foldBlock(block, max4);
  }
  for (low /= 2, high /= 2; low > 0; low /= 2, high /= 2) {
    for (std::size_t node = low; node <= high; ++node) {
      least_[node] = std::min(least_[2 * node], least_[2 * node + 1]);
      greatest_[node] = std::max(greatest_[2 * node], greatest_[2 * node + 1]);
    }
  }
}

float DistanceField::min(std::size_t first, std::size_t last) const {
  assert(first <= last && last < size_);
  const auto leastFrom = [](const std::vector<float>& of, std::size_t from, std::size_t end, float least) {
    return std::accumulate(of.begin() + static_cast<std::ptrdiff_t>(from), of.begin() + static_cast<std::ptrdiff_t>(end), least, [](float a, float b) { return std::min(a, b); });
  };
  const std::size_t block = (first + kBlockStrips - 1) / kBlockStrips, blocksEnd = (last + 1) / kBlockStrips;   // whole blocks
  if (block >= blocksEnd) return leastFrom(values_, first, last + 1, kNoSilhouette);
  float least = leastFrom(values_, first, block * kBlockStrips, kNoSilhouette);
  least = leastFrom(least_, leafCount_ + block, leafCount_ + blocksEnd, least);
  return leastFrom(values_, blocksEnd * kBlockStrips, last + 1, least);
}

float DistanceField::greatestOfBlocks(std::size_t first, std::size_t last) const {
  assert(first <= last && last < size_);
  const auto* leaves = greatest_.data() + leafCount_;
  return *std::max_element(leaves + first / kBlockStrips, leaves + last / kBlockStrips + 1);
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

bool isBlocked(const DistanceFields& fields, ViewportEdge edge, const Vec2& p) {
  const EdgePoint seen = seenFrom(edge, fields, p);
  return seen.away > fields[edge].at(std::min(static_cast<std::size_t>(seen.along), fields[edge].size() - 1));
}

}  // namespace dimline
