#include "cli/audit_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.h"

namespace dimline {

namespace {

constexpr double kSharedPx = 2.0;
constexpr int kArcChords = 32;
constexpr double kParallelWorldRad = 1e-3;
const double kParallelScreenCos = std::cos(5.0 / 180.0 * 3.14159265358979323846);

double pointGapPx(const Vec2& p, const Segment2& s) {
  const Vec2 d = s.end - s.start;
  const double length2 = glm::dot(d, d);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - s.start, d) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (s.start + d * t));
}

/// How far the ends of `s` lie on either side of the carrier of `of`: the lesser one, negative when both are on one
/// side.
double straddlePx(const Segment2& s, const Segment2& of) {
  const double length = of.length();
  if (!(length > 0)) return -1;
  const Vec2 normal = Vec2(-(of.end - of.start).y, (of.end - of.start).x) / length;
  const double a = glm::dot(s.start - of.start, normal);
  const double b = glm::dot(s.end - of.start, normal);
  return std::min(std::max(a, b), -std::min(a, b));
}

/// The part of a segment whose projection onto a unit direction lies in [from, to].
Segment2 between(const Segment2& s, const Vec2& direction, double from, double to) {
  const double a = glm::dot(s.start, direction);
  const double b = glm::dot(s.end, direction);
  const auto at = [&](double value) {
    return s.start + (s.end - s.start) * std::clamp((value - a) / (b - a), 0.0, 1.0);
  };
  return a < b ? Segment2{at(from), at(to)} : Segment2{at(to), at(from)};
}

}  // namespace

double gapPx(const Segment2& a, const Segment2& b) {
  if (straddlePx(a, b) > 0 && straddlePx(b, a) > 0) return 0;
  return std::min({pointGapPx(a.start, b), pointGapPx(a.end, b), pointGapPx(b.start, a), pointGapPx(b.end, a)});
}

bool crossEachOther(const Segment2& a, const Segment2& b) {
  return straddlePx(a, b) > kTouchPx && straddlePx(b, a) > kTouchPx;
}

bool lieOnEachOther(const Segment2& a, const Segment2& b) {
  const auto shared = beside(a, b);
  return shared && std::max({pointGapPx(shared->a.start, b), pointGapPx(shared->a.end, b),
                             pointGapPx(shared->b.start, a), pointGapPx(shared->b.end, a)}) < 1.0;
}

bool enters(const Segment2& segment, const Box2& box) {
  const Box2 inner = box.grown(-kTouchPx);
  if (inner.empty()) return false;
  const auto holds = [&](const Vec2& p) {
    return p.x > inner.min.x && p.x < inner.max.x && p.y > inner.min.y && p.y < inner.max.y;
  };
  if (holds(segment.start) || holds(segment.end)) return true;
  const Vec2 c(inner.max.x, inner.min.y);
  const Vec2 d(inner.min.x, inner.max.y);
  // A segment through a convex box crosses one of its diagonals.
  return gapPx(segment, {inner.min, inner.max}) == 0 || gapPx(segment, {c, d}) == 0;
}

bool overlap(const Box2& a, const Box2& b) {
  return std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x) > kTouchPx &&
         std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y) > kTouchPx;
}

std::optional<Beside> beside(const Segment2& a, const Segment2& b) {
  if (!(a.length() > 0 && b.length() > 0)) return std::nullopt;
  const Vec2 alongA = (a.end - a.start) / a.length();
  Vec2 alongB = (b.end - b.start) / b.length();
  if (glm::dot(alongA, alongB) < 0) alongB = -alongB;
  if (glm::dot(alongA, alongB) < 0.5) return std::nullopt;
  const Vec2 mean = glm::normalize(alongA + alongB);
  const auto [fromA, toA] = std::minmax({glm::dot(a.start, mean), glm::dot(a.end, mean)});
  const auto [fromB, toB] = std::minmax({glm::dot(b.start, mean), glm::dot(b.end, mean)});
  const double from = std::max(fromA, fromB);
  const double to = std::min(toA, toB);
  if (to - from < kSharedPx) return std::nullopt;
  return Beside{between(a, mean, from, to), between(b, mean, from, to), Vec2(-mean.y, mean.x)};
}

DrawnArc drawnArc(const PlacedHandle& handle, const View& view) {
  if (!handle.arc || !view.inFrontOfNear(handle.arc->center)) return {};
  const Vec2 center = view.toScreen(handle.arc->center);
  DrawnArc drawn;
  Vec2 last;
  for (int i = 0; i <= kArcChords; ++i) {
    const Vec3 p = handle.arc->at(handle.arc->angleRad * i / kArcChords);
    if (!view.inFrontOfNear(p)) return {};
    const Vec2 next = view.toScreen(p);
    if (i > 0) drawn.curve.push_back({last, next});
    if (i == 0 || i == kArcChords) drawn.arms.push_back({center, next});
    last = next;
  }
  return drawn;
}

bool parallel(const PlacedLine& a, const PlacedLine& b) {
  const Vec3 worldA = glm::normalize(a.line.end - a.line.start);
  const Vec3 worldB = glm::normalize(b.line.end - b.line.start);
  if (glm::length(glm::cross(worldA, worldB)) < kParallelWorldRad) return true;
  const Vec2 screenA = glm::normalize(a.lineScreen.end - a.lineScreen.start);
  const Vec2 screenB = glm::normalize(b.lineScreen.end - b.lineScreen.start);
  return std::abs(glm::dot(screenA, screenB)) > kParallelScreenCos;
}

bool onOneGuide(const PlacedLine& a, const PlacedLine& b, double modelSizeM) {
  const Vec3 along = glm::normalize(a.line.end - a.line.start);
  if (glm::length(glm::cross(along, glm::normalize(b.line.end - b.line.start))) > kSamePlaneAngleRad) return false;
  const auto awayM = [&](const Vec3& p) { return glm::length(glm::cross(p - a.line.start, along)); };
  return std::max(awayM(b.line.start), awayM(b.line.end)) < kSamePlaneDistance * modelSizeM;
}

}  // namespace dimline
