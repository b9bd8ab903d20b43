#pragma once

#include <memory>
#include <optional>

#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "support/scenes.h"

namespace dimline::test {

/// A model with everything a frame needs, as an editor would hold it.
struct Stage {
  Model model;
  Values values;
  Scene scene;
  CpuFields producer;
  DistanceFields fields;
  Placer placer;
  Layout layout;

  explicit Stage(ModelDefinition definition) : model(makeModel(std::move(definition)).value()), values(model.parameters()) { rebuild(); }

  void rebuild() {
    scene = model.definition.build(values);
    producer.setScene(scene);
    placer.setScene(model, scene);
  }
  const Layout& look(const Camera& camera, double width = 1000, double height = 1000, const ScopeVisibility* visibility = nullptr) {
    const View view(camera, width, height, scene.bounds);
    producer.produce(view, fields);
    placer.place(view, fields, values, layout, visibility);
    return layout;
  }
  [[nodiscard]] std::string nameOf(const PlacedLine& line) const { return model.parameters()[line.parameter].name; }
  [[nodiscard]] const PlacedLine* find(std::string_view name) const {
    for (const PlacedLine& line : layout.lines) {
      if (nameOf(line) == name) return &line;
    }
    return nullptr;
  }
  /// Why a parameter is not shown; nothing when it is, or no reason is given.
  [[nodiscard]] std::optional<HiddenReason> reasonFor(std::string_view name) const {
    for (const HiddenParameter& hidden : layout.hidden) {
      if (model.parameters()[hidden.parameter].name == name) return hidden.reason;
    }
    return std::nullopt;
  }
};

}  // namespace dimline::test
