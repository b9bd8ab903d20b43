#include <catch2/catch.hpp>

#include <map>

#include "app/orbit_controls.h"
#include "core/text.h"
#include "editing/arc_drag.h"
#include "editing/handle_drag.h"
#include "models/models.h"
#include "support/stage.h"

// Every end that can be dragged, of every built-in model: the handle stays with the pointer, or the value is at its limit, or no allowed value would bring it
// nearer. What is nearer is found by trying the allowed values one after the other.

using namespace dimline;
using namespace dimline::test;

namespace {

/// px. So far a handle may be from the pointer, along its line; and so much nearer another value must bring it before it would have been the right one.
constexpr double kWithinPx = 3.0;
constexpr double kNearerPx = 0.5;
/// Values that are tried where a range has more of them.
constexpr int kSamples = 240;

/// The sanitizers look for what one view of a few models shows as well as all do, at several times the cost.
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kViews = 1;
bool tested(std::string_view model) { return model == "house" || model == "lever" || model == "helix-house" || model == "facade"; }
#else
constexpr std::size_t kViews = 4;
bool tested(std::string_view) { return true; }
#endif

/// The model with a memory, and no geometry: a drag looks at scopes only.
Model remembered(const Model& model) {
  Model copy = model;
  auto known = std::make_shared<std::map<std::vector<double>, Scene>>();
  copy.definition.build = [build = model.definition.build, known](const Values& values) {
    std::vector<double> key(values.size());
    for (std::size_t i = 0; i < key.size(); ++i) key[i] = values.at(i);
    const auto found = known->find(key);
    if (found != known->end()) return found->second;
    Scene scene = build(values);
    scene.meshes.clear();
    scene.instances.clear();
    return known->emplace(key, std::move(scene)).first->second;
  };
  return copy;
}

std::vector<Camera> cameras(const Scene& scene) {
  std::vector<Camera> all{threeQuarterView(scene.bounds, 1000, 800)};
  const double distanceM = glm::length(all[0].eye - all[0].target);
  all.push_back(orbitCamera(all[0].target, distanceM, 215, 12));
  all.push_back(orbitCamera(all[0].target, 0.8 * distanceM, 100, 48));
  all.push_back(fitToView(withProjection(orbitCamera(all[0].target, distanceM, 0, 5), true), scene.bounds, 1000, 800));
  all.resize(std::min(all.size(), kViews));
  return all;
}

std::vector<double> allowedValues(const Parameter& parameter) {
  std::vector<double> values;
  const double range = parameter.max - parameter.min;
  const double steps = parameter.step > 0 ? std::ceil(range / parameter.step - 1e-9) : kSamples;
  const double stride = std::max(1.0, steps / kSamples);
  for (double i = 0; i < steps; i += stride) values.push_back(snapValue(parameter, parameter.min + std::round(i) * range / steps));
  values.push_back(parameter.max);
  return values;
}

struct Tally {
  int drags = 0;
  double worstPx = 0;      ///< of those that follow
  int heldBack = 0;        ///< at a limit, or between two values
  std::string failures;
};

/// How far a handle is past the pointer, along the line, for a value; nothing when there is no handle then.
using MissPx = std::function<std::optional<double>(double value)>;

void judge(const Parameter& parameter, double start, double value, const MissPx& missOf, const std::string& what, Tally& tally) {
  ++tally.drags;
  const auto miss = missOf(value);
  if (miss && std::abs(*miss) <= kWithinPx) {
    tally.worstPx = std::max(tally.worstPx, std::abs(*miss));
    return;
  }
  ++tally.heldBack;
  double bestPx = miss ? std::abs(*miss) : std::numeric_limits<double>::infinity();
  double best = value;
  std::vector<double> allowed = allowedValues(parameter);
  allowed.push_back(start);
  for (const double other : allowed) {
    const auto otherMiss = missOf(other);
    if (otherMiss && std::abs(*otherMiss) < bestPx - kNearerPx) {
      bestPx = std::abs(*otherMiss);
      best = other;
    }
  }
  if (best == value) return;
  tally.failures += what + ": " + formatValue(parameter, value) + " misses by " + (miss ? formatFixed(*miss, 1) : "everything") + " px, " +
                    formatValue(parameter, best) + " by " + formatFixed(bestPx, 1) + "\n";
}

/// Whether the value ever turns back while the pointer goes on, which would look like trembling.
bool goesToAndFro(HandleDrag& drag, const Vec2& grabbed, const Vec2& along, const View& view) {
  double last = drag.valueAt(grabbed - along * 200.0, view);
  double sense = 0;
  for (double travelPx = -190; travelPx <= 200; travelPx += 10) {
    const double now = drag.valueAt(grabbed + along * travelPx, view);
    if (now == last) continue;
    if (sense != 0 && (now > last) != (sense > 0)) return true;
    sense = now > last ? 1 : -1;
    last = now;
  }
  return false;
}

void dragEnds(const Model& model, Stage& stage, const std::string& where, Tally& tally) {
  const View& view = stage.layout.view;
  for (const PlacedLine& line : stage.layout.lines) {
    const Parameter& parameter = model.parameters()[line.parameter];
    // Of a chain, whose members are all alike, the first and the last.
    if (line.chain >= 0) {
      const auto fellow = [&](const PlacedLine& other) { return other.chain == line.chain; };
      const auto last = std::find_if(stage.layout.lines.rbegin(), stage.layout.lines.rend(), fellow);
      if (&line != &*std::ranges::find_if(stage.layout.lines, fellow) && &line != &*last) continue;
    }
    for (const Handle& handle : line.handles) {
      const Vec2 along = glm::normalize(line.lineScreen.end - line.lineScreen.start);
      const Vec2 grabbed = handle.screen + Vec2(3, -2);
      auto drag = HandleDrag::begin(model, stage.values, stage.scene, line, handle, grabbed, view);
      if (!drag) continue;
      const double start = stage.values.at(line.parameter);
      for (const double travel : {10.0, -10.0, 40.0, -40.0, 200.0, -200.0}) {
        const MissPx missOf = [&](double value) -> std::optional<double> {
          Values values = stage.values;
          values.set(line.parameter, value);
          const auto now = drag->lineOn(model.definition.build(values), values, view);
          if (!now) return std::nullopt;
          return glm::dot((handle.atEnd ? now->lineScreen.end : now->lineScreen.start) - handle.screen, along) - travel;
        };
        const std::string what = where + " " + parameter.name + (handle.atEnd ? " end" : " start") + " by " + formatFixed(travel, 0) + " px";
        for (const Snap snap : {Snap::kStep, Snap::kNone}) {
          judge(parameter, start, drag->valueAt(grabbed + along * travel, view, snap), missOf, what, tally);
        }
      }
      if (goesToAndFro(*drag, grabbed, along, view)) tally.failures += where + " " + parameter.name + ": the value goes to and fro as the pointer goes out\n";
      if (drag->valueAt(grabbed, view) != start) tally.failures += where + " " + parameter.name + ": there and back is another value\n";
    }
  }
}

void dragArcs(const Model& model, Stage& stage, const std::string& where, Tally& tally) {
  const View& view = stage.layout.view;
  for (const PlacedHandle& handle : stage.layout.others) {
    if (!handle.arc) continue;
    const Parameter& parameter = model.parameters()[handle.parameter];
    const Vec2 tip = view.toScreen(handle.arc->at(handle.arc->angleRad));
    auto drag = ArcDrag::begin(model, stage.values, handle, tip, view);
    if (!drag) continue;
    const double start = stage.values.at(handle.parameter);
    for (const double travel : {10.0, -10.0, 40.0, -40.0, 200.0, -200.0}) {
      // A pointer that goes along the arc, so that there is an angle under it.
      const double pxPerRad = glm::length(view.toScreen(handle.arc->at(handle.arc->angleRad + 1e-3)) - tip) * 1e3;
      const double turnRad = std::clamp(travel / pxPerRad, -3.0, 3.0);
      const Vec2 pointer = view.toScreen(handle.arc->at(handle.arc->angleRad + turnRad));
      const MissPx missOf = [&](double value) -> std::optional<double> {
        return glm::length(view.toScreen(handle.arc->at(value * kRadPerDeg)) - pointer);
      };
      const double value = drag->valueAt(pointer, view);
      // Beyond a limit it may be that the other one is nearer, across the circle; nobody who passes one limit means the other.
      const bool atLimit = value == parameter.min || value == parameter.max;
      if (atLimit) ++tally.heldBack;
      if (!atLimit) judge(parameter, start, value, missOf, where + " " + parameter.name + " by " + formatFixed(travel, 0) + " px", tally);
    }
    if (drag->valueAt(tip, view) != start) tally.failures += where + " " + parameter.name + ": there and back is another value\n";
  }
}

}  // namespace

TEST_CASE("every handle of every model stays under the pointer, as far as its values allow") {
  for (const BuiltInModel& builtIn : builtInModels()) {
    if (!tested(builtIn.name)) continue;
    Stage stage(builtIn.define());
    const Model model = remembered(stage.model);
    Tally tally;
    int number = 0;
    for (const Camera& camera : cameras(stage.scene)) {
      stage.placer.forget();
      stage.look(camera, 1000, 800);
      const std::string where = std::string(builtIn.name) + ", view " + std::to_string(number++);
      dragEnds(model, stage, where, tally);
      dragArcs(model, stage, where, tally);
    }
    INFO(builtIn.name << ": " << tally.drags << " drags, " << tally.heldBack << " held back by their values, worst " << tally.worstPx << " px\n"
                      << tally.failures);
    CHECK(tally.failures.empty());
    REQUIRE(tally.drags > 0);
  }
}
