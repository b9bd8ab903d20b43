#include "placement/placer.h"

#include <algorithm>

#include "placement/candidates.h"
#include "placement/label_text.h"
#include "placement/labels.h"
#include "placement/score.h"
#include "placement/text_metrics.h"
#include "placement/visibility.h"

// Algorithm 1 of the paper, one parameter after the other. The fields stand twice: the model's own, against which labels are tested, and the
// padded ones, in which the model is grown by handleSpacing and every line that has landed by what later lines keep from it. A line that
// clears the padded fields therefore keeps its distance from everything, and no step after the query needs to add padding.

namespace dimline {

namespace {

/// A parameter with a dimension line, and the scopes it measures.
struct Measured {
  std::size_t parameter = 0;
  Annotation annotation;
  std::vector<std::size_t> scopes;   ///< indices into the scene's scopes
  double meanLengthM = 0;
  std::string text;                  ///< its label, for the value it was made of
  double textValue = 0;
  Vec2 textSize{0.0};
};

double meanBaseLength(const Annotation& annotation, const std::vector<Scope>& scopes, const std::vector<std::size_t>& measured) {
  double sum = 0;
  for (const std::size_t scope : measured) sum += meanBaseLengthM(annotation, scopes[scope].box);
  return measured.empty() ? 0.0 : sum / static_cast<double>(measured.size());
}

HiddenReason reasonFor(const BaseLineTally& tally, bool anyScope) {
  if (!anyScope) return HiddenReason::kNoScope;
  if (tally.foreshortened > 0) return HiddenReason::kForeshortened;
  if (tally.tooShort > 0) return HiddenReason::kTooShort;
  return HiddenReason::kOutOfView;
}

}  // namespace

struct Placer::State {
  std::vector<Parameter> parameters;
  std::vector<Scope> scopes;
  std::vector<Measured> order;        ///< shortest first
  std::vector<Identity> lastFrame;    ///< one a parameter; its `parameter` is always set, the rest as chosen

  // Memory of one frame, kept so that the next allocates nothing.
  DistanceFields padded;
  Landed landed;
  std::vector<UsableBaseLine> bases;
  std::vector<Candidate> candidates;
  std::vector<PlacedLine> spareLines;

  void placeParameter(Measured& measured, const View& view, const DistanceFields& model, double value, Layout& layout);
  bool settle(Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model, std::optional<Box2>& label);
  const Candidate* chooseOutside(const Measured& measured, const View& view, const DistanceFields& model, std::optional<Box2>& label);
  const Candidate* chooseInside(const Measured& measured, const View& view, std::optional<Box2>& label);
  void land(const PlacedLine& line);
  PlacedLine& appendLine(Layout& layout);
  void recycle(Layout& layout);
};

Placer::Placer() : state_(std::make_unique<State>()) {}
Placer::~Placer() = default;
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;

void Placer::forget() {
  for (std::size_t i = 0; i < state_->lastFrame.size(); ++i) {
    state_->lastFrame[i] = {.parameter = static_cast<std::int32_t>(i)};
  }
}

void Placer::setScene(const Model& model, const Scene& scene) {
  State& s = *state_;
  const auto sameName = [](const Parameter& a, const Parameter& b) { return a.name == b.name; };
  const bool sameModel = std::ranges::equal(s.parameters, model.parameters(), sameName);
  s.scopes = scene.scopes;
  if (!sameModel) {
    s.parameters.assign(model.parameters().begin(), model.parameters().end());
    s.lastFrame.resize(s.parameters.size());
    forget();
  }
  s.order.clear();
  for (std::size_t i = 0; i < s.parameters.size(); ++i) {
    const auto& annotation = model.annotations[i];
    if (!annotation || !isLine(annotation->type)) continue;
    Measured measured;
    measured.parameter = i;
    measured.annotation = *annotation;
    for (std::size_t scope = 0; scope < s.scopes.size(); ++scope) {
      if (s.scopes[scope].name == annotation->scope) measured.scopes.push_back(scope);
    }
    measured.meanLengthM = meanBaseLength(*annotation, s.scopes, measured.scopes);
    measured.textValue = std::numeric_limits<double>::quiet_NaN();   // equal to no value: the text is made in the first frame
    s.order.push_back(std::move(measured));
  }
  std::ranges::stable_sort(s.order, {}, &Measured::meanLengthM);
}

void Placer::place(const View& view, const DistanceFields& fields, const Values& values, Layout& layout) {
  State& s = *state_;
  s.recycle(layout);
  layout.view = view;
  layout.hidden.clear();
  layout.visibleScopes.clear();
  s.landed.clear();
  pad(fields, kHandleSpacingPx, s.padded);
  for (std::size_t i = 0; i < s.scopes.size(); ++i) {
    if (inView(view, s.scopes[i].box)) layout.visibleScopes.push_back(i);
  }
  for (Measured& measured : s.order) s.placeParameter(measured, view, fields, values.at(measured.parameter), layout);
}

/// getDimensionLine of algorithm 1.
void Placer::State::placeParameter(Measured& measured, const View& view, const DistanceFields& model, double value, Layout& layout) {
  bases.clear();
  BaseLineTally tally;
  for (const std::size_t scope : measured.scopes) gatherBaseLines(measured.annotation, scopes[scope], scope, view, bases, tally);
  Identity& last = lastFrame[measured.parameter];
  if (bases.empty()) {
    layout.hidden.push_back({measured.parameter, reasonFor(tally, !measured.scopes.empty())});
    last = {.parameter = last.parameter};
    return;
  }
  if (measured.textValue != value) {
    measured.text = labelText(parameters[measured.parameter], value);
    measured.textValue = value;
    measured.textSize = labelSizePx(measured.text);
  }

  std::optional<Box2> label;
  const Candidate* chosen = chooseOutside(measured, view, model, label);
  const bool outside = chosen != nullptr;
  if (!outside) chosen = chooseInside(measured, view, label);

  last = chosen->identity;
  PlacedLine& line = appendLine(layout);
  line.parameter = measured.parameter;
  line.scope = chosen->scope;
  line.identity = chosen->identity;
  line.placement = outside ? PlacementKind::kOutside : PlacementKind::kInside;
  line.planeKind = chosen->plane.kind;
  line.facing = chosen->plane.facing;
  line.plane = chosen->plane.plane;
  line.base = chosen->base;
  line.line = chosen->line;
  line.baseScreen = chosen->baseScreen;
  line.lineScreen = chosen->lineScreen;
  line.extensionStart.clear();
  line.extensionEnd.clear();
  if (outside) {
    for (const Vec2& p : {chosen->baseScreen.start, chosen->lineScreen.start}) line.extensionStart.push_back(p);
    for (const Vec2& p : {chosen->baseScreen.end, chosen->lineScreen.end}) line.extensionEnd.push_back(p);
  }
  line.indirect = measured.annotation.indirect;
  line.lengthM = chosen->base.length();
  line.value = value;
  line.text = measured.text;
  line.label = label;
  line.handles.clear();
  line.handles.push_back({true, chosen->lineScreen.end});
  if (measured.annotation.ends == HandleEnds::kBoth) line.handles.push_back({false, chosen->lineScreen.start});
  land(line);
}

/// Gives the candidate's label a place, moving the line further out where it has none. False when there is none.
bool Placer::State::settle(Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model,
                           std::optional<Box2>& label) {
  for (int step = 0; step <= kLabelPushSteps; ++step) {
    if (step > 0 && !pushOutward(candidate, kLabelPushStepPx, view)) return false;
    label = placeLabel({.line = candidate.lineScreen,
                        .textSize = measured.textSize,
                        .outward = candidate.lineScreen.middle() - candidate.baseScreen.middle(),
                        .model = &model},
                       landed, view.viewport());
    if (label) return true;
  }
  return false;
}

/// computeWithSilhouette and computeWinner. The Intersect term and the label are dear, so they are looked at only for candidates that could still win: the
/// term only lowers a score, and the candidates come in descending order.
const Candidate* Placer::State::chooseOutside(const Measured& measured, const View& view, const DistanceFields& model,
                                              std::optional<Box2>& label) {
  candidates.clear();
  for (const UsableBaseLine& base : bases) {
    gatherOutsideCandidates(measured.annotation, base, view, padded, lastFrame[measured.parameter], candidates);
  }
  // Equal scores keep the order of their making, so that the same frame always gives the same layout.
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score
                              : std::tie(a.identity.scopeIndex, a.identity.baseLine, a.identity.plane, a.identity.direction) <
                                    std::tie(b.identity.scopeIndex, b.identity.baseLine, b.identity.plane, b.identity.direction);
  });
  const Candidate* best = nullptr;
  double bestScore = 0;
  for (Candidate& candidate : candidates) {
    if (best != nullptr && bestScore >= candidate.score) break;
    double candidateScore = candidate.score;
    if (landed.crosses(candidate.baseScreen, candidate.lineScreen)) candidateScore += kScoreIntersect;
    if (best != nullptr && bestScore >= candidateScore) continue;
    std::optional<Box2> candidateLabel;
    if (!settle(candidate, measured, view, model, candidateLabel)) continue;
    best = &candidate;
    bestScore = candidateScore;
    label = candidateLabel;
  }
  return best;
}

/// The fallback: the base lines themselves. A label that has no room there is left out.
const Candidate* Placer::State::chooseInside(const Measured& measured, const View& view, std::optional<Box2>& label) {
  candidates.clear();
  for (const UsableBaseLine& base : bases) {
    gatherInsideCandidate(measured.annotation, base, scopes[base.scope].box, view, static_cast<std::int32_t>(measured.parameter),
                          candidates);
  }
  const auto best = std::ranges::max_element(candidates, {}, &Candidate::score);
  label = placeLabel({.line = best->lineScreen, .textSize = measured.textSize}, landed, view.viewport());
  return &*best;
}

/// Silhouette updating (paper 4.5): what has landed becomes part of what later lines keep away from.
void Placer::State::land(const PlacedLine& line) {
  landed.add(line);
  if (line.placement == PlacementKind::kInside) return;   // inside the silhouette there is nothing to pull in
  pullIn(padded, line.lineScreen, kHandleSpacingPx);
  for (const auto* extension : {&line.extensionStart, &line.extensionEnd}) {
    for (std::size_t i = 1; i < extension->size(); ++i) {
      pullIn(padded, Segment2{(*extension)[i - 1], (*extension)[i]}, kExtensionClearancePx);
    }
  }
  if (line.label) pullIn(padded, *line.label, kLabelClearancePx);
}

PlacedLine& Placer::State::appendLine(Layout& layout) {
  if (spareLines.empty()) return layout.lines.emplace_back();
  layout.lines.push_back(std::move(spareLines.back()));
  spareLines.pop_back();
  return layout.lines.back();
}

/// Takes the lines of the last layout back with the memory they hold.
void Placer::State::recycle(Layout& layout) {
  while (!layout.lines.empty()) {
    spareLines.push_back(std::move(layout.lines.back()));
    layout.lines.pop_back();
  }
}

}  // namespace dimline
