// The query works in homogeneous coordinates of the sliding plane. A screen point q has there
//
//     U = uForm . q      V = (wForm - uForm) . q      T = tForm . q      W = U + V = wForm . q
//
// and it lies in the wedge between the extension lines exactly when U, V and T are all >= 0. W >= 0 follows; W = 0 is
// the horizon. Its offset is t = T / W. To ask only for points beyond an offset b, T is replaced by G = T - b W: a
// point of the wedge lies beyond b exactly when G > 0. So "can this box beat the best offset so far" is three
// half-planes against a box, without a division. t is a quotient of linear functions, so on a convex polygon that
// does not pass the horizon it is greatest at a vertex; a strip's box is clipped exactly, in double precision.
//
// The tree is not walked node by node. Its blocks are swept four at a time, then the strips of those that pass, four
// at a time: a vector step costs about what a visit to one node does. Two things keep the exact clipping down to a few
// strips: the most promising one comes first, and what would not raise the best offset by kNegligiblePx on screen is
// passed over (a line parallel to a flat roof would have all of its strips tie).
//
// Of the four fields, mostly one has the answer. For the others a point of the wedge beyond that answer is tried:
// when a field blocks it, the field's own answer is greater, and no search is needed.

#include "silhouette/slide.h"

#include <cassert>
#include <cmath>

#include "silhouette/float4.h"

namespace dimline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthest = std::numeric_limits<double>::max();

/// Sine of the angle below which line and `across` are parallel, or the plane is seen edge-on. Far below what
/// placement accepts (kEdgeOnAngleRad): here it only keeps the inverse accurate to about 1e-9.
constexpr double kDegenerateSine = 1e-6;

/// Points seen this close to the plane's horizon (the base line's depth over theirs) count as on it. Rounding reaches
/// about 1e-9.
constexpr double kHorizon = 1e-7;

/// px. What would move the line by less is not looked for. More than the rounding of the vector steps' floats, some
/// 1e-3 px at 4K.
constexpr double kNegligiblePx = 5e-3;

constexpr std::size_t kBlockStrips = DistanceField::kBlockStrips;

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
    case ViewportEdge::kLeft:
      return {form.x, form.y, form.z};
    case ViewportEdge::kRight:
      return {-form.x, form.y, form.z + form.x * fields.widthPx};
    case ViewportEdge::kTop:
      return {form.y, form.x, form.z};
    case ViewportEdge::kBottom:
      return {-form.y, form.x, form.z + form.y * fields.heightPx};
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

/// A homogeneous pixel in a field's own coordinates: x is away, y along.
Vec3 seenPixel(ViewportEdge edge, const DistanceFields& fields, const Vec3& pixel) {
  switch (edge) {
    case ViewportEdge::kLeft:
      return pixel;
    case ViewportEdge::kRight:
      return {fields.widthPx * pixel.z - pixel.x, pixel.y, pixel.z};
    case ViewportEdge::kTop:
      return {pixel.y, pixel.x, pixel.z};
    case ViewportEdge::kBottom:
      return {fields.heightPx * pixel.z - pixel.y, pixel.x, pixel.z};
  }
  return {};
}

/// A box in a field's coordinates; kFar where it has no end.
struct Range {
  static constexpr double kFar = 1e9;
  double awayLow = -kFar, awayHigh = kFar;
  double alongLow = -kFar, alongHigh = kFar;
};

/// A slide in one field's coordinates.
class Wedge {
public:
  Form u, v, w, t;  ///< the forms U, V, W and T

  Wedge(const DistanceFields& fields, ViewportEdge edge, const Slide& slide)
      : u(seenFrom(edge, fields, slide.uForm())),
        v(seenFrom(edge, fields, slide.wForm() - slide.uForm())),
        w(seenFrom(edge, fields, slide.wForm())),
        t(seenFrom(edge, fields, slide.tForm())),
        origin_(seenPixel(edge, fields, slide.originPixel())),
        perU_(seenPixel(edge, fields, slide.pixelPerU())),
        perT_(seenPixel(edge, fields, slide.pixelPerT())) {}

  /// The form G: > 0 beyond an offset.
  [[nodiscard]] Form beyond(double offsetM) const { return t - w * offsetM; }

  /// A box around all of the wedge that lies beyond an offset: from the line there to where the extension lines meet,
  /// or without end.
  [[nodiscard]] Range rangeBeyond(double offsetM) const {
    const Vec3 start = origin_ + perT_ * offsetM;
    const Vec3 end = start + perU_;
    // Where the line passes the viewer there is no saying where it ends on screen.
    if (!(std::min(start.z, end.z) > 1e-9 * std::max(origin_.z, origin_.z + perU_.z))) return {};
    const double startX = start.x / start.z;
    const double startY = start.y / start.z;
    const double endX = end.x / end.z;
    const double endY = end.y / end.z;
    Range range{std::min(startX, endX), std::max(startX, endX), std::min(startY, endY), std::max(startY, endY)};
    const auto reach = [](double to, double& low, double& high) {
      low = std::min(low, to);
      high = std::max(high, to);
    };
    if (perT_.z > 0) {
      reach(perT_.x / perT_.z, range.awayLow, range.awayHigh);
      reach(perT_.y / perT_.z, range.alongLow, range.alongHigh);
    } else {
      for (const auto& [x, y] : {std::pair{startX, startY}, {endX, endY}}) {
        reach(x + (perT_.x - x * perT_.z) * Range::kFar, range.awayLow, range.awayHigh);
        reach(y + (perT_.y - y * perT_.z) * Range::kFar, range.alongLow, range.alongHigh);
      }
    }
    return range;
  }

private:
  Vec3 origin_, perU_, perT_;
};

/// As a float in all lanes, however far it is.
Float4 splatFar(double v) { return splat4(static_cast<float>(std::clamp(v, -Range::kFar, Range::kFar))); }

/// The two sizes of boxes that are tested: a strip, and a block of strips.
enum BoxSize : std::size_t { kStrip = 0, kBlock = 1 };
constexpr std::array<std::size_t, 2> kStripsIn{1, kBlockStrips};

/// Lane by lane, the greatest value of a form over boxes: from `away` to the field's far end, and from `along` on
/// over the box's width.
class GreatestOverBox {
public:
  GreatestOverBox() = default;
  GreatestOverBox(const Form& form, double extentPx, double marginPx)
      : perAway_(splat4(static_cast<float>(std::min(form.away, 0.0)))),
        perAlong_(splat4(static_cast<float>(form.along))) {
    const double atStart = form.constant + std::max(form.away, 0.0) * extentPx + form.steepness() * marginPx;
    for (const BoxSize size : {kStrip, kBlock}) {
      const double width = static_cast<double>(kStripsIn[size]);
      constant_[size] = splat4(static_cast<float>(atStart + std::max(form.along, 0.0) * width));
    }
  }

  [[nodiscard]] Float4 at(BoxSize size, Float4 away, Float4 along) const {
    return perAway_ * away + perAlong_ * along + constant_[size];
  }

private:
  Float4 perAway_{};
  Float4 perAlong_{};
  std::array<Float4, 2> constant_{};
};

/// Tests boxes, four at a time, against the wedge beyond an offset. A box reaches from a value of its own to the
/// field's far end. Separating axes: the wedge's three sides, and the box's own two directions.
class BoxFilter {
public:
  BoxFilter(const Wedge& wedge, double extentPx)
      : extentPx_(extentPx), u_(wedge.u, extentPx, kNegligiblePx), v_(wedge.v, extentPx, kNegligiblePx) {}

  void aim(const Form& beyond, const Range& range) {
    g_ = GreatestOverBox(beyond, extentPx_, -kNegligiblePx);
    awayHigh_ = splatFar(range.awayHigh + kNegligiblePx);
    alongLow_[kStrip] = splatFar(range.alongLow - kNegligiblePx - 1);
    alongLow_[kBlock] = splatFar(range.alongLow - kNegligiblePx - static_cast<double>(kBlockStrips));
    alongHigh_ = splatFar(range.alongHigh + kNegligiblePx);
  }

  /// Whether a box may hold something beyond the offset by more than kNegligiblePx: never wrongly no.
  [[nodiscard]] Int4 passes(BoxSize size, Float4 value, Float4 along) const {
    return (value <= awayHigh_) & (along >= alongLow_[size]) & (along <= alongHigh_) &
           (u_.at(size, value, along) >= 0.0F) & (v_.at(size, value, along) >= 0.0F) &
           (g_.at(size, value, along) > 0.0F);
  }

private:
  double extentPx_;
  Float4 awayHigh_{};
  std::array<Float4, 2> alongLow_{};
  Float4 alongHigh_{};
  GreatestOverBox u_;
  GreatestOverBox v_;
  GreatestOverBox g_;
};

/// Says roughly how great an offset a box holds, by which the first to visit is chosen: at the middle of its width,
/// there where the box, cut by the wedge's two banks (the extension lines), begins and ends.
class Promise {
public:
  Promise(const Wedge& wedge, const Range& range, double extentPx)
      : t_(wedge.t),
        w_(wedge.w),
        alongLow_(splatFar(range.alongLow)),
        alongHigh_(splatFar(range.alongHigh)),
        extent_(splatFar(extentPx)) {
    for (const Form* form : {&wedge.u, &wedge.v}) {
      // A bank that runs nearly straight away bounds no distance.
      if (std::abs(form->away) < 1e-4 * std::abs(form->along)) continue;
      Line& line = form->away > 0 ? lower_[lowers_++] : upper_[uppers_++];
      line = {splat4(static_cast<float>(-form->along / form->away)), splatFar(-form->constant / form->away)};
    }
  }

  [[nodiscard]] Float4 of(Float4 value, Float4 along, float width) const {
    const Float4 middle = max4(min4(along + width * 0.5F, alongHigh_), alongLow_);
    Float4 low = max4(value, splat4(0.0F));
    Float4 high = extent_;
    for (std::size_t i = 0; i < lowers_; ++i) low = max4(low, lower_[i].at(middle));
    for (std::size_t i = 0; i < uppers_; ++i) high = min4(high, upper_[i].at(middle));
    return max4(offset(low, middle), offset(max4(low, high), middle));
  }

private:
  struct Line {
    Float4 slope;
    Float4 constant;
    [[nodiscard]] Float4 at(Float4 along) const { return slope * along + constant; }
  };
  struct Form4 {
    Float4 away, along, constant;
    explicit Form4(const Form& f)
        : away(splat4(static_cast<float>(f.away))),
          along(splat4(static_cast<float>(f.along))),
          constant(splat4(static_cast<float>(f.constant))) {}
    [[nodiscard]] Float4 at(Float4 awayPx, Float4 alongPx) const { return away * awayPx + along * alongPx + constant; }
  };

  [[nodiscard]] Float4 offset(Float4 away, Float4 along) const {
    return t_.at(away, along) / max4(w_.at(away, along), splat4(static_cast<float>(kHorizon)));
  }

  Form4 t_;
  Form4 w_;
  Float4 alongLow_;
  Float4 alongHigh_;
  Float4 extent_;
  std::array<Line, 2> lower_;
  std::array<Line, 2> upper_;
  std::size_t lowers_ = 0;
  std::size_t uppers_ = 0;
};

/// One field, one slide: the search for the greatest offset over what the field blocks in the wedge.
class Search {
public:
  Search(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields, const Slide& slide,
         double uselessAboveM)
      : field_(field),
        rows_(edge == ViewportEdge::kLeft || edge == ViewportEdge::kRight),
        extentPx_(fields.extentPx(edge)),
        wedge_(fields, edge, slide),
        filter_(wedge_, extentPx_),
        enoughM_(std::min(uselessAboveM, kFarthest)) {}

  /// `hint`: where on screen another field was found to hold its greatest offset. Most often this one does so nearby.
  double run(const std::optional<Vec2>& hint) {
    if (!(field_.least(1) < extentPx_)) return 0;  // there is nothing to be seen
    if (touchesViewportEdge()) return kInfinity;
    if (hint) improve(stripAt(rows_ ? hint->y : hint->x));
    if (best_ > enoughM_) return best_;
    if (best_ == 0) aim();
    const std::size_t first = stripAt(range_.alongLow);
    const std::size_t last = stripAt(range_.alongHigh);
    sweep(
        kBlock, first / kBlockStrips, last / kBlockStrips,
        [&](std::size_t block) { return load4(field_.leastOfBlocks().data() + block); },
        [&](std::size_t block) {
          const std::size_t begin = block * kBlockStrips;
          sweep(
              kStrip, std::max(first, begin), std::min(last, begin + kBlockStrips - 1),
              [&](std::size_t strip) { return load4(field_.values().data() + strip); },
              [&](std::size_t strip) { improve(strip); });
        });
    return best_;
  }

  /// The place along the viewport edge where the greatest offset was found.
  [[nodiscard]] double contactAlong() const { return contact_.along; }
  [[nodiscard]] double contactAway() const { return contact_.away; }

private:
  /// Whether a strip of value <= 0 meets the viewport edge inside the wedge.
  [[nodiscard]] bool touchesViewportEdge() const {
    if (field_.least(1) > 0) return false;
    double low = 0;
    double high = static_cast<double>(field_.size());
    for (const Form* form : {&wedge_.u, &wedge_.v, &wedge_.t}) {
      const double atLow = form->at(0, low);
      const double atHigh = form->at(0, high);
      if (atLow < 0 && atHigh < 0) return false;
      if (atLow >= 0 && atHigh >= 0) continue;
      const double zero = low + (high - low) * (atLow / (atLow - atHigh));
      (atLow < 0 ? low : high) = zero;
    }
    return field_.min(stripAt(low), stripAt(high)) <= 0;
  }

  [[nodiscard]] std::size_t stripAt(double along) const {
    return static_cast<std::size_t>(std::clamp(along, 0.0, static_cast<double>(field_.size()) - 1));
  }

  /// From now on only what lies beyond the best offset matters.
  void aim() {
    range_ = wedge_.rangeBeyond(best_);
    filter_.aim(wedge_.beyond(best_), range_);
  }

  /// Visits the boxes from first to last that may raise the best offset, the most promising one first.
  template <typename ValuesFrom, typename Visit>
  void sweep(BoxSize size, std::size_t first, std::size_t last, ValuesFrom valuesFrom, Visit visit) {
    const auto width = static_cast<float>(kStripsIn[size]);
    const Float4 lastBox = splat4(static_cast<float>(last));
    const auto passesFrom = [&](std::size_t i) {
      const Float4 box = splat4(static_cast<float>(i)) + kLanes;
      return lanesOf(filter_.passes(size, valuesFrom(i), box * width) & (box <= lastBox));
    };
    std::size_t promising = last + 1;
    float most = -kNoSilhouette;
    for (std::size_t i = first; i <= last; i += 4) {
      const unsigned passes = passesFrom(i);
      if (passes == 0) continue;
      if (!promise_) promise_.emplace(wedge_, range_, extentPx_);
      const Float4 along = (splat4(static_cast<float>(i)) + kLanes) * width;
      const Float4 promised = promise_->of(valuesFrom(i), along, width);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if ((passes >> lane & 1U) == 0 || !(promised[lane] > most)) continue;
        most = promised[lane];
        promising = i + lane;
      }
    }
    if (promising > last) return;
    visit(promising);
    for (std::size_t i = first; i <= last && best_ <= enoughM_; i += 4) {
      const unsigned passes = passesFrom(i);
      if (passes == 0) continue;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if ((passes >> lane & 1U) != 0 && i + lane != promising) visit(i + lane);
      }
    }
  }

  /// Raises the best offset to the greatest in one strip's box.
  void improve(std::size_t strip) {
    const double value = field_.at(strip);
    if (!(value <= extentPx_)) return;
    const double low = static_cast<double>(strip);
    Polygon polygon(std::max(0.0, value), extentPx_, low, low + 1);
    polygon.cut(wedge_.u);
    polygon.cut(wedge_.v);
    const double before = best_;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const auto& [away, along] = polygon.corners[i];
      const double w = wedge_.w.at(away, along);
      const double t = wedge_.t.at(away, along);
      if (!(t > best_ * w)) continue;
      best_ = w > kHorizon ? t / w : kInfinity;
      contact_ = polygon.corners[i];
    }
    if (best_ > before && best_ <= enoughM_) aim();
  }

  const DistanceField& field_;
  bool rows_;
  double extentPx_;
  Wedge wedge_;
  BoxFilter filter_;
  std::optional<Promise> promise_;
  Range range_;
  double best_ = 0;
  double enoughM_;
  Polygon::Corner contact_{0, 0};
};

/// A point of the viewport inside the wedge a little beyond an offset, if there is one half way between the extension
/// lines.
std::optional<Vec2> pointBeyond(const DistanceFields& fields, const Slide& slide, double offsetM) {
  constexpr double kStepPx = 2;
  const Vec3 middle = slide.middlePixel(offsetM);
  if (!(middle.z > 0)) return std::nullopt;
  const Vec2 from = Vec2(middle.x, middle.y) / middle.z;
  const Vec2 way = Vec2(slide.pixelPerT().x, slide.pixelPerT().y) - from * slide.pixelPerT().z;
  const Vec2 to = from + way * (kStepPx / glm::length(way));
  // The step must not lead past the horizon.
  const double w = glm::dot(slide.wForm(), Vec3(to, 1));
  const bool beyond = w > kHorizon && glm::dot(slide.tForm(), Vec3(to, 1)) > offsetM * w;
  const bool seen = to.x >= 0 && to.y >= 0 && to.x <= fields.widthPx && to.y <= fields.heightPx;
  return beyond && seen ? std::optional(to) : std::nullopt;
}

Vec2 onScreen(const DistanceFields& fields, ViewportEdge edge, double away, double along) {
  switch (edge) {
    case ViewportEdge::kLeft:
      return {away, along};
    case ViewportEdge::kRight:
      return {fields.widthPx - away, along};
    case ViewportEdge::kTop:
      return {along, away};
    case ViewportEdge::kBottom:
      return {along, fields.heightPx - away};
  }
  return {};
}

}  // namespace

std::optional<Slide> Slide::make(const View& view, const Segment& base, const Vec3& across) {
  assert(std::abs(glm::length(across) - 1) < 1e-6);
  if (!view.inFrontOfNear(base)) return std::nullopt;
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
  slide.originPixel_ = origin;
  slide.pixelPerU_ = perU;
  slide.pixelPerT_ = perT;
  return slide;
}

double leastClearingOffset(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields,
                           const Slide& slide, double uselessAboveM) {
  return Search(field, edge, fields, slide, uselessAboveM).run(std::nullopt);
}

double leastClearingOffset(const DistanceFields& fields, const Slide& slide, double uselessAboveM) {
  // The field that the line sets off towards most often has the answer.
  const Vec3 middle = slide.middlePixel(0);
  const Vec3& perT = slide.pixelPerT();
  const Vec2 way(perT.x * middle.z - middle.x * perT.z, perT.y * middle.z - middle.y * perT.z);
  const ViewportEdge alongX = way.x < 0 ? ViewportEdge::kLeft : ViewportEdge::kRight;
  const ViewportEdge alongY = way.y < 0 ? ViewportEdge::kTop : ViewportEdge::kBottom;
  const bool xFirst = std::abs(way.x) > std::abs(way.y);
  const auto opposite = [](ViewportEdge edge) { return static_cast<ViewportEdge>(static_cast<unsigned>(edge) ^ 1U); };
  double least = kInfinity;
  std::optional<Vec2> probe;
  std::optional<Vec2> contact;
  for (const ViewportEdge edge : {xFirst ? alongX : alongY, xFirst ? alongY : alongX,
                                  opposite(xFirst ? alongY : alongX), opposite(xFirst ? alongX : alongY)}) {
    if (probe && isBlocked(fields, edge, *probe)) continue;
    const double boundM = std::min(least, uselessAboveM);
    Search search(fields[edge], edge, fields, slide, boundM);
    const double offsetM = search.run(contact);
    if (!(offsetM < boundM)) continue;
    least = offsetM;
    if (least == 0) break;
    contact = onScreen(fields, edge, search.contactAway(), search.contactAlong());
    probe = pointBeyond(fields, slide, least);
  }
  return least;
}

}  // namespace dimline
