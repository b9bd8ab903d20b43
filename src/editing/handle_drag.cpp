#include "editing/handle_drag.h"

#include <algorithm>
#include <cmath>

#include "placement/base_lines.h"
#include "placement/label_text.h"
#include "placement/text_metrics.h"

namespace dimline {

namespace {

/// px per metre times metres of line: under this the whole line is less than a pixel long on screen and gives no
/// direction.
constexpr double kLeastLinePx = 1.0;

/// Share of a pixel that nobody sees a handle lag behind the pointer.
constexpr double kTolerancePx = 0.25;

/// How a point that moves along a line in the world moves on screen, at its start: the unit direction and the speed. A
/// line in the world is a line on screen, so the direction holds all along; the speed does not, under perspective.
struct ScreenMotion {
  Vec3 at;     ///< homogeneous pixels of the start
  Vec3 along;  ///< their change per metre
  Vec2 direction{0.0};
  double pxPerM = 0;
};

ScreenMotion screenMotion(const View& view, const Vec3& start, const Vec3& directionWorld) {
  ScreenMotion motion;
  motion.at = view.worldToPixels() * Vec4(start, 1.0);
  motion.along = view.worldToPixels() * Vec4(directionWorld, 0.0);
  const double w = motion.at.z;
  const Vec2 velocity = (Vec2(motion.along) * w - Vec2(motion.at) * motion.along.z) / (w * w);
  motion.pxPerM = glm::length(velocity);
  if (motion.pxPerM > 0) motion.direction = velocity / motion.pxPerM;
  return motion;
}

/// px. An end that has moved by less is where it was.
constexpr double kMovedPx = 1.0;

/// The parts of the old line that reach beyond the present one, and bars where ends were that have moved.
void addGhost(const Segment2& old, const Segment2& now, const Vec2& along, std::vector<DragMark>& marks) {
  const auto add = [&](const Vec2& was, const Vec2& is, double outward) {
    if (glm::length(was - is) < kMovedPx) return;
    marks.push_back({DragMark::Kind::kGhost, barAcross(was, along, halfLengthPx(DragMark::Kind::kGhost))});
    if (outward * glm::dot(was - is, along) > 0) marks.push_back({DragMark::Kind::kGhost, {is, was}});
  };
  add(old.end, now.end, 1.0);
  add(old.start, now.start, -1.0);
}

/// m. Farther than anything in a model.
constexpr double kElsewhereM = 1e9;

bool parallel(const Segment& segment, const Vec3& direction) {
  const Vec3 along = segment.end - segment.start;
  return glm::length(glm::cross(along, direction)) <= kSamePlaneAngleRad * glm::length(along);
}

/// Metres that the end moves when the value grows by one, as far as the length tells.
double expectedSlope(const Parameter& parameter, const PlacedLine& line, double value, bool atEnd) {
  const double outward = atEnd ? 1.0 : -1.0;
  const bool isLength = parameter.type == ParameterType::kFloat && parameter.unit == Unit::kMetre;
  // A count or an area is expected to grow in proportion to what it is shown on.
  const double perUnit = isLength || !(std::abs(value) > 1e-9) ? 1.0 : line.lengthM / std::abs(value);
  return outward * (perUnit > 0 ? perUnit : 1.0);
}

}  // namespace

std::optional<HandleDrag> HandleDrag::begin(const Model& model, const Values& values, const Scene& scene,
                                            const PlacedLine& line, const Handle& handle, const Vec2& pointer,
                                            const View& view) {
  if (line.parameter >= model.annotations.size() || !model.annotations[line.parameter] ||
      line.scope >= scene.scopes.size()) {
    return std::nullopt;
  }
  const double lengthM = line.line.length();
  const Vec3& grabbed = handle.atEnd ? line.line.end : line.line.start;
  if (!(lengthM > 0) || !view.inFrontOfNear(grabbed)) return std::nullopt;
  const ScreenMotion motion = screenMotion(view, grabbed, (line.line.end - line.line.start) / lengthM);
  if (!(motion.pxPerM * lengthM > kLeastLinePx) || !std::isfinite(motion.pxPerM)) return std::nullopt;

  HandleDrag drag(model, values, line, handle, pointer - handle.screen, view, kTolerancePx / motion.pxPerM);
  drag.findMeasured(scene);
  if (drag.baseLine_ < 0) return std::nullopt;
  return drag;
}

HandleDrag::HandleDrag(const Model& model, const Values& values, const PlacedLine& line, const Handle& handle,
                       const Vec2& grabOffset, const View& view, double toleranceM)
    : model_(&model),
      startValues_(values),
      startView_(view),
      line_(line),
      labelAnchor_(labelAnchor(line)),
      atEnd_(handle.atEnd),
      direction_(glm::normalize(line.line.end - line.line.start)),
      grabOffset_(grabOffset),
      toleranceM_(toleranceM),
      lastValue_(values.at(line.parameter)) {}

ValueSearch& HandleDrag::search(Snap snap) {
  auto& search = searches_[static_cast<std::size_t>(snap)];
  if (!search) {
    const Parameter& parameter = model_->parameters()[line_.parameter];
    const double value = startValues_.at(line_.parameter);
    search.emplace(snappedBy(parameter, snap), value, expectedSlope(parameter, line_, value, atEnd_), toleranceM_);
  }
  return *search;
}

int HandleDrag::evaluations() const {
  int total = 0;
  for (const auto& search : searches_) total += search ? search->evaluations() : 0;
  return total;
}

double HandleDrag::valueAt(const Vec2& pointer, const View& view, Snap snap) {
  const Vec2 screen = pointer - grabOffset_;
  if (!std::isfinite(screen.x) || !std::isfinite(screen.y)) return lastValue_;
  lastValue_ = search(snap).find(targetM(screen, view), [this](double value) { return endAt(value); });
  return lastValue_;
}

/// Where on the carrier (m from the dragged end's start) a point of the screen lies, by its position along the
/// carrier's direction on screen. Past the carrier's vanishing point, endlessly far.
double HandleDrag::targetM(const Vec2& screen, const View& view) const {
  const ScreenMotion motion = screenMotion(view, endOf(line_.line), direction_);
  if (!(motion.pxPerM > 0) || !std::isfinite(motion.pxPerM)) return 0.0;
  const double along = glm::dot(motion.direction, screen);
  const double numerator = along * motion.at.z - glm::dot(motion.direction, Vec2(motion.at));
  const double denominator = glm::dot(motion.direction, Vec2(motion.along)) - along * motion.along.z;
  const double denominatorAtStart = motion.at.z * motion.pxPerM;
  if (!(denominator > 1e-9 * denominatorAtStart)) {
    return motion.along.z > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  }
  return numerator / denominator;
}

/// Where the dragged end goes (m along the carrier) when the parameter has that value.
std::optional<double> HandleDrag::endAt(double value) const {
  Values values = startValues_;
  values.set(line_.parameter, value);
  const auto tracked = track(model_->definition.build(values));
  if (!tracked) return std::nullopt;
  return glm::dot(endOf(tracked->base) - endOf(line_.base), direction_);
}

std::size_t HandleDrag::countScopes(const Scene& scene) const {
  return static_cast<std::size_t>(std::ranges::count(scene.scopes, annotation().scope, &Scope::name));
}

/// An identity may be that of a chain, which has neither a scope nor a base line of its own; the base line's place
/// always tells.
void HandleDrag::findMeasured(const Scene& scene) {
  const Scope& scope = scene.scopes[line_.scope];
  scopeIndex_ = scope.index;
  scopeCount_ = countScopes(scene);
  double nearestM = std::numeric_limits<double>::infinity();
  for (const BaseLine& candidate : baseLines(annotation(), scope.box, startView_)) {
    const double distanceM =
        glm::length(candidate.segment.start - line_.base.start) + glm::length(candidate.segment.end - line_.base.end);
    if (distanceM >= nearestM) continue;
    nearestM = distanceM;
    baseLine_ = candidate.number;
  }
}

std::optional<HandleDrag::Tracked> HandleDrag::track(const Scene& scene) const {
  const std::size_t count = countScopes(scene);
  std::optional<Tracked> nearest;
  double nearestM = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.scopes.size(); ++i) {
    const Scope& scope = scene.scopes[i];
    if (scope.name != annotation().scope) continue;
    if (count == scopeCount_ && scope.index != scopeIndex_) continue;
    for (const BaseLine& candidate : baseLines(annotation(), scope.box, startView_)) {
      if (candidate.number != baseLine_) continue;
      double distanceM = glm::length(endOf(candidate.segment) - endOf(line_.base));
      // Round the corner of a building the same rule repeats something else.
      if (!parallel(candidate.segment, direction_)) distanceM += kElsewhereM;
      if (distanceM < nearestM) {
        nearestM = distanceM;
        nearest = Tracked{i, candidate.segment};
      }
    }
  }
  if (nearest && count != scopeCount_) nearest->base = keptInPlace(nearest->base);
  return nearest;
}

/// A base line of the same length and direction, of which the end that is not dragged is where it was.
Segment HandleDrag::keptInPlace(const Segment& base) const {
  const Vec3 along = base.end - base.start;
  return atEnd_ ? Segment{line_.base.start, line_.base.start + along} : Segment{line_.base.end - along, line_.base.end};
}

void HandleDrag::addMarks(double value, const Segment2& now, const View& view, Snap snap, std::vector<DragMark>& marks) {
  const Parameter parameter = snappedBy(model_->parameters()[line_.parameter], snap);
  const Reach reach = [this](double at) { return endAt(at); };
  ValueSearch& tried = search(snap);
  const auto slope = tried.straightSlope(reach);
  const double startValue = startValues_.at(line_.parameter);
  const auto screenAt = [&](double endM) -> std::optional<Vec2> {
    const Vec3 place = endOf(line_.line) + direction_ * endM;
    if (!view.inFrontOfNear(place)) return std::nullopt;
    return view.toScreen(place);
  };
  const Segment2 old = view.toScreen(line_.line);
  const Vec2 along = glm::normalize(old.end - old.start);

  if (value != startValue) addGhost(old, now, along, marks);
  const auto addLimit = [&](double limit, std::optional<double> endM) {
    const auto at = endM ? screenAt(*endM) : std::nullopt;
    if (!at || !view.viewport().overlaps({*at, *at})) return;
    const auto kind = value == limit ? DragMark::Kind::kLimitReached : DragMark::Kind::kLimit;
    marks.push_back({kind, barAcross(*at, along, halfLengthPx(kind))});
  };
  if (slope) {
    const auto placeOf = [&](double at) { return screenAt(*slope * (at - startValue)); };
    addTicks(parameter, value, placeOf, marks);
    for (const double limit : {parameter.min, parameter.max}) addLimit(limit, *slope * (limit - startValue));
    return;
  }
  // Ends that were met on the way, each once.
  const auto end = std::ranges::find(tried.known(), value, &std::pair<double, std::optional<double>>::first);
  const auto handle = screenAt(value == startValue ? 0.0 : end != tried.known().end() ? end->second.value_or(0.0) : endAt(value).value_or(0.0));
  std::optional<Vec2> last;
  for (const auto& [at, endM] : tried.known()) {
    if (at == parameter.min || at == parameter.max) addLimit(at, endM);
    const auto place = endM ? screenAt(*endM) : std::nullopt;
    if (!place || !handle || (last && glm::length(*place - *last) < kTickGapPx)) continue;
    last = place;
    const double strength = 1.0 - glm::length(*place - *handle) / kTickReachPx;
    if (strength > 0) marks.push_back({DragMark::Kind::kTick, barAcross(*place, along, halfLengthPx(DragMark::Kind::kTick)), strength});
  }
}

std::optional<PlacedLine> HandleDrag::lineOn(const Scene& scene, const Values& values, const View& view) const {
  const auto tracked = track(scene);
  if (!tracked) return std::nullopt;
  PlacedLine line = line_;
  line.scope = tracked->scope;
  line.base = tracked->base;
  line.lengthM = tracked->base.length();

  const Vec3& carrier = line_.line.start;
  if (line_.placement == PlacementKind::kInside) {
    line.line = tracked->base;
  } else if (parallel(tracked->base, direction_)) {
    line.line.start = carrier + direction_ * glm::dot(tracked->base.start - carrier, direction_);
    line.line.end = carrier + direction_ * glm::dot(tracked->base.end - carrier, direction_);
  } else {
    // The model turned the scope: no line on the old carrier measures it, so the line goes with its base.
    const Vec3 offset = line_.line.start - line_.base.start;
    line.line = {tracked->base.start + offset, tracked->base.end + offset};
  }

  line.value = values.at(line.parameter);
  line.text = labelText(model_->parameters()[line.parameter], line.value);
  if (!canProject(line, view)) return std::nullopt;
  std::optional<LabelAnchor> anchor = labelAnchor_;
  if (anchor) anchor->size = labelSizePx(line.text);
  projectLine(line, view, anchor);
  return line;
}

}  // namespace dimline
