#include <catch2/catch.hpp>

#include "placement/history.h"

using namespace dimline;

namespace {

Identity side(std::int16_t baseLine) { return {.parameter = 3, .scopeIndex = 0, .baseLine = baseLine, .plane = 0, .direction = 1}; }

}  // namespace

TEST_CASE("the last frame's choice is favoured, what was left of late is not, anything else is neither") {
  History history(3);
  CHECK(history.last().parameter == 3);
  history.choose(side(0), 1.0);
  CHECK(history.last() == side(0));
  CHECK(history.bonus(side(0)) == kScoreStay);
  CHECK(history.bonus(side(1)) == 0.0);
  history.choose(side(1), 1.0);
  CHECK(history.bonus(side(1)) == kScoreStay);
  CHECK(history.bonus(side(0)) == kScoreReturn);
}

TEST_CASE("what was left is free again after kReturnFrames moved frames, and never before a still camera") {
  History history(3);
  history.choose(side(0), 1.0);
  history.choose(side(1), 1.0);
  for (int i = 0; i < 500; ++i) history.choose(side(1), 1.0);
  CHECK(history.bonus(side(0)) == kScoreReturn);
  for (int i = 0; i < kReturnFrames - 1; ++i) history.age();
  CHECK(history.bonus(side(0)) == kScoreReturn);
  history.age();
  CHECK(history.bonus(side(0)) == 0.0);
}

TEST_CASE("a line that was hidden begins anew") {
  History history(3);
  history.choose(side(0), 1.0);
  history.choose(side(1), 1.0);
  history.choseNone();
  CHECK(history.bonus(side(0)) == 0.0);
  CHECK(history.bonus(side(1)) == 0.0);
  CHECK(history.last().parameter == 3);
}

TEST_CASE("a line comes nearer by a step at most, and is never further out than its share allows") {
  History history(3);
  history.choose(side(0), 2.6);
  CHECK(history.relaxedOffsetM(2.1, 0.25) == Approx(2.35));
  CHECK(history.relaxedOffsetM(2.5, 0.25) == Approx(2.5));      // it must be further out than the step would bring it
  CHECK(history.relaxedOffsetM(1.5, 0.25) == Approx(1.5 * kMostOffsetRatio));
  CHECK(history.relaxedOffsetM(0.1, 0.25) == Approx(2.6 - kHurryFactor * 0.25));   // far beyond its share it hurries, without a leap
  CHECK(history.relaxedOffsetM(1.0, 0.0) == Approx(2.6));       // before a still camera nothing moves
  history.forgetOffset();
  CHECK(history.relaxedOffsetM(1.0, 0.25) == Approx(1.0));      // the model has changed
}

TEST_CASE("a line that would leap has no reason to stay") {
  History history(3);
  const Segment2 then{{0, -30}, {0, -30}};
  history.choose(side(0), 1.0, then);
  CHECK(history.stays(side(0), then));
  CHECK_FALSE(history.stays(side(0), {{0, -30}, {0, -31}}));     // before a still camera it lies exactly where it did
  history.age();
  CHECK(history.stays(side(0), {{0, -30}, {0, -31}}));
  CHECK(history.bonus(side(0), then) == kScoreStay);
  CHECK(history.bonus(side(0), {{0, -30}, {0, -30 - kLeapPx + 1}}) == kScoreStay);
  CHECK(history.bonus(side(0), {{0, -30}, {0, -30 - kLeapPx - 1}}) == 0.0);   // one end is enough
  history.forgetOffset();
  CHECK(history.bonus(side(0), {{0, -300}, {0, -300}}) == kScoreStay);        // the model has changed: what was moved is no leap
}

TEST_CASE("how long a choice is held, and whether there was one, is remembered") {
  History history(3);
  CHECK_FALSE(history.hidden());
  history.choose(side(0), 1.0);
  for (int i = 0; i < 3; ++i) history.age();
  history.choose(side(0), 1.1);
  CHECK(history.framesHeld() == 3);
  history.choose(side(1), 1.0);
  CHECK(history.framesHeld() == 0);
  history.choseNone();
  CHECK(history.hidden());
  history.choose(side(1), 1.0);
  CHECK_FALSE(history.hidden());
}

TEST_CASE("for some moved frames it is remembered that something came, or went") {
  History history(3);
  const auto ageBy = [&](int frames) {
    for (int i = 0; i < frames; ++i) history.age();
  };
  history.choseNone();
  CHECK_FALSE(history.wentLately());        // it never was there
  history.choose(side(0), 1.0);
  CHECK_FALSE(history.cameLately());        // before a still camera nothing is otherwise than in the frame in which it came
  ageBy(1);
  CHECK(history.cameLately());
  history.choose(side(1), 1.0);             // another place is no other coming
  ageBy(kDwellFrames - 2);
  history.choose(side(1), 1.0);
  CHECK(history.cameLately());
  ageBy(1);
  CHECK_FALSE(history.cameLately());
  history.choseNone();
  CHECK(history.wentLately());
  ageBy(kDwellFrames - 1);
  history.choseNone();
  CHECK(history.wentLately());
  ageBy(1);
  CHECK_FALSE(history.wentLately());
  History first(3);
  first.choose(side(0), 1.0);               // what is in the first picture has come with it
  first.age();
  CHECK(first.cameLately());
}

TEST_CASE("a choice that was found better than another is held from then on") {
  History history(3);
  history.choose(side(0), 1.0);
  for (int i = 0; i < 3; ++i) history.age();
  history.choose(side(0), 1.0);
  history.prefer();
  CHECK(history.framesHeld() == 0);
}

TEST_CASE("a better kind of place must have been there for some moved frames on end") {
  History history(3);
  for (int i = 0; i < kPatienceFrames; ++i) {
    history.age();
    CHECK_FALSE(history.betterIsThere());
    CHECK_FALSE(history.betterIsThere());   // to be asked again in the same frame says nothing new
  }
  history.age();
  CHECK(history.betterIsThere());
  history.age();                            // a frame without
  history.age();
  CHECK_FALSE(history.betterIsThere());
}

TEST_CASE("chains that are remembered get the numbers of another model, and those that are gone are forgotten") {
  const auto chain = [](std::int32_t number) { return Identity{.parameter = 0, .chain = number, .baseLine = 0, .plane = 0, .direction = 1}; };
  History history(0);
  history.choose(chain(2), 1);
  history.age();
  history.choose(chain(5), 1);
  history.renumberChains([](std::int32_t number) { return number == 5 ? 7 : 3; });
  CHECK(history.last() == chain(7));
  CHECK(history.leftLately(chain(3)));
  CHECK_FALSE(history.leftLately(chain(2)));
  history.renumberChains([](std::int32_t) { return -1; });
  CHECK_FALSE(history.any());
  CHECK_FALSE(history.leftLately(chain(3)));

  History single(0);
  single.choose({.parameter = 0, .scopeIndex = 1, .baseLine = 0, .plane = 0, .direction = 1}, 1);
  const Identity before = single.last();
  single.renumberChains([](std::int32_t) { return -1; });
  CHECK(single.last() == before);
}

TEST_CASE("what a line has gone back to is no longer left") {
  History history(3);
  history.choose(side(0), 1.0);
  history.choose(side(1), 1.0);
  CHECK(history.leftLately(side(0)));
  history.choose(side(0), 1.0);
  CHECK_FALSE(history.leftLately(side(0)));
  CHECK(history.leftLately(side(1)));
}

TEST_CASE("a line moves out by a step at most, from where it was") {
  History history(3);
  CHECK(history.mostOffsetM(0.25) == std::numeric_limits<double>::infinity());
  history.choose(side(0), 2.0);
  CHECK(history.mostOffsetM(0.25) == Approx(2.25));
  CHECK(history.mostOffsetM(0.0) == 2.0);   // before a still camera nothing moves
  history.forgetOffset();
  CHECK(history.mostOffsetM(0.25) == std::numeric_limits<double>::infinity());
}

TEST_CASE("what is shown anew is so before a still camera too, and no longer in the next moved frame") {
  History history(3);
  history.choose(side(0), 1.0);
  CHECK_FALSE(history.shownAnew());
  history.choseNone();
  CHECK(history.shownAnew());
  history.age();
  history.choose(side(0), 1.0);
  CHECK(history.shownAnew());
  history.choose(side(0), 1.0);
  CHECK(history.shownAnew());
  history.age();
  CHECK_FALSE(history.shownAnew());
  history.choose(side(0), 1.0);
  CHECK_FALSE(history.shownAnew());
}
