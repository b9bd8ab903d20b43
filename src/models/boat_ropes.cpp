#include <algorithm>
#include <cmath>

#include "models/boat_parts.h"

// Standing and running rigging: what holds the masts, and what the sails are worked with.

namespace dimline::boat {

namespace {

/// A dead-eye: the round block at a shroud's lower end.
PartId makeDeadeye(const Ship& ship) {
  Builder& b = ship.b;
  b.material(ship.m.darkOak);
  return b.part(Vec3(0.0), [&] {
    b.rotate(Axis::kX, 1.5707963267948966);
    const Vec2 profile[] = {{0.1, -0.07}, {0.15, -0.03}, {0.15, 0.03}, {0.1, 0.07}};
    b.lathe(profile, {8, 0.9});
  });
}

/// Shrouds from a channel to a masthead, with ratlines across them.
struct Shrouds {
  std::vector<Vec3> feet;  ///< foremost first
  Vec3 head{0.0};
  double spread = 0;  ///< of the heads, fore and aft
};

void drawShrouds(const Ship& ship, const Shrouds& shrouds, double radius) {
  const std::size_t count = shrouds.feet.size();
  const auto headOf = [&](std::size_t i) {
    return shrouds.head + Vec3(shrouds.spread * (0.5 - static_cast<double>(i) / static_cast<double>(count - 1)), 0, 0);
  };
  ship.b.material(ship.m.tarredRope);
  for (std::size_t i = 0; i < count; ++i) drawRope(ship, shrouds.feet[i], headOf(i), radius);
  const double height = shrouds.head.y - shrouds.feet[0].y;
  const int steps = static_cast<int>(height / 0.46);
  const double thin = radius * 0.55;
  for (int i = 2; i < steps - 1; ++i) {
    const double t = static_cast<double>(i) / steps;
    drawRope(ship, glm::mix(shrouds.feet.front(), headOf(0), t), glm::mix(shrouds.feet.back(), headOf(count - 1), t),
             thin, 3);
  }
}

/// The board outside the hull that spreads a mast's shrouds, with dead-eyes on it and chains below.
void drawLowerShrouds(const Ship& ship, const Mast& mast, double headY, PartId deadeye) {
  Builder& b = ship.b;
  const HullForm& hull = ship.plan.hull;
  const double spacing = 0.72, first = mast.x + 0.35;
  const double last = first - spacing * (mast.shrouds - 1);
  const double bow = hull.length - 0.6;
  for (const int side : kSides) {
    b.material(ship.m.darkOak);
    const double from = std::max(last - 0.3, hull.sternX(mast.channelH) + 0.1), to = std::min(first + 0.3, bow);
    drawStrake(ship, rectangleRing({-0.1, -0.05}, {0.5, 0.05}), from, to, mast.channelH, side);
    Shrouds shrouds;
    shrouds.head = {mast.x, headY, side * mast.radius * 0.8};
    shrouds.spread = mast.radius * 1.6;
    for (int i = 0; i < mast.shrouds; ++i) {
      const double x = std::clamp(first - spacing * i, from + 0.1 + 0.05 * (mast.shrouds - i), to);
      const Vec3 edge = mirrored(hull.sideAt(x, mast.channelH), side) + Vec3(0, 0, 0.42 * side);
      const Vec3 low = edge + Vec3(0, 0.22, 0), high = low + glm::normalize(shrouds.head - low) * 0.85;
      for (const Vec3& at : {low, high}) {
        b.push([&] {
          b.translate(at);
          b.place(deadeye);
        });
      }
      b.material(ship.m.hemp);
      for (const double x2 : {-0.07, 0.07}) drawRope(ship, low + Vec3(x2, 0, 0), high + Vec3(x2, 0, 0), 0.016, 3);
      b.material(ship.m.iron);
      drawRope(ship, edge + Vec3(0, 0.1, 0),
               mirrored(hull.sideAt(x, mast.channelH - 0.85), side) + Vec3(0, 0, 0.03 * side), 0.03);
      shrouds.feet.push_back(high);
    }
    drawShrouds(ship, shrouds, 0.045);
  }
}

/// From the rim of a top to the next masthead.
void drawUpperShrouds(const Ship& ship, const Vec3& middle, double radius, const Vec3& head) {
  for (const int side : kSides) {
    Shrouds shrouds;
    shrouds.head = head + Vec3(0, 0, 0.08 * side);
    shrouds.spread = 0.3;
    for (int i = 0; i < 3; ++i)
      shrouds.feet.push_back(middle + Vec3(radius * 0.45 * (1 - i), 0.15, side * radius * (i == 1 ? 1.0 : 0.9)));
    drawShrouds(ship, shrouds, 0.032);
  }
}

/// Where a square mast's pieces are, as boat_rig draws them.
struct Heads {
  explicit Heads(const Mast& mast)
      : r(mast.radius),
        topmastX(mast.topmastX()),
        gallantX(mast.gallantX()),
        topRadius(mast.topRadius()),
        top(mast.x + 0.4 * r, mast.topY(), 0),
        topmastHead(topmastX, mast.deckY + 0.745 * mast.height, 0),
        gallantHead(gallantX, mast.deckY + 0.93 * mast.height, 0) {}
  double r, topmastX, gallantX, topRadius;
  Vec3 top, topmastHead, gallantHead;
};

/// Ropes of one square mast's yards: lifts to the masthead above, braces aft to the places given for starboard, sheets and
/// clew lines.
void drawYardRopes(const Ship& ship, const Mast& mast, const std::array<Vec3, 3>& bracesTo, PartId block) {
  Builder& b = ship.b;
  const Heads heads(mast);
  const Vec3 masthead[] = {heads.top + Vec3(0, 0.1, 0), heads.topmastHead, heads.gallantHead};
  const double x[] = {mast.x + mast.radius + 0.3, heads.topmastX + 0.6 * mast.radius + 0.25,
                      heads.gallantX + 0.36 * mast.radius + 0.2};
  const auto putBlock = [&](const Vec3& at) {
    b.push([&] {
      b.translate(at);
      b.place(block);
    });
  };
  for (std::size_t i = 0; i < mast.sails.size(); ++i) {
    const SquareSail& sail = mast.sails[i];
    for (const int side : kSides) {
      const Vec3 arm(x[i], sail.yardY, side * sail.headWidth * 0.535);
      b.material(ship.m.hemp);
      drawRope(ship, masthead[i] + Vec3(0.1, 0.1, 0.12 * side), arm, 0.024, 3);
      putBlock(arm + Vec3(-0.12, -0.05, 0));
      putBlock(arm + Vec3(0, 0.18, -0.1 * side));
      const Vec3 lead = mirrored(bracesTo[i], side);
      b.material(ship.m.hemp);
      drawSlackRope(ship, arm + Vec3(-0.15, 0, 0), lead, 0.02 * glm::length(lead - arm), 0.022);
      // The clew is held to the yard below, that of the course to the deck.
      const Vec3 clew(x[i] + 0.05, sail.footY, side * sail.footWidth * 0.5);
      if (i > 0) {
        drawRope(ship, clew, {x[i - 1], mast.sails[i - 1].yardY + 0.1, side * mast.sails[i - 1].headWidth * 0.52},
                 0.022, 3);
      } else {
        const double aft = std::max(mast.x - 5.5, 1.0), ahead = std::min(mast.x + 4.5, ship.plan.hull.length - 1.5);
        for (const double to : {aft, ahead}) {
          const double h = ship.plan.railH(to);
          drawRope(ship, clew, mirrored(ship.plan.hull.sideAt(to, h), side), 0.03, 3);
        }
      }
      putBlock(clew);
      // The clew line, by which the sail is taken in.
      b.material(ship.m.hemp);
      drawRope(ship, clew + Vec3(-0.12, 0, 0), {x[i] - 0.15, sail.yardY - 0.1, side * sail.headWidth * 0.12}, 0.018, 3);
    }
  }
}

/// The stays that lead from the mainmast forward.
struct Stays {
  explicit Stays(const Plan& plan) {
    const Heads fore(plan.fore), heads(plan.main);
    const double deck = plan.hull.sideAt(plan.fore.x, plan.deckH(plan.fore.x)).y;
    main = stayBefore(plan.main.sailSurface(0), heads.top + Vec3(0, 0.5, 0), {plan.fore.x - 0.9, deck + 0.5, 0});
    mainTop = stayBefore(plan.main.sailSurface(1), heads.topmastHead, fore.top + Vec3(-0.5, 0.3, 0));
    mainGallant = stayBefore(plan.main.sailSurface(2), heads.gallantHead, fore.topmastHead + Vec3(-0.3, 0.2, 0));
  }
  Segment main, mainTop, mainGallant;
};

void drawStays(const Ship& ship, PartId block) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const HullForm& hull = plan.hull;
  const Heads fore(plan.fore), main(plan.main);
  const auto bowsprit = [&](double share) {
    return glm::mix(plan.bowspritFoot, plan.bowspritTip, share) + Vec3(0, 0.2, 0);
  };
  b.material(ship.m.tarredRope);
  drawRope(ship, fore.top + Vec3(0, 0.5, 0), bowsprit(0.55), 0.06);
  drawRope(ship, fore.topmastHead, bowsprit(0.86), 0.045);
  drawRope(ship, fore.gallantHead, bowsprit(0.98), 0.03);
  const Stays stays(plan);
  drawRope(ship, stays.main.start, stays.main.end, 0.07);
  drawRope(ship, stays.mainTop.start, stays.mainTop.end, 0.045);
  drawRope(ship, stays.mainGallant.start, stays.mainGallant.end, 0.03);
  if (plan.mizzen) {
    const Mast& mizzen = *plan.mizzen;
    const Vec3 top(mizzen.x, mizzen.deckY + 0.6 * mizzen.height, 0),
        head(mizzen.x + 1.4 * mizzen.radius, mizzen.deckY + 0.94 * mizzen.height, 0);
    drawRope(ship, top, {plan.main.x - 0.4, plan.main.deckY + 1.6, 0}, 0.05);
    drawRope(ship, head, main.top + Vec3(-0.6, 0.4, 0), 0.03);
  }
  if (plan.bonaventure) {
    const Mast& mast = *plan.bonaventure;
    const double foot = plan.mizzen->deckY + 1.6;
    drawRope(ship, {mast.x, mast.deckY + 0.6 * mast.height, 0}, {plan.mizzen->x - 0.4, foot, 0}, 0.045);
  }
  // Backstays, from the topmasts' heads to the sides abaft the shrouds.
  const auto backstays = [&](const Mast& mast, const Heads& heads) {
    for (const int side : kSides) {
      int number = 0;
      for (const Vec3& head : {heads.topmastHead, heads.gallantHead}) {
        const double x = mast.x - 0.72 * mast.shrouds - 0.35 - 0.5 * number++;
        const Vec3 foot = mirrored(hull.sideAt(x, mast.channelH), side) + Vec3(0, 0.15, 0.3 * side);
        b.material(ship.m.tarredRope);
        drawRope(ship, head, foot, 0.032);
        b.push([&] {
          b.translate(foot);
          b.place(block);
        });
      }
    }
  };
  backstays(plan.fore, fore);
  backstays(plan.main, main);
}

}  // namespace

void buildRopes(const Ship& ship) {
  Builder& b = ship.b;
  const Plan& plan = ship.plan;
  const PartId deadeye = makeDeadeye(ship);
  b.material(ship.m.darkOak);
  const PartId block = b.part(Vec3(0.0), [&] {
    b.translate({-0.09, -0.15, -0.07});
    b.scale({0.18, 0.3, 0.14});
    b.sphere({8, 0.9});
  });
  for (const Mast* mast : {&plan.fore, &plan.main}) {
    const Heads heads(*mast);
    drawLowerShrouds(ship, *mast, mast->topY() - 0.1, deadeye);
    drawUpperShrouds(ship, heads.top, heads.topRadius * 0.95, heads.topmastHead - Vec3(0, 0.2, 0));
    drawUpperShrouds(ship, heads.topmastHead, heads.topRadius * 0.46, heads.gallantHead);
  }
  for (const auto* mast : {&plan.mizzen, &plan.bonaventure}) {
    if (!*mast) continue;
    drawLowerShrouds(ship, **mast, (*mast)->deckY + 0.565 * (*mast)->height, deadeye);
  }
  // The fore braces lead to the stays of the mainmast, the main braces to the mizzen or to the stern.
  const Heads main(plan.main);
  const Stays stays(plan);
  drawYardRopes(
      ship, plan.fore,
      {glm::mix(stays.main.start, stays.main.end, 0.3), glm::mix(stays.mainTop.start, stays.mainTop.end, 0.35),
       glm::mix(stays.mainGallant.start, stays.mainGallant.end, 0.35)},
      block);
  const double sternX = plan.hull.sternX(plan.hull.depth) + 1.5;
  const Vec3 quarter = plan.hull.sideAt(sternX, plan.railH(sternX));
  std::array<Vec3, 3> leads{quarter, quarter + Vec3(0.5, 0, 0), quarter + Vec3(1, 0, 0)};
  if (plan.mizzen) {
    const Mast& mizzen = *plan.mizzen;
    leads[1] = {mizzen.x, mizzen.deckY + 0.6 * mizzen.height, 0.8 * mizzen.radius};
    leads[2] = {mizzen.x + 1.4 * mizzen.radius, mizzen.deckY + 0.93 * mizzen.height, 0};
  }
  drawYardRopes(ship, plan.main, leads, block);
  drawStays(ship, block);
}

}  // namespace dimline::boat
