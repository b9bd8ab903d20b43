// The query works in homogeneous coordinates of the sliding plane. A screen point q has there
//
//     U = uForm . q      V = (wForm - uForm) . q      T = tForm . q      W = U + V = wForm . q
//
// and it lies in the wedge between the extension lines exactly when U, V and T are all >= 0. W >= 0 follows; W = 0 is the horizon.
// Its offset is t = T / W. To ask only for points beyond an offset b, T is replaced by G = T - b W: a point of the wedge
// lies beyond b exactly when G > 0. So "can this box beat the best offset so far" is three half-planes against a box, without a division, and a
// box is clipped by keeping the vertices' (U, V, G) and cutting at zero each in turn: their places on screen are never needed.
// t is a quotient of linear functions, so on a convex polygon that does not pass the horizon it is greatest at a vertex.

#include "silhouette/slide.h"

#include <cassert>
#include <cmath>

namespace dimline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sine of the angle below which line and `across` are parallel, or the plane is seen edge-on. Far below what placement accepts
/// (kEdgeOnAngleRad): here it only keeps the inverse accurate to about 1e-9.
constexpr double kDegenerateSine = 1e-6;

/// Points seen this close to the plane's horizon (the base line's depth over theirs) count as on it. Rounding reaches about 1e-9.
constexpr double kHorizon = 1e-7;

/// A linear form over a field's own coordinates: `away` from its viewport edge, and `along` its strips.
struct Form {
  double away;
  double along;
  double constant;

  [[nodiscard]] double at(double awayPx, double alongPx) const { return away * awayPx + along * alongPx + constant; }
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

struct Rect {
  double awayLow, awayHigh;
  double alongLow, alongHigh;
};

double greatest(const Form& form, const Rect& r) {
  return form.at(form.away > 0 ? r.awayHigh : r.awayLow, form.along > 0 ? r.alongHigh : r.alongLow);
}

/// A convex polygon by its vertices' (U, V, G). A rectangle cut by three half-planes has at most seven.
struct Polygon {
  std::array<Vec3, 8> vertices;
  int count = 0;
};

/// Keeps the part where coordinate `axis` is >= 0.
Polygon cut(const Polygon& polygon, int axis) {
  Polygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const Vec3& a = polygon.vertices[static_cast<std::size_t>(i)];
    const Vec3& b = polygon.vertices[static_cast<std::size_t>(i + 1 == polygon.count ? 0 : i + 1)];
    if (a[axis] >= 0) kept.vertices[static_cast<std::size_t>(kept.count++)] = a;
    if ((a[axis] >= 0) != (b[axis] >= 0)) {
      Vec3 crossing = a + (b - a) * (a[axis] / (a[axis] - b[axis]));
      crossing[axis] = 0;
      kept.vertices[static_cast<std::size_t>(kept.count++)] = crossing;
    }
  }
  return kept;
}

/// One field, one slide: the search for the greatest offset over what the field blocks in the wedge.
class Search {
 public:
  Search(const DistanceField& field, ViewportEdge edge, const DistanceFields& fields, const Slide& slide, double uselessAboveM)
      : field_(field), extentPx_(fields.extentPx(edge)), uselessAboveM_(uselessAboveM) {
    u_ = seenFrom(edge, fields, slide.uForm());
    w_ = seenFrom(edge, fields, slide.wForm());
    v_ = w_ - u_;
    t_ = seenFrom(edge, fields, slide.tForm());
    g_ = t_;
  }

  double run() {
    if (touchesViewportEdge()) return kInfinity;
    visit(1, 0, field_.leafCount());
    return best_;
  }

 private:
  /// Whether a strip of value <= 0 meets the viewport edge inside the wedge.
  [[nodiscard]] bool touchesViewportEdge() const {
    if (field_.node(1).min > 0) return false;
    double low = 0;
    double high = static_cast<double>(field_.size());
    for (const Form* form : {&u_, &v_, &t_}) {
      const double atLow = form->at(0, low);
      const double atHigh = form->at(0, high);
      if (atLow < 0 && atHigh < 0) return false;
      if (atLow >= 0 && atHigh >= 0) continue;
      const double zero = low + (high - low) * (atLow / (atLow - atHigh));
      (atLow < 0 ? low : high) = zero;
    }
    const double end = static_cast<double>(field_.size()) - 1;
    const double first = std::clamp(std::floor(low), 0.0, end);
    const double last = std::clamp(std::floor(high), first, end);
    return field_.min(static_cast<std::size_t>(first), static_cast<std::size_t>(last)) <= 0;
  }

  [[nodiscard]] Rect rectOf(std::size_t first, std::size_t count, float value) const {
    return {std::max(0.0, static_cast<double>(value)), extentPx_, static_cast<double>(first),
            static_cast<double>(std::min(first + count, field_.size()))};
  }

  /// Whether the wedge beyond the best offset so far may meet the rectangle: never wrongly no.
  [[nodiscard]] bool mayImprove(const Rect& r) const { return greatest(u_, r) >= 0 && greatest(v_, r) >= 0 && greatest(g_, r) > 0; }

  /// Raises the best offset to the greatest in the rectangle.
  void improve(const Rect& r) {
    Polygon polygon;
    polygon.count = 4;
    int i = 0;
    for (const auto& [away, along] : {std::pair{r.awayLow, r.alongLow}, {r.awayHigh, r.alongLow}, {r.awayHigh, r.alongHigh}, {r.awayLow, r.alongHigh}}) {
      polygon.vertices[static_cast<std::size_t>(i++)] = {u_.at(away, along), v_.at(away, along), g_.at(away, along)};
    }
    for (int axis = 0; axis < 3 && polygon.count > 0; ++axis) polygon = cut(polygon, axis);
    double gain = 0;
    for (i = 0; i < polygon.count; ++i) {
      const Vec3& p = polygon.vertices[static_cast<std::size_t>(i)];
      const double w = p.x + p.y;
      if (p.z > 0) gain = std::max(gain, w > kHorizon ? p.z / w : kInfinity);
    }
    if (gain > 0) {
      best_ += gain;
      g_ = t_ - w_ * best_;
    }
  }

  void visit(std::size_t index, std::size_t first, std::size_t count) {
    const float least = field_.node(index).min;
    if (!(least < extentPx_) || best_ > uselessAboveM_) return;
    const Rect rect = rectOf(first, count, least);
    if (!mayImprove(rect)) return;
    if (count == 1) {
      improve(rect);
      return;
    }
    const std::size_t half = count / 2;
    const double lower = greatest(g_, rectOf(first, half, field_.node(2 * index).min));
    const double upper = first + half < field_.size() ? greatest(g_, rectOf(first + half, half, field_.node(2 * index + 1).min)) : -1;
    if (lower >= upper) {
      visit(2 * index, first, half);
      if (upper >= 0) visit(2 * index + 1, first + half, half);
    } else {
      visit(2 * index + 1, first + half, half);
      visit(2 * index, first, half);
    }
  }

  const DistanceField& field_;
  double extentPx_;
  double uselessAboveM_;
  double best_ = 0;
  Form u_, v_, w_, t_, g_;
};

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
  return Search(field, edge, fields, slide, uselessAboveM).run();
}

double leastClearingOffset(const DistanceFields& fields, const Slide& slide, double uselessAboveM) {
  // The field that the line sets off towards most often has the answer, so the others mostly need no more than show that theirs is greater.
  const Vec2& way = slide.setOffPx();
  const ViewportEdge alongX = way.x < 0 ? ViewportEdge::kLeft : ViewportEdge::kRight;
  const ViewportEdge alongY = way.y < 0 ? ViewportEdge::kTop : ViewportEdge::kBottom;
  const bool xFirst = std::abs(way.x) > std::abs(way.y);
  const auto opposite = [](ViewportEdge edge) { return static_cast<ViewportEdge>(static_cast<unsigned>(edge) ^ 1U); };
  double least = kInfinity;
  for (const ViewportEdge edge : {xFirst ? alongX : alongY, xFirst ? alongY : alongX, opposite(xFirst ? alongY : alongX),
                                  opposite(xFirst ? alongX : alongY)}) {
    least = std::min(least, leastClearingOffset(fields[edge], edge, fields, slide, std::min(least, uselessAboveM)));
  }
  return least;
}

}  // namespace dimline
