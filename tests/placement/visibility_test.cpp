#include "placement/visibility.h"

#include <catch2/catch.hpp>

#include "core/constants.h"
#include "support/scenes.h"

using namespace dimline;
using namespace dimline::test;

namespace {

/// One that has been in sight, or out of it, for a long time.
Sight settled(bool seen) {
  Sight sight;
  sight.see(seen ? 1.0 : 0.0);
  sight.age(kReturnFrames);
  return sight;
}

}  // namespace

TEST_CASE("a scope is shown when enough of it is seen, and kept while a little is") {
  CHECK(Sight().see(kSeenShareToShow));
  CHECK_FALSE(Sight().see(kSeenShareToShow * 0.99));
  CHECK(settled(true).see(kSeenShareToKeep));
  CHECK_FALSE(settled(true).see(kSeenShareToKeep * 0.99));
  CHECK(settled(false).see(kSeenShareToShow));
  CHECK_FALSE(settled(false).see(kSeenShareToShow * 0.99));
}

TEST_CASE("what has just come into sight stays for a while, whatever is seen of it") {
  Sight sight = settled(false);
  REQUIRE(sight.see(0.5));
  for (int frame = 1; frame < kReturnFrames - 1; ++frame) {
    sight.age(1);
    REQUIRE(sight.see(0.0));
  }
  sight.age(1);
  CHECK_FALSE(sight.see(0.0));
}

TEST_CASE("a frame in which nothing is seen of what was plainly seen means little, several on end do not") {
  Sight sight = settled(true);
  REQUIRE(sight.see(0.6));
  for (int round = 0; round < 5; ++round) {
    for (int frame = 1; frame < kFramesToLoseSight; ++frame) {
      sight.age(1);
      REQUIRE(sight.see(0.0));
    }
    sight.age(1);
    REQUIRE(sight.see(0.6));
  }
  int frames = 0;
  do {
    sight.age(1);
    ++frames;
  } while (sight.see(0.0) && frames < kReturnFrames);
  CHECK(frames == kFramesToLoseSight);
}

TEST_CASE("what only stays in sight is not seen enough") {
  Sight sight = settled(true);
  REQUIRE(sight.see(kSeenShareToKeep));
  CHECK(sight.seenEnough());
  sight.age(1);
  REQUIRE(sight.see(0.0));
  CHECK_FALSE(sight.seenEnough());
  sight.age(1);
  REQUIRE(sight.see(kSeenShareToKeep));
  CHECK(sight.seenEnough());
}

TEST_CASE("what has just left comes back only when plenty is seen, and later as at first") {
  Sight sight = settled(true);
  REQUIRE_FALSE(sight.see(0.0));
  sight.age(1);
  CHECK_FALSE(sight.see(kSeenShareToShowAgain * 0.99));
  Sight returning = sight;
  CHECK(returning.see(kSeenShareToShowAgain));
  sight.age(kReturnFrames);
  CHECK(sight.see(kSeenShareToShow));
}

TEST_CASE("a quick turn counts as many frames") {
  Sight sight = settled(false);
  REQUIRE(sight.see(1.0));
  sight.age(kReturnFrames);
  CHECK_FALSE(sight.see(0.0));
}

TEST_CASE("before a still camera a scope stays seen or unseen") {
  for (const double share : {0.0, 0.01, 0.03, 0.1, 0.5}) {
    for (const bool was : {false, true}) {
      Sight sight = settled(was);
      const bool first = sight.see(share);
      sight.age(0);
      CHECK(sight.see(share) == first);
    }
  }
}

TEST_CASE("another share before a still camera counts at once") {
  Sight shown = settled(false);
  REQUIRE(shown.see(1.0));       // as it was thought to be before it was measured, or before an edit
  shown.age(0);
  CHECK_FALSE(shown.see(0.01));
  shown.age(0);
  CHECK_FALSE(shown.see(0.01));
  shown.age(0);
  CHECK(shown.see(kSeenShareToShow));         // no need to be seen by the third: nothing flickers
}

TEST_CASE("what is in view in part is not wholly in view, nor in plain view") {
  // 20 m of height are seen: from -10 to 10, and as much across.
  const View view(straightAt(0), 1000, 1000, Bounds{Vec3(-50), Vec3(50)});
  const auto box = [](double fromX, double toZ) { return boxAt({fromX, -1, toZ - 1}, {2, 2, 1}); };
  const auto views = [&](const Obb& of) { return std::pair(inView(view, of), wholeInView(view, of)); };
  CHECK(views(box(0, 0)) == std::pair(true, true));
  CHECK(views(box(7.9, 0)) == std::pair(true, true));
  CHECK(views(box(8.1, 0)) == std::pair(true, false));
  CHECK(views(box(9.1, 0)) == std::pair(true, false));   // its middle is out
  CHECK(views(box(10.1, 0)) == std::pair(false, false));
  // In perspective nothing behind the viewer, at 30, is in view.
  const View from30(orbitCamera({0, 0, 0}, 30, 0, 0), 1000, 1000, Bounds{Vec3(-50), Vec3(50)});
  CHECK(wholeInView(from30, box(0, 0)));
  CHECK_FALSE(inView(from30, box(0, 32)));
  CHECK_FALSE(wholeInView(from30, box(0, 32)));

  Sight half;
  half.see(kSeenShareInPlainView);
  CHECK(inPlainView(view, box(0, 0), half, false));
  CHECK_FALSE(inPlainView(view, box(8.1, 0), half, true));
  Sight little;
  little.see(0.99 * kSeenShareInPlainView);
  CHECK_FALSE(inPlainView(view, box(0, 0), little, false));
  CHECK(inPlainView(view, box(0, 0), little, true));
}
