#include "placement/placer.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "placement/candidates.h"
#include "placement/label_text.h"
#include "placement/labels.h"
#include "placement/landed.h"
#include "placement/other_handles.h"
#include "placement/score.h"
#include "placement/text_metrics.h"
#include "placement/visibility.h"

// Algorithm 1 of the paper, one parameter after the other. The fields stand twice more than they are measured: padded by handleSpacing, and padded with
// every line that has landed, each grown by what later lines keep from it. A line that clears those keeps its distance from everything, so no
// step after the query needs to add padding.
//
// A candidate is one line, or a chain with its members; both are expanded to members before labels are placed, so that a line of its own is
// a chain of one from there on.

namespace dimline {

namespace {

/// An annotated parameter, and what it measures. Made at model change.
struct Measured {
  std::size_t parameter = 0;
  Annotation annotation;
  std::vector<std::size_t> scopes;   ///< indices into the scene's scopes
  std::vector<Cluster> clusters;     ///< of a chained parameter
  double meanLengthM = 0;
  std::string text;                  ///< its label, for the value it was made of
  double textValue = 0;
  Vec2 textSize{0.0};
};

/// One line of the winner: the line itself, or a member of its chain.
struct Member {
  std::size_t scope = 0;
  Segment base;
  Segment2 baseScreen;
  Segment2 footScreen;
  Segment line;
  Segment2 lineScreen;
  std::optional<Box2> label;
};

double meanBaseLengthM(const Annotation& annotation, const std::vector<Scope>& scopes, const std::vector<std::size_t>& measured) {
  double sum = 0;
  for (const std::size_t scope : measured) sum += meanBaseLengthM(annotation, scopes[scope].box);
  return measured.empty() ? 0.0 : sum / static_cast<double>(measured.size());
}

HiddenReason reasonFor(const BaseLineTally& tally, bool anyScope) {
  if (!anyScope) return HiddenReason::kNoScope;
  if (tally.occluded > 0) return HiddenReason::kOccluded;
  if (tally.foreshortened > 0) return HiddenReason::kForeshortened;
  if (tally.tooShort > 0) return HiddenReason::kTooShort;
  return HiddenReason::kOutOfView;
}

/// From the base line's end to the final line's, bent at the plane where the base line does not lie in it (paper 5, "Extension Lines").
void writeExtension(const Vec2& base, const Vec2& foot, const Vec2& end, std::vector<Vec2>& polyline) {
  polyline.clear();
  polyline.push_back(base);
  if (foot != base) polyline.push_back(foot);
  polyline.push_back(end);
}

auto orderOf(const Identity& i) { return std::tie(i.chain, i.scopeIndex, i.baseLine, i.plane, i.direction); }

}  // namespace

struct Placer::State {
  std::vector<Parameter> parameters;
  std::vector<Scope> scopes;
  double modelSizeM = 0;
  std::vector<Measured> order;        ///< those with dimension lines, shortest first
  std::vector<Measured> others;       ///< those with other handles, in the order of their definition
  std::vector<ObjectPlane> objectPlanes;
  std::vector<History> histories;     ///< one a parameter
  Mat4 lastViewProjection{0.0};
  bool viewMoved = false;             ///< since the last frame

  // Memory of one frame, kept so that the next allocates nothing.
  DistanceFields paddedModel;
  DistanceFields padded;
  Landed landed;
  Guides guides;
  std::vector<ObjectPlaneUse> objectPlaneUses;
  std::vector<SlipPlane> slipPlanesMemory;
  std::vector<char> inView;           ///< one a scope
  std::vector<char> seen;             ///< one a scope: in view, and not hidden by the model; kept for the next frame's hysteresis
  std::vector<UsableBaseLine> bases;
  std::vector<UsableBaseLine> chainBases;
  std::vector<Candidate> candidates;
  std::vector<Member> members;        ///< of the candidate that is looked at
  std::vector<Member> winnerMembers;
  TakenStretches chainStretches;
  std::vector<std::size_t> scopesInSight;
  std::vector<PlacedLine> spareLines;
  std::vector<PlacedHandle> spareHandles;

  [[nodiscard]] std::vector<Segment> allBaseLines() const;
  void findVisible(const View& view, const ScopeVisibility* visibility);
  [[nodiscard]] bool visible(const Annotation& annotation, std::size_t scope) const {
    return (annotation.occlusion ? seen : inView)[scope] != 0;
  }
  void placeParameter(Measured& measured, const View& view, const DistanceFields& model, double value, Layout& layout);
  void gatherCandidates(const Measured& measured, const CandidateContext& context, bool onGuides);
  const Candidate* chooseWinner(const Measured& measured, const View& view, const DistanceFields& model);
  const Candidate* chooseInside(const Measured& measured, const CandidateContext& context);
  bool expand(const Candidate& candidate, const Measured& measured, const View& view);
  bool expandChain(const Candidate& candidate, const Measured& measured, const View& view);
  bool settle(Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model);
  bool placeLabels(const Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model);
  bool fellowsLeaveRoom(const Box2& label, std::size_t own) const;
  void land(const Candidate& winner, const Measured& measured, double value, Layout& layout);
  void landHeld(const PlacedLine& held, Layout& layout);
  void occupy(const PlacedLine& line, int guide);
  int guideOf(const Candidate& winner);
  void placeOther(const Measured& measured, const View& view, double value, Layout& layout);
  PlacedLine& appendLine(Layout& layout);
  PlacedHandle& appendHandle(Layout& layout);
  void recycle(Layout& layout);
};

Placer::Placer() : state_(std::make_unique<State>()) {}
Placer::~Placer() = default;
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;

void Placer::forget() {
  auto& histories = state_->histories;
  for (std::size_t i = 0; i < histories.size(); ++i) histories[i] = History(static_cast<std::int32_t>(i));
}

struct Placer::Memory::Content {
  std::vector<History> histories;
  std::vector<char> seen;
  Mat4 lastViewProjection;
};

Placer::Memory Placer::memory() const {
  Memory memory;
  memory.content_ = std::make_shared<const Memory::Content>(Memory::Content{state_->histories, state_->seen, state_->lastViewProjection});
  return memory;
}

void Placer::recall(const Memory& memory) {
  if (memory.content_ == nullptr || memory.content_->histories.size() != state_->histories.size()) return;
  state_->histories = memory.content_->histories;
  state_->seen = memory.content_->seen;
  state_->lastViewProjection = memory.content_->lastViewProjection;
}

void Placer::setScene(const Model& model, const Scene& scene) {
  State& s = *state_;
  const auto sameName = [](const Parameter& a, const Parameter& b) { return a.name == b.name; };
  const bool sameModel = std::ranges::equal(s.parameters, model.parameters(), sameName);
  if (s.scopes.size() != scene.scopes.size()) s.seen.clear();
  s.scopes = scene.scopes;
  s.modelSizeM = scene.bounds.diagonal();
  if (!sameModel) {
    s.parameters.assign(model.parameters().begin(), model.parameters().end());
    s.histories.assign(s.parameters.size(), History(-1));
    forget();
  }
  for (History& history : s.histories) history.forgetOffset();
  s.order.clear();
  s.others.clear();
  for (std::size_t i = 0; i < s.parameters.size(); ++i) {
    const auto& annotation = model.annotations[i];
    if (!annotation) continue;
    Measured measured;
    measured.parameter = i;
    measured.annotation = *annotation;
    for (std::size_t scope = 0; scope < s.scopes.size(); ++scope) {
      if (s.scopes[scope].name == annotation->scope) measured.scopes.push_back(scope);
    }
    if (annotation->chained) measured.clusters = clusterBaseLines(*annotation, s.scopes, measured.scopes, s.modelSizeM);
    measured.meanLengthM = meanBaseLengthM(*annotation, s.scopes, measured.scopes);
    measured.textValue = std::numeric_limits<double>::quiet_NaN();   // equal to no value: the text is made in the first frame
    (isLine(annotation->type) ? s.order : s.others).push_back(std::move(measured));
  }
  std::ranges::stable_sort(s.order, {}, &Measured::meanLengthM);
  s.objectPlanes = objectPlanes(s.allBaseLines(), scene.bounds);
}

void Placer::place(const View& view, const DistanceFields& fields, const Values& values, Layout& layout,
                   const ScopeVisibility* visibility, const PlacedLine* held) {
  State& s = *state_;
  s.recycle(layout);
  layout.view = view;
  s.viewMoved = view.viewProjection() != s.lastViewProjection;
  s.lastViewProjection = view.viewProjection();
  if (s.viewMoved) {
    for (History& history : s.histories) history.age();
  }
  layout.hidden.clear();
  layout.visibleScopes.clear();
  s.landed.clear();
  s.guides.clear();
  pad(fields, kHandleSpacingPx, s.paddedModel);
  s.padded = s.paddedModel;
  s.findVisible(view, visibility);
  facePlanes(s.objectPlanes, view, s.objectPlaneUses);
  for (std::size_t i = 0; i < s.scopes.size(); ++i) {
    if (s.seen[i] != 0) layout.visibleScopes.push_back(i);
  }
  for (Measured& measured : s.order) {
    if (held != nullptr && held->parameter == measured.parameter) {
      s.landHeld(*held, layout);
    } else {
      s.placeParameter(measured, view, fields, values.at(measured.parameter), layout);
    }
  }
  // Lines are bound to their planes; a switch finds a place nearly anywhere, so it takes what they leave.
  for (const Measured& other : s.others) s.placeOther(other, view, values.at(other.parameter), layout);
}

void Placer::State::placeOther(const Measured& measured, const View& view, double value, Layout& layout) {
  scopesInSight.clear();
  BaseLineTally tally;
  for (const std::size_t scope : measured.scopes) {
    if (visible(measured.annotation, scope)) {
      scopesInSight.push_back(scope);
    } else {
      ++(inView[scope] != 0 ? tally.occluded : tally.outOfView);
    }
  }
  History& history = histories[measured.parameter];
  const OtherHandle handle{measured.parameter, parameters[measured.parameter], measured.annotation, scopesInSight, value, history};
  const OtherHandleContext context{view, padded, landed, scopes};
  PlacedHandle& placed = appendHandle(layout);
  const bool arc = measured.annotation.type == HandleType::kAngular;
  if (!(arc ? placeArc(handle, context, placed) : placePill(handle, context, placed))) {
    spareHandles.push_back(std::move(placed));
    layout.others.pop_back();
    if (arc && !scopesInSight.empty()) ++tally.foreshortened;
    layout.hidden.push_back({measured.parameter, reasonFor(tally, !measured.scopes.empty())});
    history.choseNone();
    return;
  }
  history.choose(placed.identity, -1);
  landed.add(placed, view);
  pullIn(padded, placed.box, kLabelClearancePx);
}

/// The base lines of all parameters that do not depend on the view, from which the object planes are made.
std::vector<Segment> Placer::State::allBaseLines() const {
  std::vector<Segment> all;
  for (const Measured& measured : order) {
    for (const std::size_t scope : measured.scopes) {
      const HandleType type = measured.annotation.type;
      if (type != HandleType::kLinearContour && type != HandleType::kLinearCenter) continue;
      for (const BaseLine& line : baseLines(measured.annotation, scopes[scope].box, View())) all.push_back(line.segment);
    }
  }
  return all;
}

void Placer::State::findVisible(const View& view, const ScopeVisibility* visibility) {
  assert(visibility == nullptr || visibility->seenShare.size() == scopes.size());
  inView.resize(scopes.size());
  seen.resize(scopes.size(), 0);
  for (std::size_t i = 0; i < scopes.size(); ++i) {
    inView[i] = dimline::inView(view, scopes[i].box) ? 1 : 0;
    const double threshold = seen[i] != 0 ? kSeenShareToKeep : kSeenShareToShow;
    const bool hidden = visibility != nullptr && static_cast<double>(visibility->seenShare[i]) < threshold;
    seen[i] = inView[i] != 0 && !hidden ? 1 : 0;
  }
}

/// getDimensionLine of algorithm 1.
void Placer::State::placeParameter(Measured& measured, const View& view, const DistanceFields& model, double value, Layout& layout) {
  bases.clear();
  BaseLineTally tally;
  for (const std::size_t scope : measured.scopes) {
    if (!visible(measured.annotation, scope)) {
      ++(inView[scope] != 0 ? tally.occluded : tally.outOfView);
    } else {
      gatherBaseLines(measured.annotation, scopes[scope], scope, view, bases, tally);
    }
  }
  History& history = histories[measured.parameter];
  if (bases.empty()) {
    layout.hidden.push_back({measured.parameter, reasonFor(tally, !measured.scopes.empty())});
    history.choseNone();
    return;
  }
  if (measured.textValue != value) {
    measured.text = labelText(parameters[measured.parameter], value);
    measured.textValue = value;
    measured.textSize = labelSizePx(measured.text);
  }

  const ObjectPlanesInFrame object{objectPlanes, objectPlaneUses, kSamePlaneDistance * modelSizeM};
  const CandidateContext context{measured.annotation, view, padded, paddedModel, guides, object, viewMoved, history, modelSizeM, slipPlanesMemory};
  const Candidate* winner = nullptr;
  for (const bool onGuides : {true, false}) {
    gatherCandidates(measured, context, onGuides);
    winner = chooseWinner(measured, view, model);
    if (winner != nullptr) break;
  }
  if (winner == nullptr) winner = chooseInside(measured, context);
  history.choose(winner->identity, winner->placement == PlacementKind::kOutside ? winner->offsetM : -1);
  land(*winner, measured, value, layout);
}

/// Candidates on guides, or else outside the silhouette, best first. A chained parameter slides its chains; if it has none that can be used, as
/// when they pass behind the viewer, its base lines stand for themselves.
void Placer::State::gatherCandidates(const Measured& measured, const CandidateContext& context, bool onGuides) {
  candidates.clear();
  const auto gather = [&](const std::vector<UsableBaseLine>& from) {
    for (const UsableBaseLine& base : from) {
      if (onGuides) {
        gatherGuideCandidates(context, base, candidates);
      } else {
        gatherOutsideCandidates(context, base, candidates);
      }
    }
  };
  if (measured.clusters.empty()) {
    gather(bases);
  } else {
    chainBases.clear();
    for (std::size_t i = 0; i < measured.clusters.size(); ++i) {
      gatherChainBaseLines(measured.clusters[i], static_cast<std::int32_t>(i), context.view, chainBases);
    }
    gather(chainBases);
  }
  // Equal scores are ordered by identity, so that the same frame always gives the same layout.
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score : orderOf(a.identity) < orderOf(b.identity);
  });
}

/// computeWinner. The Intersect term and the labels are dear, so they are looked at only for candidates that could still win: the term only lowers a
/// score, and the candidates come in descending order.
const Candidate* Placer::State::chooseWinner(const Measured& measured, const View& view, const DistanceFields& model) {
  const Candidate* best = nullptr;
  double bestScore = 0;
  for (Candidate& candidate : candidates) {
    if (best != nullptr && bestScore >= candidate.score) break;
    double candidateScore = candidate.score;
    const Landed::Crossings crossings = landed.crossings(candidate.baseScreen, candidate.footScreen, candidate.lineScreen);
    if (crossings.lines) candidateScore += kScoreIntersect;
    if (crossings.extensions) candidateScore += kScoreCrossesExtension;
    if (crossings.labels) candidateScore += kScoreCoversLabel;
    if (best != nullptr && bestScore >= candidateScore) continue;
    if (!settle(candidate, measured, view, model)) continue;
    best = &candidate;
    bestScore = candidateScore;
    std::swap(members, winnerMembers);
  }
  return best;
}

/// The fallback: the base lines themselves (algorithm 1, line 9). A label that has no room there is left out.
const Candidate* Placer::State::chooseInside(const Measured& measured, const CandidateContext& context) {
  candidates.clear();
  for (const UsableBaseLine& base : bases) gatherInsideCandidate(context, base, scopes[base.scope].box, candidates);
  const Candidate& best = *std::ranges::max_element(candidates, {}, &Candidate::score);
  winnerMembers.clear();
  winnerMembers.push_back({best.scope, best.base, best.baseScreen, best.footScreen, best.line, best.lineScreen,
                           placeLabel({.line = best.lineScreen, .textSize = measured.textSize}, landed, context.view.viewport())});
  return &best;
}

/// Fills `members` with the lines that a candidate stands for. False when there is none that has room.
bool Placer::State::expand(const Candidate& candidate, const Measured& measured, const View& view) {
  members.clear();
  if (candidate.identity.chain >= 0) return expandChain(candidate, measured, view);
  if (candidate.guide >= 0) {
    const Guide& guide = guides[static_cast<std::size_t>(candidate.guide)];
    const auto [from, to] = std::minmax({guide.metresAt(candidate.line.start), guide.metresAt(candidate.line.end)});
    if (!guide.taken.free(from, to, kSamePlaneDistance * modelSizeM) || !landed.hasRoom(candidate.lineScreen, candidate.guide)) return false;
  }
  members.push_back({candidate.scope, candidate.base, candidate.baseScreen, candidate.footScreen, candidate.line, candidate.lineScreen, std::nullopt});
  return true;
}

/// Projects the cluster's base lines onto the chain, nearest first; one whose region is taken already is refused (paper 4.3).
bool Placer::State::expandChain(const Candidate& candidate, const Measured& measured, const View& view) {
  const Cluster& cluster = measured.clusters[static_cast<std::size_t>(candidate.identity.chain)];
  const double toleranceM = kSamePlaneDistance * modelSizeM;
  const Guide* guide = candidate.guide >= 0 ? &guides[static_cast<std::size_t>(candidate.guide)] : nullptr;
  chainStretches.clear();
  for (const std::uint32_t index : cluster.nearestFirst[static_cast<std::size_t>(candidate.identity.baseLine)]) {
    const ChainMember& m = cluster.members[index];
    if (!visible(measured.annotation, m.scope) || !chainStretches.free(m.fromM, m.toM, toleranceM)) continue;
    if (!view.inFrontOfNear(m.segment.start) || !view.inFrontOfNear(m.segment.end)) continue;
    const Segment line{candidate.line.start + cluster.along * m.fromM, candidate.line.start + cluster.along * m.toM};
    const Segment2 lineScreen = view.toScreen(line);
    if (lineScreen.length() < leastLengthPx(measured.annotation)) continue;
    if (guide != nullptr) {
      const auto [from, to] = std::minmax({guide->metresAt(line.start), guide->metresAt(line.end)});
      if (!guide->taken.free(from, to, toleranceM) || !landed.hasRoom(lineScreen, candidate.guide)) continue;
    }
    chainStretches.add(m.fromM, m.toM);
    const Segment foot{m.segment.start + candidate.plane.onto, m.segment.end + candidate.plane.onto};
    members.push_back({m.scope, m.segment, view.toScreen(m.segment), view.toScreen(foot), line, lineScreen, std::nullopt});
  }
  return !members.empty();
}

/// Expands a candidate and gives it a label, moving it further out where the label has no room. False when there is none.
bool Placer::State::settle(Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model) {
  for (int step = 0; step <= kLabelPushSteps; ++step) {
    if (step > 0 && !pushOutward(candidate, kLabelPushStepPx, view)) return false;
    if (!expand(candidate, measured, view)) return false;
    if (placeLabels(candidate, measured, view, model)) return true;
  }
  return false;
}

/// As many members carry a text as have room; false when none has.
bool Placer::State::placeLabels(const Candidate& candidate, const Measured& measured, const View& view, const DistanceFields& model) {
  bool any = false;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto box = placeLabel({.line = members[i].lineScreen,
                                 .textSize = measured.textSize,
                                 .outward = candidate.lineScreen.middle() - candidate.baseScreen.middle(),
                                 .model = &model,
                                 .inChain = members.size() > 1},
                                landed, view.viewport());
    if (!box || !fellowsLeaveRoom(*box, i)) continue;
    members[i].label = box;
    any = true;
  }
  return any;
}

bool Placer::State::fellowsLeaveRoom(const Box2& label, std::size_t own) const {
  const Box2 grown = label.grown(kLabelClearancePx);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i == own) continue;
    if (meets(members[i].lineScreen, grown)) return false;
    if (members[i].label && grown.overlaps(*members[i].label)) return false;
  }
  return true;
}

/// The guide that the winner lies on: the one it snapped to, or a new one. Lines inside the model make none.
int Placer::State::guideOf(const Candidate& winner) {
  if (winner.placement == PlacementKind::kInside) return -1;
  return winner.guide >= 0 ? winner.guide : guides.add(winner.plane.plane, winner.line);
}

/// Writes the winner's lines into the layout.
void Placer::State::land(const Candidate& winner, const Measured& measured, double value, Layout& layout) {
  const int guide = guideOf(winner);
  const bool inside = winner.placement == PlacementKind::kInside;
  for (const Member& member : winnerMembers) {
    PlacedLine& line = appendLine(layout);
    line.parameter = measured.parameter;
    line.scope = member.scope;
    line.identity = winner.identity;
    line.identity.scopeIndex = static_cast<std::int32_t>(scopes[member.scope].index);
    line.placement = winner.placement;
    line.planeKind = winner.plane.kind;
    line.facing = winner.plane.facing;
    line.plane = winner.plane.plane;
    line.base = member.base;
    line.line = member.line;
    line.baseScreen = member.baseScreen;
    line.lineScreen = member.lineScreen;
    if (inside) {
      line.extensionStart.clear();
      line.extensionEnd.clear();
    } else {
      writeExtension(member.baseScreen.start, member.footScreen.start, member.lineScreen.start, line.extensionStart);
      writeExtension(member.baseScreen.end, member.footScreen.end, member.lineScreen.end, line.extensionEnd);
    }
    // A parameter has at most one chain in a frame, so its number says which chain it is.
    line.chain = winner.identity.chain >= 0 ? static_cast<std::int32_t>(measured.parameter) : -1;
    line.indirect = measured.annotation.indirect;
    line.lengthM = member.base.length();
    line.value = value;
    line.text = measured.text;
    line.label = member.label;
    line.handles.clear();
    line.handles.push_back({true, member.lineScreen.end});
    if (measured.annotation.ends == HandleEnds::kBoth) line.handles.push_back({false, member.lineScreen.start});

    occupy(line, guide);
  }
}

/// A line that is being dragged stays on its carrier, whatever this frame would have chosen for it.
void Placer::State::landHeld(const PlacedLine& held, Layout& layout) {
  histories[held.parameter].choose(held.identity, -1);
  int guide = -1;
  if (held.placement != PlacementKind::kInside) {
    const Vec3 along = glm::normalize(held.line.end - held.line.start);
    for (std::size_t i = 0; i < guides.size() && guide < 0; ++i) {
      const bool onPlane = liesOn(guides[i], held.plane, along, modelSizeM);
      const Vec3 aside = held.line.start - guides[i].point - guides[i].along * guides[i].metresAt(held.line.start);
      if (onPlane && glm::length(aside) <= kSamePlaneDistance * modelSizeM) guide = static_cast<int>(i);
    }
    if (guide < 0) guide = guides.add(held.plane, held.line);
  }
  PlacedLine& line = appendLine(layout);
  line = held;
  occupy(line, guide);
}

/// Puts a line into everything that later lines look at (silhouette updating, paper 4.5).
void Placer::State::occupy(const PlacedLine& line, int guide) {
  landed.add(line, guide);
  if (guide < 0) return;   // inside the silhouette there is nothing to pull in
  Guide& carrier = guides[static_cast<std::size_t>(guide)];
  const auto [from, to] = std::minmax({carrier.metresAt(line.line.start), carrier.metresAt(line.line.end)});
  carrier.taken.add(from, to);
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

PlacedHandle& Placer::State::appendHandle(Layout& layout) {
  if (spareHandles.empty()) return layout.others.emplace_back();
  layout.others.push_back(std::move(spareHandles.back()));
  spareHandles.pop_back();
  return layout.others.back();
}

/// Takes the lines and handles of the last layout back with the memory they hold.
void Placer::State::recycle(Layout& layout) {
  while (!layout.lines.empty()) {
    spareLines.push_back(std::move(layout.lines.back()));
    layout.lines.pop_back();
  }
  while (!layout.others.empty()) {
    spareHandles.push_back(std::move(layout.others.back()));
    layout.others.pop_back();
  }
}

}  // namespace dimline
