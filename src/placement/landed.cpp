#include "placement/landed.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "placement/jogs.h"

namespace dimline {

namespace {

/// Lines within 10 degrees of each other look parallel; beside each other they are along more pixels than these.
constexpr double kParallelCos = 0.985;
constexpr double kBesidePx = 2.0;
/// By this factor a line must be longer, in the world, to have to lie outside another.
constexpr double kLonger = 1.01;

/// Whether two segments share a stretch of more than kExtensionClearancePx along which they are less than kSameLinePx apart.
bool lieOnEachOther(const Segment2& a, const Segment2& b) {
  const double length = a.length();
  if (!(length > 0)) return false;
  const Vec2 along = (a.end - a.start) / length;
  const auto aside = [&](const Vec2& p) { return std::abs(along.x * (p.y - a.start.y) - along.y * (p.x - a.start.x)); };
  if (aside(b.start) > kSameLinePx || aside(b.end) > kSameLinePx) return false;
  const auto [from, to] = std::minmax({glm::dot(b.start - a.start, along), glm::dot(b.end - a.start, along)});
  return std::min(to, length) - std::max(from, 0.0) > kExtensionClearancePx;
}

/// Whether two segments are one but for rounding.
bool same(const Segment2& a, const Segment2& b) {
  constexpr double kRoundingPx = 1e-6;
  const auto near = [](const Vec2& p, const Vec2& q) { return std::abs(p.x - q.x) < kRoundingPx && std::abs(p.y - q.y) < kRoundingPx; };
  return near(a.start, b.start) && near(a.end, b.end);
}

}  // namespace

bool Landed::hasExtension(const Segment2& part, int parameter) const {
  return std::ranges::any_of(extensions_, [&](const Extension& e) { return e.parameter == parameter && same(e.segment, part); });
}

void Landed::clear() {
  lines_.clear();
  extensions_.clear();
  labels_.clear();
}

void Landed::makeRoomLike(const Landed& other) {
  dimline::makeRoomLike(other.lines_, lines_);
  dimline::makeRoomLike(other.extensions_, extensions_);
  dimline::makeRoomLike(other.labels_, labels_);
}

void Landed::add(const PlacedLine& line, int guide) {
  const int parameter = static_cast<int>(line.parameter);
  lines_.push_back({line.lineScreen, guide, line.lineScreen.middle() - line.baseScreen.middle(), parameter, line.lengthM});
  for (const auto* extension : {&line.extensionStart, &line.extensionEnd}) {
    for (std::size_t i = 1; i < extension->size(); ++i) {
      const Segment2 part{(*extension)[i - 1], (*extension)[i]};
      const auto kind = i + 1 == extension->size() ? Extension::Kind::kLast : Extension::Kind::kRigid;
      if (!hasExtension(part, parameter)) extensions_.push_back({part, parameter, kind});
    }
  }
  if (line.label) labels_.push_back(*line.label);
}

void Landed::add(const Segment2& base, const Segment2& foot, const Segment2& line) {
  lines_.push_back({line, -1, line.middle() - base.middle()});
  const auto parts = extensionParts(base, foot, line);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].start == parts[i].end || hasExtension(parts[i])) continue;
    extensions_.push_back({.segment = parts[i], .kind = isLastPart(i) ? Extension::Kind::kLast : Extension::Kind::kRigid});
  }
}

void Landed::reserve(const PlacedLine& line) {
  extensions_.push_back({line.lineScreen, static_cast<int>(line.parameter)});
  if (line.label) labels_.push_back(*line.label);
}

void Landed::release(const PlacedLine& line) {
  std::erase_if(extensions_, [&](const Extension& e) { return e.parameter == static_cast<int>(line.parameter); });
  if (line.label) removeLabel(*line.label);
}

void Landed::removeLabel(const Box2& label) {
  std::erase_if(labels_, [&](const Box2& other) { return other.min == label.min && other.max == label.max; });
}

void Landed::backTo(const Mark& mark) {
  lines_.resize(mark.lines);
  extensions_.resize(mark.extensions);
  labels_.resize(mark.labels);
}

void Landed::add(const PlacedHandle& handle, const View& view) {
  labels_.push_back(handle.box);
  if (!handle.arc) {
    if (!handle.box.contains(handle.anchor)) extensions_.push_back({.segment = {handle.anchor, handle.box.center()}, .kind = Extension::Kind::kThread});
    return;
  }
  // Chords and the arms come near enough to an arc for what keeps away from it: one of 20 degrees is 2 px off at most (kArcMaxRadiusPx).
  const Arc& arc = *handle.arc;
  const int chords = std::max(2, static_cast<int>(std::ceil(std::abs(arc.angleRad) / (20 * kRadPerDeg))));
  const Vec2 center = view.toScreen(arc.center);
  Vec2 last = view.toScreen(arc.at(0));
  extensions_.push_back({{center, last}});
  for (int chord = 1; chord <= chords; ++chord) {
    const Vec2 next = view.toScreen(arc.at(arc.angleRad * chord / chords));
    lines_.push_back({{last, next}, -1, Vec2(0.0)});
    last = next;
  }
  extensions_.push_back({{center, last}});
}

Landed::Crossings Landed::crossings(const Segment2& base, const Segment2& foot, const Segment2& line) const {
  Crossings found;
  // Jogs are looked for only where something crosses, which is seldom.
  const auto add = [&](const Segment2& part, bool isLine, bool isLast) {
    const bool overLine = crossesLine(part);
    const bool overExtension = crossesExtension(part);
    found.lines = found.lines || overLine || overExtension;
    found.extensions = found.extensions || (isLine ? overExtension && findUnder(part) != nullptr : overLine && isUnderAny(part, isLast));
    found.labels = found.labels || coversLabel(part);
  };
  add(line, true, false);
  const auto parts = extensionParts(base, foot, line);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].start == parts[i].end || (i > 0 && same(parts[i], parts[i - 1]))) continue;
    add(parts[i], false, isLastPart(i));
  }
  return found;
}

Landed::Tangle Landed::tangle(const Segment2& line, std::span<const Segment2> extensions) const {
  Tangle tangle;
  if (const Extension* under = findUnder(line)) tangle = {1, under->parameter};
  for (const Line& l : lines_) {
    bool across = false;
    for (std::size_t i = 0; i < extensions.size() && !across; ++i) across = runsAcross(l.segment, extensions[i], isLastPart(i));
    if (!across) continue;
    ++tangle.lines;
    tangle.parameter = l.parameter;
  }
  return tangle;
}

const Landed::Extension* Landed::findUnder(const Segment2& line) const {
  const auto under = std::ranges::find_if(extensions_, [&](const Extension& e) { return runsAcross(line, e.segment, e.kind == Extension::Kind::kLast); });
  return under == extensions_.end() ? nullptr : &*under;
}

bool Landed::isUnderAny(const Segment2& part, bool isLast) const {
  return std::ranges::any_of(lines_, [&](const Line& l) { return runsAcross(l.segment, part, isLast); });
}

bool Landed::runsAcross(const Segment2& line, const Segment2& part, bool isLast) const {
  return segmentsCross(line, part, kCrossingPx) && !(isLast && jogPast(line, part, *this));
}

std::optional<Vec2> Landed::jogOf(const Segment2& lastPart) const {
  const auto crossed = std::ranges::find_if(lines_, [&](const Line& l) { return segmentsCross(l.segment, lastPart, kCrossingPx); });
  return crossed == lines_.end() ? std::nullopt : jogPast(crossed->segment, lastPart, *this);
}

Landed::Crossings Landed::extensionCrossings(std::span<const Segment2> extensions) const {
  Crossings found;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    found.extensions = found.extensions || isUnderAny(extensions[i], isLastPart(i));
    found.labels = found.labels || coversLabel(extensions[i]);
  }
  return found;
}

bool Landed::nestsWrongly(const Segment2& base, const Segment2& line, double lengthM, int guide) const {
  const double length = line.length();
  if (!(length > 0)) return false;
  const Vec2 along = (line.end - line.start) / length;
  const Vec2 across(-along.y, along.x);
  const double side = glm::dot(line.middle() - base.middle(), across) > 0 ? 1.0 : -1.0;
  const double from = glm::dot(line.start, along);
  return std::ranges::any_of(lines_, [&](const Line& l) {
    if (guide >= 0 && l.guide == guide) return false;
    if (std::abs(glm::dot(l.segment.end - l.segment.start, along)) < kParallelCos * l.segment.length()) return false;
    const auto [otherFrom, otherTo] = std::minmax({glm::dot(l.segment.start, along), glm::dot(l.segment.end, along)});
    if (std::min(from + length, otherTo) - std::max(from, otherFrom) < kBesidePx) return false;
    const double nearerPx = side * glm::dot(l.segment.middle() - line.middle(), across);
    const bool wrongly = nearerPx > 0 ? lengthM > kLonger * l.lengthM : l.lengthM > kLonger * lengthM;
    return wrongly && side * glm::dot(l.away, across) > 0;
  });
}

bool Landed::comesWithin(double px, const Segment2& line) const {
  return std::ranges::any_of(lines_, [&](const Line& l) { return distanceBetween(l.segment, line) < px; });
}

bool Landed::liesOnLine(const Segment2& segment) const {
  return std::ranges::any_of(lines_, [&](const Line& l) { return lieOnEachOther(segment, l.segment); });
}

bool Landed::runsInto(const Segment2& segment) const {
  return liesOnLine(segment) || crossesLine(segment);
}

bool Landed::crossesLine(const Segment2& segment) const {
  return std::ranges::any_of(lines_, [&](const Line& l) { return segmentsCross(segment, l.segment, kCrossingPx); });
}

bool Landed::crossesExtension(const Segment2& segment) const {
  return std::ranges::any_of(extensions_, [&](const Extension& e) { return segmentsCross(segment, e.segment, kCrossingPx); });
}

bool Landed::runsAlongExtension(const Segment2& segment) const {
  return std::ranges::any_of(extensions_, [&](const Extension& e) { return lieOnEachOther(segment, e.segment); });
}

Landed::Across Landed::across(const Segment2& segment) const {
  const auto crossed = [&](const auto& l) { return segmentsCross(segment, l.segment, kCrossingPx); };
  Across across{.lines = static_cast<int>(std::ranges::count_if(lines_, crossed)),
                .labels = static_cast<int>(std::ranges::count_if(labels_, [&](const Box2& label) { return meets(segment, label); }))};
  for (const Extension& e : extensions_) {
    if (crossed(e)) ++(e.kind == Extension::Kind::kThread ? across.threads : across.extensions);
  }
  return across;
}

bool Landed::coversLabel(const Segment2& segment) const {
  return std::ranges::any_of(labels_, [&](const Box2& label) { return meets(segment, label); });
}

bool Landed::hasRoom(const Segment2& line, int guide) const {
  return std::ranges::none_of(lines_,
                              [&](const Line& l) { return l.guide != guide && distanceBetween(l.segment, line) < kHandleSpacingPx; }) &&
         !crossesExtension(line) &&
         std::ranges::none_of(labels_, [&](const Box2& label) { return meets(line, label.grown(kLabelClearancePx)); });
}

bool Landed::clearsExtensions(const Box2& label) const {
  return std::ranges::none_of(extensions_, [grown = label.grown(kLabelClearancePx)](const Extension& e) { return meets(e.segment, grown); });
}

bool Landed::hasRoom(const Box2& label, bool overExtensions, int own) const {
  const Box2 grown = label.grown(kLabelClearancePx);
  return std::ranges::none_of(lines_, [&](const Line& l) { return l.parameter != own && meets(l.segment, grown); }) && (overExtensions || clearsExtensions(label)) &&
         std::ranges::none_of(labels_, [&](const Box2& other) { return grown.overlaps(other); });
}

}  // namespace dimline
