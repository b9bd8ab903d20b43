#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/audit_measure.h"
#include "cli/audit_odds.h"
#include "core/text.h"

// The rows that compare frames. A parameter's state in a frame is the set of the identities of its lines, a chain's
// without the member, or of its other handle; empty while it is hidden.

namespace dimline {

namespace {

constexpr double kJumpPx = 40.0;

using State = std::vector<Identity>;

Identity withoutMember(const PlacedLine& line) {
  Identity identity = line.identity;
  if (line.chain >= 0) identity.scopeIndex = -1;
  return identity;
}

State stateOf(const Layout& layout, std::size_t parameter) {
  State state;
  const auto add = [&](const Identity& identity) {
    if (std::ranges::find(state, identity) == state.end()) state.push_back(identity);
  };
  for (const PlacedLine& line : layout.lines) {
    if (line.parameter == parameter) add(withoutMember(line));
  }
  for (const PlacedHandle& handle : layout.others) {
    if (handle.parameter == parameter) add(handle.identity);
  }
  return state;
}

bool sameState(const State& a, const State& b) {
  return a.size() == b.size() &&
         std::ranges::all_of(a, [&](const Identity& i) { return std::ranges::find(b, i) != b.end(); });
}

/// A parameter's state in words: its identities, or why it is hidden.
std::string textOf(const State& state, const Layout& layout, std::size_t parameter, const Model& model) {
  if (state.empty()) {
    const auto hidden = std::ranges::find(layout.hidden, parameter, &HiddenParameter::parameter);
    return hidden == layout.hidden.end() ? "hidden" : "hidden (" + std::string(name(hidden->reason)) + ")";
  }
  std::string text;
  for (const Identity& identity : state) text += (text.empty() ? "" : " ") + identityText(identity, model.parameters());
  return text;
}

/// What happened to an earlier line in the same step and so may be why: ", after Width changed place"; empty when nothing
/// did.
std::string afterWhat(const Layout& before, const Layout& after, std::size_t parameter, const Model& model) {
  for (const PlacedLine& line : after.lines) {
    if (line.parameter == parameter) break;
    const State then = stateOf(before, line.parameter);
    if (sameState(then, stateOf(after, line.parameter))) continue;
    return ", after " + model.parameters()[line.parameter].name + (then.empty() ? " came" : " changed place");
  }
  return {};
}

void measureStates(const Model& model, std::size_t parameter, std::span<const Layout> layouts,
                   std::span<const FrameName> names, Odds* odds, AuditTally& tally) {
  const std::string& parameterName = model.parameters()[parameter].name;
  std::vector<State> states;
  for (const Layout& layout : layouts) states.push_back(stateOf(layout, parameter));
  for (std::size_t f = 1; f < states.size(); ++f) {
    const State& before = states[f - 1];
    const bool same = sameState(before, states[f]);
    if (!before.empty() && !states[f].empty()) {
      tally.judge(AuditRow::kIdentityChanges);
      if (!same) {
        tally.offend(AuditRow::kIdentityChanges, parameterName, 0, names[f],
                     textOf(before, layouts[f - 1], parameter, model) + " to " +
                         textOf(states[f], layouts[f], parameter, model) +
                         afterWhat(layouts[f - 1], layouts[f], parameter, model));
      }
    }
    if (same) continue;
    tally.judge(AuditRow::kFlicker);
    for (std::size_t g = f + 1; g < states.size() && g <= f + kTakenBackFrames && names[g].leg == names[f - 1].leg;
         ++g) {
      if (!sameState(states[g], before)) continue;
      tally.offend(AuditRow::kFlicker, parameterName, static_cast<double>(kTakenBackFrames + 1 - (g - f)), names[f],
                   textOf(before, layouts[f - 1], parameter, model) + " to " +
                       textOf(states[f], layouts[f], parameter, model) + ", and after " + std::to_string(g - f) +
                       " back to " + textOf(states[g], layouts[g], parameter, model),
                   odds != nullptr && odds->hadToGoBack(parameter, f, g));
      break;
    }
  }
}

void measureJumps(const Model& model, const Layout& before, const Layout& after, const FrameName& name,
                  AuditTally& tally) {
  for (const PlacedLine& line : after.lines) {
    const auto last =
        std::ranges::find_if(before.lines, [&](const PlacedLine& l) { return l.identity == line.identity; });
    if (last == before.lines.end()) continue;
    tally.judge(AuditRow::kJumps);
    const auto moved = [&](Vec2 Segment2::*end) {
      return glm::length((line.lineScreen.*end - line.baseScreen.*end) -
                         (last->lineScreen.*end - last->baseScreen.*end));
    };
    const double way = std::max(moved(&Segment2::start), moved(&Segment2::end));
    if (way > kJumpPx) {
      tally.offend(
          AuditRow::kJumps, model.parameters()[line.parameter].name, way, name,
          "moves " + formatFixed(way, 0) + " px in one step" + afterWhat(before, after, line.parameter, model));
    }
  }
}

void measureMembers(const Model& model, const Layout& before, const Layout& after, const FrameName& name,
                    AuditTally& tally) {
  const auto holds = [](const Layout& layout, const auto& wanted) { return std::ranges::any_of(layout.lines, wanted); };
  const auto compare = [&](const Layout& from, const Layout& to, bool countCommon, const char* what) {
    for (const PlacedLine& line : from.lines) {
      if (line.chain < 0) continue;
      const Identity chain = withoutMember(line);
      if (!holds(to, [&](const PlacedLine& l) { return l.chain >= 0 && withoutMember(l) == chain; })) continue;
      const bool stays = holds(to, [&](const PlacedLine& l) { return l.identity == line.identity; });
      if (countCommon || !stays) tally.judge(AuditRow::kChainMembers);
      if (!stays) {
        tally.offend(AuditRow::kChainMembers, model.parameters()[line.parameter].name, 0, name,
                     identityText(line.identity, model.parameters()) + what);
      }
    }
  };
  compare(before, after, true, " goes");
  compare(after, before, false, " comes");
}

bool same(const Segment2& s, const Segment2& t) { return s.start == t.start && s.end == t.end; }

bool identical(const PlacedLine& a, const PlacedLine& b) {
  return a.placement == b.placement && same(a.lineScreen, b.lineScreen) && same(a.baseScreen, b.baseScreen) &&
         a.label == b.label && a.extensionStart == b.extensionStart && a.extensionEnd == b.extensionEnd;
}

bool identical(const PlacedHandle& a, const PlacedHandle& b) {
  return a.placement == b.placement && a.anchor == b.anchor && a.box == b.box && a.arc == b.arc;
}

/// Holds what is shown in one frame against the other, line by line or handle by handle.
template <typename Shown>
void compareStill(const Model& model, const std::vector<Shown>& first, const std::vector<Shown>& second,
                  const FrameName& name, AuditTally& tally) {
  const auto find = [](const std::vector<Shown>& all, const Identity& identity) {
    return std::ranges::find(all, identity, &Shown::identity);
  };
  for (const Shown& shown : first) {
    tally.judge(AuditRow::kStillCamera);
    const auto again = find(second, shown.identity);
    if (again != second.end() && identical(shown, *again)) continue;
    tally.offend(AuditRow::kStillCamera, model.parameters()[shown.parameter].name, 0, name,
                 identityText(shown.identity, model.parameters()) + (again == second.end() ? " goes" : " moves"));
  }
  for (const Shown& shown : second) {
    if (find(first, shown.identity) != first.end()) continue;
    tally.judge(AuditRow::kStillCamera);
    tally.offend(AuditRow::kStillCamera, model.parameters()[shown.parameter].name, 0, name,
                 identityText(shown.identity, model.parameters()) + " comes");
  }
}

}  // namespace

void measureSteps(const Model& model, std::span<const Layout> layouts, std::span<const FrameName> names, Odds* odds,
                  AuditTally& tally) {
  for (std::size_t p = 0; p < model.parameters().size(); ++p) measureStates(model, p, layouts, names, odds, tally);
  for (std::size_t f = 1; f < layouts.size(); ++f) {
    measureJumps(model, layouts[f - 1], layouts[f], names[f], tally);
    measureMembers(model, layouts[f - 1], layouts[f], names[f], tally);
  }
}

void measureStill(const Model& model, const Layout& first, const Layout& second, const FrameName& name,
                  AuditTally& tally) {
  compareStill(model, first.lines, second.lines, name, tally);
  compareStill(model, first.others, second.others, name, tally);
}

}  // namespace dimline
