#include <catch2/catch.hpp>

#include <algorithm>

#include "app/editor_stage.h"
#include "math/geometry.h"
#include "models/models.h"
#include "support/stage.h"

// What a picture that has settled looks like as a whole, in built-in models.

using namespace dimline;
using namespace dimline::test;

namespace {

/// Calls `use(layout)` where an editor has settled after turns all round the model.
template <typename Use>
void forEachRest(ModelDefinition model, Use use) {
  EditorStage stage(std::move(model), 976, 744);
  const Camera home = stage.editor.camera();
  use(stage.editor.layout());
  const Vec3 away = home.eye - home.target;
  for (int deg = 40; deg < 360; deg += 40) {
    const double rad = deg * kRadPerDeg;
    Camera camera = home;
    camera.eye = home.target + Vec3(away.x * std::cos(rad) + away.z * std::sin(rad), away.y, away.z * std::cos(rad) - away.x * std::sin(rad));
    REQUIRE(stage.editor.setCamera(camera));
    stage.settle();
    use(stage.editor.layout());
  }
}

}  // namespace

TEST_CASE("threads of switches and choices do not cross where lines have settled") {
  std::size_t threads = 0, crossings = 0;
  forEachRest(defineOmniTree(), [&](const Layout& layout) {
    std::vector<Segment2> shown;
    for (const PlacedHandle& pill : layout.others) {
      if (!pill.arc && !pill.box.contains(pill.anchor)) shown.push_back({pill.anchor, pill.box.center()});
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) crossings += segmentsCross(shown[i], shown[j]) ? 1 : 0;
    }
    threads += shown.size();
  });
  CHECK(threads >= 9 * 5);
  CHECK(crossings == 0);
}

TEST_CASE("a row that is seen as a whole is measured, not one of which a corner shows") {
  EditorStage stage(defineParthenon(), 976, 744);
  const auto bays = std::ranges::count(stage.editor.layout().lines, stage.indexOf("ColumnSpacing"), &PlacedLine::parameter);
  CHECK(bays >= 7);
}

TEST_CASE("where lines have settled a long line has its number beside itself, and a chain's stand on one side") {
  for (const auto define : {defineHouse, defineParthenon}) {
    std::size_t numbers = 0, beyond = 0, chains = 0, mixed = 0;
    forEachRest(define(), [&](const Layout& layout) {
      for (auto line = layout.lines.begin(); line != layout.lines.end();) {
        const auto end = std::find_if(line, layout.lines.end(), [&](const PlacedLine& other) { return other.parameter != line->parameter; });
        const auto isBeyond = [](const PlacedLine& l) { return l.labelPlace.side == LabelPlace::Side::kBeyondEnd || l.labelPlace.side == LabelPlace::Side::kBeyondStart; };
        if (line->chain < 0 && line->placement != PlacementKind::kInside && line->lineScreen.length() > 100 && line->label) {
          ++numbers;
          beyond += isBeyond(*line) ? 1 : 0;
        }
        if (line->chain >= 0) {
          ++chains;
          const auto first = std::find_if(line, end, [](const PlacedLine& l) { return l.label.has_value(); });
          mixed += std::any_of(first, end, [&](const PlacedLine& l) { return l.label && l.labelPlace.side != first->labelPlace.side; }) ? 1 : 0;
        }
        line = end;
      }
    });
    CHECK(numbers > 9);
    CHECK(chains > 5);
    CHECK(beyond <= numbers / 10);
    CHECK(mixed <= chains / 10);
  }
}

TEST_CASE("after an edit a chain's numbers stand on one side and at an even step again, without a turn of the camera") {
  EditorStage stage(defineParthenon(), 976, 744);
  const std::size_t parameter = stage.indexOf("ColumnSpacing");
  int chains = 0;
  for (const double spacing : {3.6, 4.6, 5.4, 6.0, 5.0, 4.0}) {
    stage.set("ColumnSpacing", spacing);
    stage.settle();
    // Along the chain, the picture's x.
    std::vector<std::pair<double, const PlacedLine*>> chain;
    for (const PlacedLine& line : stage.editor.layout().lines) {
      if (line.parameter == parameter && line.chain >= 0) chain.emplace_back(line.lineScreen.middle().x, &line);
    }
    std::ranges::sort(chain);
    std::vector<std::size_t> numbered;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (chain[i].second->label) numbered.push_back(i);
    }
    if (numbered.size() < 2) continue;
    ++chains;
    CAPTURE(spacing, numbered);
    for (std::size_t i = 1; i < numbered.size(); ++i) {
      CHECK(numbered[i] - numbered[i - 1] == numbered[1] - numbered[0]);
      CHECK(chain[numbered[i]].second->labelPlace.side == chain[numbered[0]].second->labelPlace.side);
    }
  }
  CHECK(chains >= 4);
}

TEST_CASE("where lines have settled a line keeps further from the number of another than that one's line does") {
  std::size_t numbers = 0, near = 0;
  forEachRest(defineParthenon(), [&](const Layout& layout) {
    for (const PlacedLine& inner : layout.lines) {
      if (!inner.label || inner.labelPlace.side != LabelPlace::Side::kOutward) continue;
      ++numbers;
      const Box2 around = inner.label->grown(kLabelClearanceSettledPx - 2);
      near += std::ranges::any_of(layout.lines, [&](const PlacedLine& line) { return line.parameter != inner.parameter && line.placement != PlacementKind::kInside && meets(line.lineScreen, around); }) ? 1 : 0;
    }
  });
  CHECK(numbers > 20);
  CHECK(near <= numbers / 10);
}

TEST_CASE("in a small viewport few lines give way, while the camera moves and where they have settled") {
  Stage stage(defineBoat());
  const Bounds& bounds = stage.scene.bounds;
  const auto crowded = [&] { return std::ranges::count(stage.layout.hidden, HiddenReason::kCrowded, &HiddenParameter::reason); };
  std::ptrdiff_t moving = 0, settled = 0, frames = 0, rests = 0;
  for (int deg = 0; deg < 360; deg += 4) {
    stage.look(orbitCamera(bounds.center(), 2.2 * bounds.diagonal(), deg, 15), 300, 200);
    moving += crowded();
    ++frames;
    if (deg % 40 != 0) continue;
    stage.placer.placeSettled(stage.layout.view, stage.fields, stage.values, stage.layout);
    settled += crowded();
    ++rests;
  }
  // One is the switch, for which there is no room. When the shortest go until none runs into another it is a dozen in the mean.
  CHECK(moving < 4 * frames);
  CHECK(settled < 4 * rests);
}
