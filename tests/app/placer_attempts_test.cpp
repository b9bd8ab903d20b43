#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "models/models.h"
#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"

using namespace dimline;

namespace {

bool linesAgree(const PlacedLine& a, const PlacedLine& b) {
  return a.parameter == b.parameter && a.identity == b.identity && a.placement == b.placement && a.chain == b.chain && a.text == b.text &&
         a.lineScreen.start == b.lineScreen.start && a.lineScreen.end == b.lineScreen.end && a.label.has_value() == b.label.has_value() &&
         (!a.label || (a.label->min == b.label->min && a.label->max == b.label->max));
}

bool layoutsAgree(const Layout& a, const Layout& b) {
  const auto sameLine = [](const PlacedLine& p, const PlacedLine& q) { return linesAgree(p, q); };
  const auto sameHidden = [](const HiddenParameter& p, const HiddenParameter& q) { return p.parameter == q.parameter && p.reason == q.reason; };
  return std::ranges::equal(a.lines, b.lines, sameLine) && std::ranges::equal(a.hidden, b.hidden, sameHidden) && a.others.size() == b.others.size();
}

}  // namespace

TEST_CASE("attempts that go on from where another one stood come to what they come to from the start") {
  for (const char* name : {"house", "boat", "lever", "omni-tree"}) {
    INFO(name);
    const auto found = findBuiltInModel(name);
    REQUIRE(found);
    const Values values(found->parameters());
    const Scene scene = found->definition.build(values);
    const auto model = makeModel(found->definition);
    REQUIRE(model);
    CpuFields producer;
    producer.setScene(scene);
    CpuVisibility visible;
    Placer placer, whole;
    whole.placeAttemptsWhole(true);
    for (Placer* each : {&placer, &whole}) each->setScene(*model, scene);
    Camera camera = threeQuarterView(scene.bounds, 1000, 1000);
    DistanceFields fields;
    ScopeVisibility visibility;
    Layout layout, wholeLayout;
    for (int frame = 0; frame < 150; ++frame) {
      const Vec3 arm = camera.eye - camera.target;
      const double turn = 0.0174;
      camera.eye = camera.target + Vec3(std::cos(turn) * arm.x + std::sin(turn) * arm.z, arm.y, std::cos(turn) * arm.z - std::sin(turn) * arm.x);
      const View view(camera, 1000, 1000, scene.bounds);
      producer.produce(view, fields);
      visible.measure(scene, view, visibility);
      placer.place(view, fields, values, layout, &visibility);
      whole.place(view, fields, values, wholeLayout, &visibility);
      REQUIRE(layoutsAgree(layout, wholeLayout));
    }
  }
}
