#include <catch2/catch.hpp>

#include <utility>

#include "app/json.h"
#include "app/json_writer.h"
#include "models/models.h"
#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"
#include "support/scenes.h"

using namespace dimline;

TEST_CASE("attempts that go on from where another one stood come to what they come to from the start") {
  // In the small viewport lines give way.
  for (const auto& [name, edgePx] : {std::pair("house", 1000.0), {"boat", 1000.0}, {"lever", 1000.0}, {"omni-tree", 1000.0}, {"boat", 360.0}}) {
    INFO(name << " in " << edgePx << " px");
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
    DistanceFields fields;
    ScopeVisibility visibility;
    for (int azimuth = 0; azimuth < 150; ++azimuth) {
      const View view(test::orbitCamera(scene.bounds.center(), 1.6 * scene.bounds.diagonal(), azimuth, 25), edgePx, edgePx, scene.bounds);
      producer.produce(view, fields);
      visible.measure(scene, view, visibility);
      const auto frameOf = [&](Placer& of) {
        Layout layout;
        of.place(view, fields, values, layout, &visibility);
        JsonWriter json;
        writeFrame(json, *model, scene, layout);
        return json.take();
      };
      INFO(azimuth);
      REQUIRE(frameOf(placer) == frameOf(whole));
    }
  }
}
