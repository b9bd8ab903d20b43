#include "editing/handle_drag.h"

#include <algorithm>
#include <array>
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

/// px. Under perspective ticks come nearer to each other with the distance; so near that they would be one stroke, one does for both.
constexpr double kLeastTickGapPx = 2.5;

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
  if (!drag.baseLine_) return std::nullopt;
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

double HandleDrag::valueAmong(const Values& others, const Vec2& pointer, const View& view, Snap snap) {
  const double alone = valueAt(pointer, view, snap);
  Values changed = others;
  const double startValue = startValues_.at(line_.parameter);
  changed.set(line_.parameter, startValue);
  const Vec2 screen = pointer - grabOffset_;
  if (changed == startValues_ || !std::isfinite(screen.x) || !std::isfinite(screen.y)) return alone;
  // Most parameters leave each other's lines where they are.
  const auto was = search(snap).endAt(alone, [this](double value) { return endAt(value); });
  const auto is = endIn(changed, alone);
  if (was && is && std::abs(*is - *was) <= toleranceM_) return alone;
  // Here it is another rule, which starts where the value of the start ends by now.
  const double fromM = endIn(changed, startValue).value_or(0.0);
  const Parameter& parameter = model_->parameters()[line_.parameter];
  ValueSearch among(snappedBy(parameter, snap), startValue, expectedSlope(parameter, line_, startValue, atEnd_), toleranceM_);
  lastValue_ = among.find(targetM(screen, view) - fromM, [&](double value) -> std::optional<double> {
    const auto end = endIn(changed, value);
    return end ? std::optional(*end - fromM) : std::nullopt;
  });
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

/// Where the dragged end goes (m along the carrier) when the parameter has that value and the others those.
std::optional<double> HandleDrag::endIn(const Values& others, double value) const {
  Values values = others;
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
  const BaseSegments segments = baseSegments(annotation(), scope.box, startView_);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double distanceM = glm::length(segments[i].start - line_.base.start) + glm::length(segments[i].end - line_.base.end);
    if (distanceM >= nearestM) continue;
    nearestM = distanceM;
    baseLine_ = i;
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
    const BaseSegments segments = baseSegments(annotation(), scope.box, startView_);
    if (!baseLine_ || *baseLine_ >= segments.size()) continue;
    const Segment& segment = segments[*baseLine_];
    double distanceM = glm::length(endOf(segment) - endOf(line_.base));
    // Round the corner of a building the same rule repeats something else.
    if (!parallel(segment, direction_)) distanceM += kElsewhereM;
    if (distanceM >= nearestM) continue;
    nearestM = distanceM;
    nearest = Tracked{i, segment};
  }
  if (nearest && count != scopeCount_) nearest->base = keptInPlace(nearest->base);
  return nearest;
}

/// A base line of the same length and direction, of which the end that is not dragged is where it was.
Segment HandleDrag::keptInPlace(const Segment& base) const {
  const Vec3 along = base.end - base.start;
  return atEnd_ ? Segment{line_.base.start, line_.base.start + along} : Segment{line_.base.end - along, line_.base.end};
}

struct HandleDrag::Nearby {
  struct Place {
    double number = 0;   ///< on the grid
    Vec2 at{0.0};
  };
  std::optional<Vec2> min, max;   ///< the range's ends, where they are in the picture
  std::vector<Place> ticks;       ///< in the order of their values
  bool shared = false;            ///< several values end at one place
  std::optional<double> unknown;  ///< the first value that is missing here, because its end is not known
};

HandleDrag::Nearby HandleDrag::lookNearby(double value, const PlacedLine& now, const View& view, Snap snap) {
  Nearby nearby;
  const Parameter parameter = snappedBy(model_->parameters()[line_.parameter], snap);
  const Reach reach = [this](double at) { return endAt(at); };
  ValueSearch& tried = search(snap);
  const auto straight = tried.straightSlope(reach);
  const double endNowM = straight ? 0.0 : tried.endAt(value, reach).value_or(0.0);
  const Vec3 tip = endOf(now.line);
  if (!view.inFrontOfNear(tip)) return nearby;
  const Vec2 handle = view.toScreen(tip);
  const auto placeAtM = [&](double endM) -> std::optional<Vec2> {
    const Vec3 place = tip + direction_ * (endM - endNowM);
    return view.inFrontOfNear(place) ? std::optional(view.toScreen(place)) : std::nullopt;
  };
  // Nothing for a value that is not known yet, and then, or when it has no end, no place.
  const auto placeOf = [&](double at) -> std::optional<std::optional<Vec2>> {
    if (straight) return placeAtM(*straight * (at - value));
    if (!tried.knows(at)) {
      if (!nearby.unknown) nearby.unknown = at;
      return std::nullopt;
    }
    const auto endM = tried.endAt(at, reach);
    return endM ? placeAtM(*endM) : std::nullopt;
  };
  const auto inPicture = [&](double at) -> std::optional<Vec2> {
    const auto place = placeOf(at).value_or(std::nullopt);
    return place && view.viewport().overlaps({*place, *place}) ? place : std::nullopt;
  };
  nearby.min = inPicture(parameter.min);
  nearby.max = inPicture(parameter.max);

  const auto grid = tickGrid(parameter, std::abs(tried.slope()) * parameter.step * screenMotion(view, tip, direction_).pxPerM);
  if (!grid) return nearby;
  const double nearest = grid->nearest(value);
  std::array<bool, 2> open{true, true};   // downwards and upwards
  for (int i = 0; i <= kMostTicks && (open[0] || open[1]); ++i) {
    for (const std::size_t up : {1U, 0U}) {
      if (!open[up] || (i == 0 && up == 0)) continue;
      const double n = nearest + (up != 0 ? i : -i);
      const double at = grid->at(n);
      const bool outside = at < parameter.min - 1e-9 * grid->step || at > parameter.max + 1e-9 * grid->step;
      if (outside && i == 0) continue;   // off the steps, beside a limit
      const auto place = outside ? std::nullopt : placeOf(snapValue(parameter, at));
      open[up] = place && (!*place || tickStrength(glm::length(**place - handle)) > 0);
      if (open[up] && *place) nearby.ticks.insert(up != 0 ? nearby.ticks.end() : nearby.ticks.begin(), Nearby::Place{n, **place});
    }
  }
  for (std::size_t i = 1; i < nearby.ticks.size() && !straight; ++i) {
    if (glm::length(nearby.ticks[i].at - nearby.ticks[i - 1].at) < kMovedPx) nearby.shared = true;
  }
  return nearby;
}

bool HandleDrag::learnNearby(double value, const PlacedLine& now, const View& view, Snap snap) {
  const auto unknown = lookNearby(value, now, view, snap).unknown;
  if (unknown) search(snap).endAt(*unknown, [this](double at) { return endAt(at); });
  return unknown.has_value();
}

void HandleDrag::addMarks(double value, const PlacedLine& now, const View& view, Snap snap, std::vector<DragMark>& marks) {
  const Segment2 old = view.toScreen(line_.line);
  const Vec2 along = glm::normalize(old.end - old.start);
  if (value != startValues_.at(line_.parameter)) addGhost(old, now.lineScreen, along, marks);

  const Nearby nearby = lookNearby(value, now, view, snap);
  const Vec2 handle = atEnd_ ? now.lineScreen.end : now.lineScreen.start;
  std::optional<Vec2> last;
  for (const Nearby::Place& tick : nearby.ticks) {
    if (last && glm::length(tick.at - *last) < kLeastTickGapPx) continue;
    last = tick.at;
    // Where values share places none of them is the fifth of anything.
    const auto kind = !nearby.shared && std::fmod(std::abs(tick.number), 5.0) == 0.0 ? DragMark::Kind::kLongTick : DragMark::Kind::kTick;
    marks.push_back({kind, barAcross(tick.at, along, halfLengthPx(kind)), tickStrength(glm::length(tick.at - handle))});
  }
  const Parameter& parameter = model_->parameters()[line_.parameter];
  for (const auto& [place, limit] : {std::pair{nearby.min, parameter.min}, std::pair{nearby.max, parameter.max}}) {
    if (!place) continue;
    const auto kind = value == limit ? DragMark::Kind::kLimitReached : DragMark::Kind::kLimit;
    marks.push_back({kind, barAcross(*place, along, halfLengthPx(kind))});
  }
}

std::optional<PlacedLine> HandleDrag::lineOn(const Scene& scene, const Values& values, const View& view) const {
  const auto tracked = track(scene);
  if (!tracked) return std::nullopt;
  PlacedLine line = line_;
  line.scope = tracked->scope;
  line.base = tracked->base;
  line.foot = {line_.foot.start + tracked->base.start - line_.base.start, line_.foot.end + tracked->base.end - line_.base.end};
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
