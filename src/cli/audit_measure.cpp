#include "cli/audit_measure.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/audit_geometry.h"
#include "cli/audit_odds.h"
#include "core/constants.h"
#include "core/text.h"

namespace dimline {

namespace {

constexpr double kLeastGapPx = 29.5;
constexpr double kOffsetOffence = 1.5;
constexpr double kLengthsDiffer = 0.01;
constexpr double kNearerPx = 1.0;

std::string px(double value) { return formatFixed(value, 1) + " px"; }

/// One frame's measuring: what its parts share.
class FrameAudit {
public:
  FrameAudit(const AuditedFrame& frame, const FrameName& name, AuditTally& tally)
      : frame_(frame), layout_(*frame.layout), lines_(frame.layout->lines), name_(name), tally_(tally) {
    for (const PlacedHandle& handle : layout_.others) arcs_.push_back(drawnArc(handle, layout_.view));
  }

  void againstModel();
  void againstEachOther();
  void againstViewport();
  void nesting();
  void otherHandles();
  void searches();
  void unshown();

private:
  [[nodiscard]] const std::string& nameOf(std::size_t line) const {
    return frame_.model->parameters()[lines_[line].parameter].name;
  }
  [[nodiscard]] const std::string& otherName(std::size_t other) const {
    return frame_.model->parameters()[layout_.others[other].parameter].name;
  }
  [[nodiscard]] std::string names(std::size_t a, std::size_t b) const {
    return parameterNames(*frame_.model, lines_[a].parameter, lines_[b].parameter);
  }
  [[nodiscard]] bool leavesViewport(const Box2& box) const {
    return leavesViewport(box.min) || leavesViewport(box.max);
  }
  [[nodiscard]] bool leavesViewport(const Vec2& p) const {
    const Box2 viewport = layout_.view.viewport();
    return !(p.x >= viewport.min.x && p.y >= viewport.min.y && p.x <= viewport.max.x && p.y <= viewport.max.y);
  }
  void offend(AuditRow row, const std::string& who, double badness, const std::string& what, bool atOdds = false) {
    tally_.offend(row, who, badness, name_, what, atOdds);
  }
  void otherHandleOutside(std::size_t i);
  void overExtensions(std::size_t a);
  void crossing(std::size_t a, std::size_t b);
  void labels(std::size_t a, std::size_t b);
  void distance(std::size_t a, std::size_t b);

  const AuditedFrame& frame_;
  const Layout& layout_;
  const std::vector<PlacedLine>& lines_;
  std::vector<DrawnArc> arcs_;  ///< one for each of the layout's others
  const FrameName& name_;
  AuditTally& tally_;
};

void FrameAudit::againstModel() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const PlacedLine& line = lines_[i];
    if (!isOutside(line)) continue;
    tally_.judge(AuditRow::kCrossesModel);
    const bool crosses = frame_.mask->crosses(line.lineScreen);
    if (crosses) offend(AuditRow::kCrossesModel, nameOf(i), 0, "crosses the model");
    const double away = frame_.mask->distancePx(line.lineScreen);
    tally_.measure(AuditRow::kModelDistance, away);
    if (away < kLeastGapPx)
      offend(AuditRow::kModelDistance, nameOf(i), kLeastGapPx - away, px(away) + " from the model");
    if (!line.label) continue;
    tally_.judge(AuditRow::kTouchesModel);
    if (frame_.mask->touches(*line.label)) offend(AuditRow::kTouchesModel, nameOf(i), 0, "label on the model");
  }
}

void FrameAudit::againstEachOther() {
  for (std::size_t a = 0; a < lines_.size(); ++a) {
    overExtensions(a);
    for (std::size_t b = a + 1; b < lines_.size(); ++b) {
      crossing(a, b);
      labels(a, b);
      distance(a, b);
    }
  }
}

/// A line over another's extension lines, or over the arms of an arc: however many, one offence.
void FrameAudit::overExtensions(std::size_t a) {
  tally_.judge(AuditRow::kExtensionCrossings);
  const auto crosses = [&](const Segment2& s) { return crossEachOther(lines_[a].lineScreen, s); };
  for (std::size_t b = 0; b < lines_.size(); ++b) {
    if (b == a) continue;
    for (const auto* extension : {&lines_[b].extensionStart, &lines_[b].extensionEnd}) {
      for (std::size_t k = 1; k < extension->size(); ++k) {
        if (!crosses({(*extension)[k - 1], (*extension)[k]})) continue;
        return offend(AuditRow::kExtensionCrossings, nameOf(a) + " over " + nameOf(b), 0, "crosses an extension line");
      }
    }
  }
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    if (std::ranges::none_of(arcs_[i].arms, crosses)) continue;
    return offend(AuditRow::kExtensionCrossings, nameOf(a) + " over " + otherName(i), 0, "crosses an arm of the angle");
  }
}

void FrameAudit::crossing(std::size_t a, std::size_t b) {
  tally_.judge(AuditRow::kLineCrossings);
  const Segment2& first = lines_[a].lineScreen;
  const Segment2& second = lines_[b].lineScreen;
  const bool cross = crossEachOther(first, second);
  if (!cross && !lieOnEachOther(first, second)) return;
  const bool inside = !isOutside(lines_[a]) && !isOutside(lines_[b]);
  const bool must = inside && mustCross(frame_, a, b);
  offend(AuditRow::kLineCrossings, names(a, b), inside ? 0 : 1,
         std::string(cross ? "cross" : "lie on each other") + (inside ? ", both inside" : ""), must);
}

void FrameAudit::labels(std::size_t a, std::size_t b) {
  const auto& labelA = lines_[a].label;
  const auto& labelB = lines_[b].label;
  if ((!isOutside(lines_[a]) && !isOutside(lines_[b])) || (!labelA && !labelB)) return;
  tally_.judge(AuditRow::kLabelOverlaps);
  if (labelA && labelB && overlap(*labelA, *labelB)) {
    offend(AuditRow::kLabelOverlaps, names(a, b), 2, "label on label");
  } else if ((labelA && enters(lines_[b].lineScreen, *labelA)) || (labelB && enters(lines_[a].lineScreen, *labelB))) {
    offend(AuditRow::kLabelOverlaps, names(a, b), 1, "label on line");
  }
}

void FrameAudit::distance(std::size_t a, std::size_t b) {
  const PlacedLine& first = lines_[a];
  const PlacedLine& second = lines_[b];
  if (!isOutside(first) || !isOutside(second) || !parallel(first, second)) return;
  if (onOneGuide(first, second, frame_.scene->bounds.diagonal())) return;
  const auto shared = beside(first.lineScreen, second.lineScreen);
  if (!shared) return;
  const double gap = gapPx(shared->a, shared->b);
  tally_.measure(AuditRow::kLineDistance, gap);
  if (gap < kLeastGapPx) offend(AuditRow::kLineDistance, names(a, b), kLeastGapPx - gap, px(gap) + " apart");
}

/// Lines that stand together where nesting is judged: one line, or the members of a chain.
struct Nested {
  std::vector<std::size_t> lines;
  double lengthM = 0;  ///< mean
};

/// Which of two lines is nearer to the model: below 0 the first, above 0 the second, by so many px; nothing when they
/// are not beside each other on one side.
std::optional<double> nearerBy(const PlacedLine& a, const PlacedLine& b, double modelSizeM) {
  if (!parallel(a, b) || onOneGuide(a, b, modelSizeM)) return std::nullopt;
  const auto shared = beside(a.lineScreen, b.lineScreen);
  if (!shared) return std::nullopt;
  const double outA = glm::dot(a.lineScreen.middle() - a.baseScreen.middle(), shared->across);
  const double outB = glm::dot(b.lineScreen.middle() - b.baseScreen.middle(), shared->across);
  if (outA * outB <= 0) return std::nullopt;
  const double side = outA > 0 ? 1 : -1;
  const double by = side * glm::dot(shared->a.middle() - shared->b.middle(), shared->across);
  const Vec2 beyond =
      by < 0 ? a.lineScreen.middle() - b.baseScreen.middle() : b.lineScreen.middle() - a.baseScreen.middle();
  if (side * glm::dot(beyond, shared->across) <= 0) return std::nullopt;
  return by;
}

void FrameAudit::nesting() {
  std::map<std::int64_t, Nested> groups;  // chains by their id, lines of their own by a number below 0
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!isOutside(lines_[i])) continue;
    Nested& group = groups[lines_[i].chain >= 0 ? lines_[i].chain : -1 - static_cast<std::int64_t>(i)];
    group.lines.push_back(i);
    group.lengthM += lines_[i].lengthM;
  }
  std::vector<Nested> all;
  for (auto& [key, group] : groups) {
    group.lengthM /= static_cast<double>(group.lines.size());
    all.push_back(group);
  }
  for (std::size_t g = 0; g < all.size(); ++g) {
    for (std::size_t h = 0; h < all.size(); ++h) {
      if (all[g].lengthM <= all[h].lengthM * (1 + kLengthsDiffer)) continue;  // g is the longer
      bool judged = false;
      double worstPx = 0;
      for (const std::size_t a : all[g].lines) {
        for (const std::size_t b : all[h].lines) {
          const auto by = nearerBy(lines_[a], lines_[b], frame_.scene->bounds.diagonal());
          judged = judged || by.has_value();
          if (by) worstPx = std::max(worstPx, -*by);
        }
      }
      if (judged) tally_.judge(AuditRow::kNesting);
      if (worstPx > kNearerPx) {
        const std::size_t a = all[g].lines.front();
        const std::size_t b = all[h].lines.front();
        offend(AuditRow::kNesting, nameOf(a) + " within " + nameOf(b), worstPx,
               formatFixed(all[g].lengthM, 2) + " m is " + px(worstPx) + " nearer than " +
                   formatFixed(all[h].lengthM, 2) + " m");
      }
    }
  }
}

void FrameAudit::againstViewport() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const PlacedLine& line = lines_[i];
    if (!isOutside(line)) continue;
    tally_.judge(AuditRow::kLeavesViewport);
    if (leavesViewport(line.lineScreen.start) || leavesViewport(line.lineScreen.end)) {
      offend(AuditRow::kLeavesViewport, nameOf(i), 0, "an end leaves the viewport");
    } else if (line.label && leavesViewport(*line.label)) {
      offend(AuditRow::kLeavesViewport, nameOf(i), 0, "the label leaves the viewport");
    }
  }
}

void FrameAudit::otherHandleOutside(std::size_t i) {
  const Box2& box = layout_.others[i].box;
  const auto anyOfArc = [&](const auto& offends) {
    return std::ranges::any_of(arcs_[i].curve, offends) || std::ranges::any_of(arcs_[i].arms, offends);
  };
  tally_.judge(AuditRow::kTouchesModel);
  if (frame_.mask->touches(box)) {
    offend(AuditRow::kTouchesModel, otherName(i), 1, "handle on the model");
  } else if (anyOfArc([&](const Segment2& s) { return frame_.mask->distancePx(s) == 0; })) {
    offend(AuditRow::kTouchesModel, otherName(i), 1, "arc on the model");
  }
  tally_.judge(AuditRow::kLeavesViewport);
  if (leavesViewport(box)) {
    offend(AuditRow::kLeavesViewport, otherName(i), 1, "the handle leaves the viewport");
  } else if (anyOfArc([&](const Segment2& s) { return leavesViewport(s.start) || leavesViewport(s.end); })) {
    offend(AuditRow::kLeavesViewport, otherName(i), 1, "the arc leaves the viewport");
  }
}

/// Handles that are no lines: against the model, the viewport, lines, labels and each other.
void FrameAudit::otherHandles() {
  const auto inside = [](const PlacedHandle& handle) { return handle.placement == PlacementKind::kInside; };
  const auto runsInto = [](const std::vector<Segment2>& curve, const Box2& box) {
    return std::ranges::any_of(curve, [&](const Segment2& s) { return enters(s, box); });
  };
  const auto runsOver = [](const std::vector<Segment2>& curve, const Segment2& line) {
    return std::ranges::any_of(curve, [&](const Segment2& s) { return crossEachOther(s, line); });
  };
  for (std::size_t i = 0; i < layout_.others.size(); ++i) {
    const PlacedHandle& handle = layout_.others[i];
    const std::vector<Segment2>& curve = arcs_[i].curve;
    if (!inside(handle)) otherHandleOutside(i);
    const auto judge = [&](std::size_t otherParameter, bool bothInside, const char* what) {
      if (bothInside) return;
      tally_.judge(AuditRow::kLabelOverlaps);
      if (what == nullptr) return;
      offend(AuditRow::kLabelOverlaps, parameterNames(*frame_.model, handle.parameter, otherParameter), 1, what);
    };
    for (const PlacedLine& line : lines_) {
      const char* what = nullptr;
      if (line.label && overlap(*line.label, handle.box)) {
        what = "handle on label";
      } else if (line.label && runsInto(curve, *line.label)) {
        what = "arc on label";
      } else if (enters(line.lineScreen, handle.box)) {
        what = "handle on line";
      } else if (runsOver(curve, line.lineScreen)) {
        what = "arc on line";
      }
      judge(line.parameter, inside(handle) && !isOutside(line), what);
    }
    for (std::size_t k = i + 1; k < layout_.others.size(); ++k) {
      const PlacedHandle& other = layout_.others[k];
      const bool arcOnHandle = runsInto(curve, other.box) || runsInto(arcs_[k].curve, handle.box);
      judge(other.parameter, inside(handle) && inside(other),
            overlap(handle.box, other.box) ? "handle on handle"
            : arcOnHandle                  ? "arc on handle"
                                           : nullptr);
    }
  }
}

void FrameAudit::searches() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (const auto ratio = offsetRatio(frame_, i)) {
      tally_.measure(AuditRow::kOffset, *ratio);
      if (*ratio > kOffsetOffence)
        offend(AuditRow::kOffset, nameOf(i), *ratio, formatFixed(*ratio, 2) + " times the least offset");
    }
    if (isOutside(lines_[i]) || frame_.model->annotations[lines_[i].parameter]->slip == Slip::kNone) continue;
    tally_.judge(AuditRow::kNeedlesslyInside);
    if (const auto place = outsidePlace(frame_, i)) {
      const Vec2 middle = place->screen.middle();
      offend(AuditRow::kNeedlesslyInside, nameOf(i), place->seesAnEdge ? 1 : 0,
             "there is room around (" + formatFixed(middle.x, 0) + ", " + formatFixed(middle.y, 0) + ")" +
                 (place->seesAnEdge ? "" : ", which no viewport edge sees whole"),
             frame_.odds != nullptr && frame_.odds->lacksLastingRoom(lines_[i].parameter, frame_.number));
    }
  }
}

void FrameAudit::unshown() {
  std::vector<char> shown(frame_.model->parameters().size(), 0);
  for (const PlacedLine& line : lines_) shown[line.parameter] = 1;
  for (const PlacedHandle& handle : layout_.others) shown[handle.parameter] = 1;
  std::size_t annotated = 0;
  for (const auto& annotation : frame_.model->annotations) annotated += annotation ? 1 : 0;
  const double areaEach =
      layout_.view.widthPx() * layout_.view.heightPx() / static_cast<double>(std::max<std::size_t>(annotated, 1));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!frame_.model->annotations[i]) continue;
    tally_.judge(AuditRow::kUnshown);
    if (shown[i] != 0) continue;
    const auto hidden = std::ranges::find(layout_.hidden, i, &HiddenParameter::parameter);
    const bool listed = hidden != layout_.hidden.end();
    if (listed && hidden->reason == HiddenReason::kCrowded && areaEach < kCrowdedPx2) continue;
    if (const auto scope = scopeInPlainView(frame_, i)) {
      offend(AuditRow::kUnshown, frame_.model->parameters()[i].name, 0,
             frame_.scene->scopes[*scope].name + " " + std::to_string(frame_.scene->scopes[*scope].index) +
                 " is in plain view, the reason given is " + std::string(listed ? name(hidden->reason) : "none"),
             frame_.odds != nullptr && frame_.odds->isBrieflyInView(i, frame_.number));
    }
  }
}

}  // namespace

std::string parameterNames(const Model& model, std::size_t a, std::size_t b) {
  const auto [first, second] = std::minmax({model.parameters()[a].name, model.parameters()[b].name});
  return first + " × " + second;
}

void measureFrame(const AuditedFrame& frame, const FrameName& name, bool searching, AuditTally& tally) {
  FrameAudit audit(frame, name, tally);
  audit.againstModel();
  audit.againstEachOther();
  audit.againstViewport();
  audit.nesting();
  audit.otherHandles();
  if (searching) audit.searches();
  audit.unshown();
}

}  // namespace dimline
