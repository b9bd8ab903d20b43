#pragma once

#include <utility>
#include <vector>

#include "cli/audit_measure.h"
#include "support/scenes.h"

/// Layouts made by hand for the audit's rows: a flat world that is seen at right angles, 100 px a metre, so that a point
/// of the plane z = 0 and its pixel are easily told from each other.
namespace dimline::test {

inline constexpr int kStagePx = 400;

inline Vec3 worldAt(const Vec2& px) { return {(px.x - 200) / 100, (200 - px.y) / 100, 0}; }
inline Segment worldAt(const Segment2& px) { return {worldAt(px.start), worldAt(px.end)}; }

/// Five lengths on the scope Block, the last but one with slip=none, the last occluded by nothing.
inline ModelDefinition stageDefinition() {
  ModelDefinition definition;
  definition.name = "stage";
  const auto length = [&](const char* name, const char* annotation) {
    definition.parameters.push_back({.name = name,
                                     .title = name,
                                     .unit = Unit::kMetre,
                                     .defaultValue = 1,
                                     .min = 0.5,
                                     .max = 20,
                                     .annotation = annotation});
  };
  length("A", "@Handle(scope=Block, type=linear-contour, orient=up, slip=scope)");
  length("B", "@Handle(scope=Block, type=linear-contour, orient=right, slip=scope)");
  length("C", "@Handle(scope=Block, type=linear-contour, orient=up, slip=billboard, chained)");
  length("D", "@Handle(scope=Block, type=linear-contour, orient=up, slip=none)");
  length("E", "@Handle(scope=Hidden, type=linear-contour, orient=up, slip=scope)");
  definition.build = [](const Values&) { return Scene{}; };
  return definition;
}

/// Their numbers, but for the last.
inline constexpr std::size_t kA = 0, kB = 1, kC = 2, kD = 3;

/// Segments on screen, in pixels.
inline Segment2 vertical(double x, double y0 = 250, double y1 = 150) { return {{x, y0}, {x, y1}}; }
inline Segment2 level(double y, double x0 = 150, double x1 = 250) { return {{x0, y}, {x1, y}}; }

/// One frame on the stage. The model is a block of 2 m (200 px) in the middle unless the test says otherwise.
struct Stage {
  Model model = *makeModel(stageDefinition());
  Scene scene;
  Layout layout;
  CoverageMask pixels;

  Stage() {
    const Obb block = boxAt({-1, -1, -1}, {2, 2, 1});
    addBox(scene, block);
    scene.scopes.push_back({"Block", 0, block});
    scene.scopes.push_back({"Hidden", 0, boxAt({-0.5, -0.5, -0.8}, {1, 1, 0.2})});
    finish(scene);
    Camera camera;
    camera.eye = {0, 0, 10};
    camera.target = Vec3(0.0);
    camera.orthoHeightM = 4;
    layout.view = View(camera, kStagePx, kStagePx, scene.bounds);
    layout.visibleScopes = {0};
    pixels.widthPx = pixels.heightPx = kStagePx;
    pixels.pixels.assign(kStagePx * kStagePx, 0);
    cover(100, 100, 300, 300);
  }

  /// Covers the pixels of [x0, x1) x [y0, y1), or bares them.
  void cover(int x0, int y0, int x1, int y1, bool covered = true) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) pixels.pixels[static_cast<std::size_t>(y * kStagePx + x)] = covered ? 255 : 0;
    }
  }

  /// A line outside, by its pixels.
  PlacedLine& add(std::size_t parameter, const Segment2& base, const Segment2& line) {
    PlacedLine& added = layout.lines.emplace_back();
    added.parameter = parameter;
    added.identity = {
        .parameter = static_cast<std::int32_t>(parameter), .scopeIndex = 0, .baseLine = 0, .plane = 0, .direction = 1};
    added.placement = PlacementKind::kOutside;
    added.planeKind = PlaneKind::kScope;
    added.plane = {worldAt(base.start), {0, 0, 1}};
    added.baseScreen = base;
    added.lineScreen = line;
    added.base = worldAt(base);
    added.line = worldAt(line);
    added.lengthM = added.base.length();
    added.extensionStart = {base.start, line.start};
    added.extensionEnd = {base.end, line.end};
    return added;
  }
  PlacedLine& add(std::size_t parameter, const Segment2& line) { return add(parameter, line, line); }

  [[nodiscard]] AuditTally measured(bool searching = false) const {
    AuditTally tally;
    MaskPicture mask;
    mask.read(pixels);
    DepthPicture depth;
    depth.draw(scene, layout.view);
    measureFrame({&model, &scene, &layout, &mask, &depth}, {}, searching, tally);
    return tally;
  }
  [[nodiscard]] Figure figure(AuditRow row, bool searching = false) const { return measured(searching).figure(row); }
};

}  // namespace dimline::test
