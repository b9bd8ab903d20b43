// The query works in homogeneous coordinates of the sliding plane. A screen point q has there
//
//     U = uForm . q      V = (wForm - uForm) . q      T = tForm . q      W = U + V = wForm . q
//
// and it lies in the wedge between the extension lines exactly when U, V and T are all >= 0. W >= 0 follows; W = 0 is the horizon.
// Its offset is t = T / W. To ask only for points beyond an offset b, T is replaced by G = T - b W: a point of the wedge
// lies beyond b exactly when G > 0. So "can this box beat the best offset so far" is three half-planes against a box, without a division.
// t is a quotient of linear functions, so on a convex polygon that does not pass the horizon it is greatest at a vertex; a strip's box is
// clipped exactly, in double precision.
//
// The tree is not walked node by node. Its level of 16 strips a node is swept four nodes at a time, then the strips of those that pass,
// four at a time: a vector step costs about what a visit to one node does. Two things keep the exact clipping down to a few strips: the
// most promising one comes first, and what would not raise the best offset by kNegligiblePx on screen is passed over (a line
// parallel to a flat roof would have all of its strips tie).
//
// Of the four fields, mostly one has the answer. For the others a point of the wedge beyond that answer is tried: when a field blocks it, the
// field's own answer is greater, and no search is needed.

#include "silhouette/slide.h"

#include <cassert>
#include <cmath>

#include "silhouette/float4.h"

namespace dimline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthest = std::numeric_limits<double>::max();

/// Sine of the angle below which line and `across` are parallel, or the plane is seen edge-on. Far below what placement accepts
/// (kEdgeOnAngleRad): here it only keeps the inverse accurate to about 1e-9.
constexpr double kDegenerateSine = 1e-6;

/// Points seen this close to the plane's horizon (the base line's depth over theirs) count as on it. Rounding reaches about 1e-9.
constexpr double kHorizon = 1e-7;

/// px. What would move the line by less is not looked for. More than the rounding of the vector steps' floats, some 1e-3 px at 4K.
constexpr double kNegligiblePx = 5e-3;

/// Strips to a block: the level of the tree that is swept.
constexpr std::size_t kBlock = 16;

/// A linear form over a field's own coordinates: `away` from its viewport edge, and `along` its strips.
struct Form {
  double away;
  double along;
  double constant;

  [[nodiscard]] double at(double awayPx, double alongPx) const { return away * awayPx + along * alongPx + constant; }
  /// Change over a pixel, at most.
  [[nodiscard]] double steepness() const { return std::abs(away) + std::abs(along); }
};

Form operator-(const Form& a, const Form& b) { return {a.away - b.away, a.along - b.along, a.constant - b.constant}; }
Form operator*(const Form& a, double s) { return {a.away * s, a.along * s, a.constant * s}; }

Form seenFrom(ViewportEdge edge, const DistanceFields& fields, const Vec3& form) {
  switch (edge) {
    case ViewportEdge::kLeft: return {form.x, form.y, form.z};
    case ViewportEdge::kRight: return {-form.x, form.y, form.z + form.x * fields.widthPx};
    case ViewportEdge::kTop: return {form.y, form.x, form.z};
    case ViewportEdge::kBottom: return {-form.y, form.x, form.z + form.y * fields.heightPx};
  }
  return {};
}

/// A convex polygon in a field's coordinates: a rectangle cut by three half-planes, so of at most seven corners.
struct Polygon {
  struct Corner {
    double away, along;
  };
  std::array<Corner, 8> corners;
  std::size_t count = 0;

  Polygon(double awayLow, double awayHigh, double alongLow, double alongHigh)
      : corners{{{awayLow, alongLow}, {awayHigh, alongLow}, {awayHigh, alongHigh}, {awayLow, alongHigh}}}, count(4) {}

  /// Keeps the part where the form is >= 0.
  void cut(const Form& form) {
    std::array<double, 8> at;
    bool whole = true;
    for (std::size_t i = 0; i < count; ++i) {
      at[i] = form.at(corners[i].away, corners[i].along);
      whole = whole && at[i] >= 0;
    }
    if (whole) return;
    const std::array<Corner, 8> before = corners;
    const std::size_t beforeCount = count;
    count = 0;
    for (std::size_t i = 0; i < beforeCount; ++i) {
      const std::size_t next = i + 1 == beforeCount ? 0 : i + 1;
      if (at[i] >= 0) corners[count++] = before[i];
      if ((at[i] >= 0) != (at[next] >= 0)) {
        const double share = at[i] / (at[i] - at[next]);
        corners[count++] = {before[i].away + (before[next].away - before[i].away) * share,
                            before[i].along + (before[next].along - before[i].along) * share};
      }
    }
  }
};

/// Where a polygon lies.
struct Range {
  double awayLow = kInfinity, awayHigh = -kInfinity;
  double alongLow = kInfinity, alongHigh = -kInfinity;
  double edgeLow = kInfinity, edgeHigh = -kInfinity;   ///< along the viewport edge itself; low > high when it is not met

  explicit Range(const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const auto& [away, along] = polygon.corners[i];
      awayLow = std::min(awayLow, away);
      awayHigh = std::max(awayHigh, away);
      alongLow = std::min(alongLow, along);
      alongHigh = std::max(alongHigh, along);
      if (away > 0) continue;
      edgeLow = std::min(edgeLow, along);
      edgeHigh = std::max(edgeHigh, along);
    }
  }
};

/// The wedge in one field's coordinates.
struct Wedge {
  Form u, v, w, t;

  Wedge(const DistanceFields& fields, ViewportEdge edge, const Slide& slide)
      : u(seenFrom(edge, fields, slide.uForm())),
        v(seenFrom(edge, fields, slide.wForm() - slide.uForm())),
        w(seenFrom(edge, fields, slide.wForm())),
        t(seenFrom(edge, fields, slide.tForm())) {}

  /// > 0 beyond an offset.
  [[nodiscard]] Form beyond(double offsetM) const { return t - w * offsetM; }
};

/// Lane by lane, the greatest value of a form over boxes: from `away` in to a common end, and from `along` on over a common width.
struct GreatestOverBox {
  Float4 perAway;
  Float4 perAlong;
  Float4 constant;

  GreatestOverBox(const Form& form, double awayHigh, double width, double marginPx)
      : perAway(splat4(static_cast<float>(std::min(form.away, 0.0)))),
        perAlong(splat4(static_cast<float>(form.along))),
        constant(splat4(static_cast<float>(form.constant + std::max(form.away, 0.0) * awayHigh + std::max(form.along, 0.0) * width +
                                           form.steepness() * marginPx))) {}

  [[nodiscard]] Float4 at(Float4 away, Float4 along) const { return perAway * away + perAlong * along + constant; }
};

/// The lines between which the wedge lies, as bounds of `away` over the place along: lane by lane, and only roughly.
class Banks {
 public:
  Banks(const Wedge& wedge, const Range& range) : low_(splat4(static_cast<float>(range.awayLow))), high_(splat4(static_cast<float>(range.awayHigh))) {
    for (const Form* form : {&wedge.u, &wedge.v}) {
      // A bank that runs nearly straight away bounds no distance.
      if (std::abs(form->away) < 1e-4 * std::abs(form->along)) continue;
      Line& line = form->away > 0 ? lower_[lowers_++] : upper_[uppers_++];
      line = {splat4(static_cast<float>(-form->along / form->away)), splat4(static_cast<float>(-form->constant / form->away))};
    }
  }

  [[nodiscard]] Float4 low(Float4 along) const {
    Float4 low = low_;
    for (std::size_t i = 0; i < lowers_; ++i) low = max4(low, lower_[i].at(along));
    return low;
  }
  [[nodiscard]] Float4 high(Float4 along) const {
    Float4 high = high_;
    for (std::size_t i = 0; i < uppers_; ++i) high = min4(high, upper_[i].at(along));
    return high;
  }

 private:
  struct Line {
    Float4 slope;
    Float4 constant;
    [[nodiscard]] Float4 at(Float4 along) const { return slope * along + constant; }
  };
  Float4 low_;
  Float4 high_;
  std::array<Line, 2> lower_;
  std::array<Line, 2> upper_;
  std::size_t lowers_ = 0;
  std::size_t uppers_ = 0;
};

/// Boxes in lots of four against the wedge beyond an offset. A box covers some strips, and reaches from a value of its own in.
class BoxFilter {
 public:
  BoxFilter(const Wedge& wedge, const Range& range, double width, double offsetM)
      : awayLow_(splat4(static_cast<float>(range.awayLow - kNegligiblePx))),
        awayHigh_(splat4(static_cast<float>(range.awayHigh + kNegligiblePx))),
        alongLow_(splat4(static_cast<float>(range.alongLow - width - kNegligiblePx))),
        alongHigh_(splat4(static_cast<float>(range.alongHigh + kNegligiblePx))),
        u_(wedge.u, range.awayHigh, width, kNegligiblePx),
        v_(wedge.v, range.awayHigh, width, kNegligiblePx),
        g_(wedge.beyond(offsetM), range.awayHigh, width, -kNegligiblePx) {}

  /// Whether a box may hold something beyond the offset by more than kNegligiblePx: never wrongly no.
  [[nodiscard]] Int4 passes(Float4 value, Float4 along) const {
    const Float4 away = max4(value, awayLow_);
    return (away <= awayHigh_) & (along >= alongLow_) & (along <= alongHigh_) & (u_.at(away, along) >= 0.0F) & (v_.at(away, along) >= 0.0F) &
           (g_.at(away, along) > 0.0F);
  }

 private:
  Float4 awayLow_;
  Float4 awayHigh_;
  Float4 alongLow_;
  Float4 alongHigh_;
  GreatestOverBox u_;
  GreatestOverBox v_;
  GreatestOverBox g_;
};

/// One field, one slide: the search for the greatest offset over what the field blocks in the wedge.
class Search {
 public:
  Search(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields, const Slide& slide)
      : field_(field), extentPx_(fields.extentPx(edge)), wedge_(fields, edge, slide) {}

  double run(double uselessAboveM) {
    if (!(field_.node(1).min < extentPx_)) return 0;   // there is nothing to be seen
    enoughM_ = std::min(uselessAboveM, kFarthest);
    const Polygon all = beyond(0);
    if (all.count == 0) return 0;
    range_ = Range(all);
    if (touchesViewportEdge(range_)) return kInfinity;
    sweep();
    return best_;
  }

 private:
  /// The part of the viewport in the wedge beyond an offset.
  [[nodiscard]] Polygon beyond(double offsetM) const {
    Polygon polygon(0, extentPx_, 0, static_cast<double>(field_.size()));
    polygon.cut(wedge_.u);
    polygon.cut(wedge_.v);
    polygon.cut(wedge_.beyond(offsetM));
    return polygon;
  }

  [[nodiscard]] std::size_t stripAt(double along) const {
    return static_cast<std::size_t>(std::clamp(along, 0.0, static_cast<double>(field_.size()) - 1));
  }

  /// Whether a strip of value <= 0 meets the viewport edge inside the wedge.
  [[nodiscard]] bool touchesViewportEdge(const Range& range) const {
    if (field_.node(1).min > 0 || range.edgeLow > range.edgeHigh) return false;
    return field_.min(stripAt(range.edgeLow), stripAt(range.edgeHigh)) <= 0;
  }

  /// Raises the best offset over all that the range encloses, until it is more than enough.
  void sweep() {
    const Banks banks(wedge_, range_);
    const std::size_t first = stripAt(range_.alongLow);
    const std::size_t last = stripAt(range_.alongHigh);
    const std::size_t level = field_.leafCount() / kBlock;
    sweepBoxes(
        banks, first / kBlock, last / kBlock, kBlock,
        [&](std::size_t block) {
          const DistanceField::Range* node = &field_.node(level + block);
          return Float4{node[0].min, node[1].min, node[2].min, node[3].min};
        },
        [&](std::size_t block) {
          sweepBoxes(
              banks, std::max(first, block * kBlock), std::min(last, block * kBlock + kBlock - 1), 1,
              [&](std::size_t strip) { return load4(field_.values().data() + strip); }, [&](std::size_t strip) { improve(strip); });
        });
  }

  /// Visits the boxes from first to last, each `width` strips wide, that may raise the best offset: the most promising one first.
  template <typename ValuesFrom, typename Visit>
  void sweepBoxes(const Banks& banks, std::size_t first, std::size_t last, std::size_t width, ValuesFrom valuesFrom, Visit visit) {
    const double widthPx = static_cast<double>(width);
    const auto alongFrom = [&](std::size_t box) { return (splat4(static_cast<float>(box)) + kLanes) * static_cast<float>(widthPx); };
    const auto inLast = [&](std::size_t box) { return splat4(static_cast<float>(box)) + kLanes <= static_cast<float>(last); };
    BoxFilter filter(wedge_, range_, widthPx, best_);
    std::size_t promising = last + 1;
    float most = -kNoSilhouette;
    for (std::size_t box = first; box <= last; box += 4) {
      const Int4 passes = filter.passes(valuesFrom(box), alongFrom(box)) & inLast(box);
      if (!any(passes)) continue;
      const Float4 promise = promiseOf(banks, valuesFrom(box), alongFrom(box), widthPx);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (passes[lane] == 0 || !(promise[lane] > most)) continue;
        most = promise[lane];
        promising = box + lane;
      }
    }
    if (promising > last) return;
    double filteredM = best_;
    visit(promising);
    for (std::size_t box = first; box <= last && best_ <= enoughM_; box += 4) {
      if (best_ > filteredM) {
        filter = BoxFilter(wedge_, range_, widthPx, best_);
        filteredM = best_;
      }
      const Int4 passes = filter.passes(valuesFrom(box), alongFrom(box)) & inLast(box);
      if (!any(passes)) continue;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (passes[lane] != 0 && box + lane != promising) visit(box + lane);
      }
    }
  }

  /// About the greatest offset in each of four boxes, by which the first to visit is chosen: at the middle of the box's width, there where the
  /// box, cut by the wedge's banks, begins or ends.
  [[nodiscard]] Float4 promiseOf(const Banks& banks, Float4 value, Float4 along, double width) const {
    const Float4 middle = max4(min4(along + static_cast<float>(width * 0.5), splat4(static_cast<float>(range_.alongHigh))), splat4(static_cast<float>(range_.alongLow)));
    const Float4 low = max4(value, banks.low(middle));
    const Float4 high = max4(low, banks.high(middle));
    return max4(roughOffset(low, middle), roughOffset(high, middle));
  }

  [[nodiscard]] Float4 roughOffset(Float4 away, Float4 along) const {
    const auto at = [&](const Form& form) {
      return static_cast<float>(form.away) * away + static_cast<float>(form.along) * along + static_cast<float>(form.constant);
    };
    return at(wedge_.t) / max4(at(wedge_.w), splat4(static_cast<float>(kHorizon)));
  }

  /// Raises the best offset to the greatest in one strip's box.
  void improve(std::size_t strip) {
    const double low = static_cast<double>(strip);
    Polygon polygon(std::max(0.0, static_cast<double>(field_.at(strip))), extentPx_, low, low + 1);
    polygon.cut(wedge_.u);
    polygon.cut(wedge_.v);
    const double before = best_;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const auto& [away, along] = polygon.corners[i];
      const double w = wedge_.w.at(away, along);
      const double t = wedge_.t.at(away, along);
      if (t > best_ * w) best_ = w > kHorizon ? t / w : kInfinity;
    }
    // Only what lies beyond matters from now on.
    if (best_ > before && best_ <= enoughM_) range_ = Range(beyond(best_));
  }

  const DistanceField& field_;
  double extentPx_;
  Wedge wedge_;
  Range range_{Polygon(0, 0, 0, 0)};
  double best_ = 0;
  double enoughM_ = kFarthest;
};

/// A point of the viewport inside the wedge beyond an offset, if there is one.
std::optional<Vec2> pointBeyond(const DistanceFields& fields, const Slide& slide, double offsetM) {
  const Wedge wedge(fields, ViewportEdge::kLeft, slide);
  Polygon polygon(0, fields.widthPx, 0, fields.heightPx);
  polygon.cut(wedge.u);
  polygon.cut(wedge.v);
  polygon.cut(wedge.beyond(offsetM));
  if (polygon.count == 0) return std::nullopt;
  Vec2 sum(0.0);
  for (std::size_t i = 0; i < polygon.count; ++i) sum += Vec2(polygon.corners[i].away, polygon.corners[i].along);
  return sum / static_cast<double>(polygon.count);
}

/// Whether a field blocks a point of the viewport.
bool blocks(const DistanceFields& fields, ViewportEdge edge, const Vec2& p) {
  const bool rows = edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight;
  const double along = rows ? p.y : p.x;
  const double across = rows ? p.x : p.y;
  const bool fromHigh = edge == ViewportEdge::kRight || edge == ViewportEdge::kBottom;
  const double away = fromHigh ? fields.extentPx(edge) - across : across;
  const std::size_t last = fields[edge].size() - 1;
  return away > fields[edge].at(std::min(static_cast<std::size_t>(along), last));
}

}  // namespace

std::optional<Slide> Slide::make(const View& view, const Segment& base, const Vec3& across) {
  assert(std::abs(glm::length(across) - 1) < 1e-6);
  if (!view.inFrontOfNear(base.start) || !view.inFrontOfNear(base.end)) return std::nullopt;
  const Vec3 along = base.end - base.start;
  const Vec3 normal = glm::cross(along, across);
  const double area = glm::length(normal);
  if (!(area > kDegenerateSine * glm::length(along))) return std::nullopt;
  if (!(std::abs(glm::dot(normal, view.directionTo(base.middle()))) > kDegenerateSine * area)) return std::nullopt;

  // (u, t, 1) -> homogeneous pixel is the matrix [perU perT origin]; the rows of its inverse are cross products.
  const Vec3 perU = view.worldToPixels() * Vec4(along, 0.0);
  const Vec3 perT = view.worldToPixels() * Vec4(across, 0.0);
  const Vec3 origin = view.worldToPixels() * Vec4(base.start, 1.0);
  const double determinant = glm::dot(perU, glm::cross(perT, origin));
  const double scale = std::max(origin.z, origin.z + perU.z) / determinant;
  if (!std::isfinite(scale)) return std::nullopt;

  Slide slide;
  slide.base_ = base;
  slide.across_ = across;
  slide.uForm_ = glm::cross(perT, origin) * scale;
  slide.tForm_ = glm::cross(origin, perU) * scale;
  slide.wForm_ = glm::cross(perU, perT) * scale;
  const Vec3 middle = origin + perU * 0.5;
  slide.setOffPx_ = (Vec2(perT.x, perT.y) - Vec2(middle.x, middle.y) * (perT.z / middle.z)) / middle.z;
  return slide;
}

double leastClearingOffset(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields, const Slide& slide,
                           double uselessAboveM) {
  return Search(field, edge, fields, slide).run(uselessAboveM);
}

double leastClearingOffset(const DistanceFields& fields, const Slide& slide, double uselessAboveM) {
  // The field that the line sets off towards most often has the answer.
  const Vec2& way = slide.setOffPx();
  const ViewportEdge alongX = way.x < 0 ? ViewportEdge::kLeft : ViewportEdge::kRight;
  const ViewportEdge alongY = way.y < 0 ? ViewportEdge::kTop : ViewportEdge::kBottom;
  const bool xFirst = std::abs(way.x) > std::abs(way.y);
  const auto opposite = [](ViewportEdge edge) { return static_cast<ViewportEdge>(static_cast<unsigned>(edge) ^ 1U); };
  double least = kInfinity;
  std::optional<Vec2> probe;
  for (const ViewportEdge edge : {xFirst ? alongX : alongY, xFirst ? alongY : alongX, opposite(xFirst ? alongY : alongX),
                                  opposite(xFirst ? alongX : alongY)}) {
    if (probe && blocks(fields, edge, *probe)) continue;
    const double boundM = std::min(least, uselessAboveM);
    const double offsetM = leastClearingOffset(fields[edge], edge, fields, slide, boundM);
    if (!(offsetM < boundM)) continue;
    least = offsetM;
    probe = pointBeyond(fields, slide, least);
  }
  return least;
}

}  // namespace dimline
