#include <catch2/catch.hpp>

#include "cli/audit_stage.h"

// The rows that compare frames: layouts in their order that break them, and ones that just do not.

namespace dimline::test {
namespace {

/// Frames in which parameter A has lines of the given identities (their base line's number), 0 for none.
AuditTally stepped(const std::vector<int>& identities, const std::vector<int>& legs = {}) {
  std::vector<Layout> layouts;
  std::vector<FrameName> names;
  Stage stage;
  for (std::size_t f = 0; f < identities.size(); ++f) {
    stage.layout.lines.clear();
    if (identities[f] > 0) stage.add(kA, vertical(60)).identity.baseLine = static_cast<std::int16_t>(identities[f]);
    layouts.push_back(stage.layout);
    names.push_back({.frame = static_cast<int>(f), .leg = legs.empty() ? 0 : legs[f]});
  }
  AuditTally tally;
  measureSteps(stage.model, layouts, names, nullptr, tally);
  return tally;
}

TEST_CASE("audit: identity changes from frame to frame") {
  const Figure figure = stepped({1, 1, 2, 2, 2}).figure(AuditRow::kIdentityChanges);
  CHECK(figure.judged == 4);
  CHECK(figure.offences == 1);
  CHECK_FALSE(figure.met);
  // Hidden in one of the two is no change.
  CHECK(stepped({1, 0, 2, 2}).figure(AuditRow::kIdentityChanges).offences == 0);
  CHECK(stepped({1, 0, 2, 2}).figure(AuditRow::kIdentityChanges).judged == 1);
}

TEST_CASE("audit: changes and appearances that are taken back") {
  const auto flickers = [](const std::vector<int>& identities, const std::vector<int>& legs = {}) {
    return stepped(identities, legs).figure(AuditRow::kFlicker).offences;
  };
  CHECK(flickers({1, 2, 1, 1}) == 1);
  CHECK(flickers({1, 2, 1, 2}) == 2);
  CHECK(flickers({0, 1, 1, 0, 0}) == 1);
  CHECK(flickers({1, 0, 1, 1}) == 1);
  CHECK(flickers({1, 1, 2, 2, 3, 3}) == 0);
  std::vector<int> slow(20, 2);
  slow[0] = 1;
  slow[16] = 1;
  CHECK(flickers({slow.begin(), slow.begin() + 17}) == 1);  // from frame 1 on, and back 15 frames later
  slow[16] = 2;
  slow[17] = 1;
  CHECK(flickers({slow.begin(), slow.begin() + 18}) == 0);
  // The camera turned round on the way: what comes back then was to be expected.
  CHECK(flickers({1, 2, 1, 1}, {0, 0, 1, 1}) == 0);
}

TEST_CASE("audit: lines that jump against their base lines") {
  Stage stage;
  std::vector<Layout> layouts;
  const std::vector<FrameName> names(2);
  const auto jumps = [&](const Segment2& base, const Segment2& line, int baseLine) {
    layouts.clear();
    stage.layout.lines.clear();
    stage.add(kA, vertical(100), vertical(60));
    layouts.push_back(stage.layout);
    stage.layout.lines.clear();
    stage.add(kA, base, line).identity.baseLine = static_cast<std::int16_t>(baseLine);
    layouts.push_back(stage.layout);
    AuditTally tally;
    measureSteps(stage.model, layouts, names, nullptr, tally);
    return tally.figure(AuditRow::kJumps);
  };
  CHECK(jumps(vertical(100), vertical(19), 0).offences == 1);
  CHECK(jumps(vertical(100), vertical(21), 0).offences == 0);
  CHECK(jumps(vertical(200), vertical(160), 0).offences == 0);  // the base line took it along
  CHECK(jumps(vertical(100), vertical(19), 1).judged == 0);     // another identity
}

TEST_CASE("audit: chain members that come or go") {
  Stage stage;
  const auto frame = [&](std::initializer_list<int> members, int cluster) {
    stage.layout.lines.clear();
    for (const int member : members) {
      PlacedLine& line = stage.add(kC, vertical(60));
      line.chain = 2;
      line.identity.chain = cluster;
      line.identity.scopeIndex = member;
    }
    return stage.layout;
  };
  const auto figure = [&](const std::vector<Layout>& layouts, AuditRow row) {
    AuditTally tally;
    measureSteps(stage.model, layouts, std::vector<FrameName>(layouts.size()), nullptr, tally);
    return tally.figure(row);
  };
  const std::vector<Layout> oneGoesOneComes{frame({1, 2, 3}, 0), frame({2, 3, 4}, 0)};
  CHECK(figure(oneGoesOneComes, AuditRow::kChainMembers).judged == 4);
  CHECK(figure(oneGoesOneComes, AuditRow::kChainMembers).offences == 2);
  CHECK(figure(oneGoesOneComes, AuditRow::kIdentityChanges).offences == 0);
  const std::vector<Layout> another{frame({1, 2, 3}, 0), frame({1, 2, 3}, 1)};
  CHECK(figure(another, AuditRow::kChainMembers).judged == 0);
  CHECK(figure(another, AuditRow::kIdentityChanges).offences == 1);
}

TEST_CASE("audit: nothing moves before a still camera") {
  Stage first;
  first.add(kA, vertical(60)).label = Box2{{45, 190}, {75, 210}};
  Stage second = first;
  const auto offences = [&] {
    AuditTally tally;
    measureStill(first.model, first.layout, second.layout, {}, tally);
    return tally.figure(AuditRow::kStillCamera).offences;
  };
  CHECK(offences() == 0);
  second.layout.lines[0].lineScreen.start.x += 1e-9;
  CHECK(offences() == 1);
  second = first;
  second.layout.lines[0].label.reset();
  CHECK(offences() == 1);
  second = first;
  second.layout.lines.clear();
  CHECK(offences() == 1);
  second = first;
  second.add(kB, level(350));
  CHECK(offences() == 1);
}

}  // namespace
}  // namespace dimline::test
