#include "cli/audit_flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cli/audit_geometry.h"
#include "cli/audit_measure.h"
#include "core/text.h"
#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

namespace {

constexpr int kRoundFrames = 90;
constexpr int kZoomFrames = 130;
// What is at the rim moves as far in a step as in a turn by one degree, for which the aims are meant.
constexpr double kZoomStep = 1 - kRadPerDeg;

Vec3 directionFrom(double azimuthDeg, double elevationDeg) {
  const double azimuth = azimuthDeg * kRadPerDeg;
  const double elevation = elevationDeg * kRadPerDeg;
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

/// Numbers that are the same on every machine: splitmix64.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double between(double from, double to) { return from + (to - from) * (static_cast<double>(next() >> 11) * 0x1p-53); }

private:
  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// A camera that looks at the middle of the bounds from a direction, fitted to the viewport.
Camera fitted(const Bounds& bounds, const Vec3& from, Camera lens, double widthPx, double heightPx) {
  lens.target = bounds.center();
  lens.eye = lens.target + from * std::max(bounds.diagonal(), 1e-6);
  return fitToView(lens, bounds, widthPx, heightPx);
}

/// The greatest distance, or orthographic height, that fitting gives on the way round: nearer, the model would leave
/// its frame.
Camera fittedFromEverywhere(const Bounds& bounds, double elevationDeg, const Camera& lens, double widthPx,
                            double heightPx) {
  Camera widest;
  double greatest = -1;
  for (int azimuth = 0; azimuth < 360; azimuth += 15) {
    const Camera camera = fitted(bounds, directionFrom(azimuth, elevationDeg), lens, widthPx, heightPx);
    const double reach = camera.orthoHeightM.value_or(glm::length(camera.eye - camera.target));
    if (reach > greatest) {
      greatest = reach;
      widest = camera;
    }
  }
  return widest;
}

Camera turnedTo(const Camera& camera, const Vec3& target, double azimuthDeg, double elevationDeg, double zoom) {
  Camera turned = camera;
  turned.target = target;
  double distance = glm::length(camera.eye - camera.target);
  if (turned.orthoHeightM) {
    *turned.orthoHeightM *= zoom;
  } else {
    distance *= zoom;
  }
  turned.eye = target + directionFrom(azimuthDeg, elevationDeg) * distance;
  return turned;
}

}  // namespace

Flight orbit(const Bounds& bounds, double elevationDeg, double stepDeg, double widthPx, double heightPx) {
  Flight flight{.widthPx = widthPx, .heightPx = heightPx};
  const Camera widest = fittedFromEverywhere(bounds, elevationDeg, Camera{}, widthPx, heightPx);
  const int frames = std::max(1, static_cast<int>(360.0 / stepDeg + 1e-9));
  for (int i = 0; i < frames; ++i) {
    const double azimuthDeg = i * stepDeg;
    flight.cameras.push_back(turnedTo(widest, bounds.center(), azimuthDeg, elevationDeg, 1));
    flight.names.push_back({.flight = "elevation " + formatFixed(elevationDeg, 0),
                            .frame = i,
                            .azimuthDeg = azimuthDeg,
                            .elevationDeg = elevationDeg});
  }
  return flight;
}

Flight randomFlight(const Bounds& bounds, std::uint64_t number) {
  constexpr std::array<std::array<double, 2>, 6> kViewports{
      {{300, 200}, {3840, 2160}, {1000, 1000}, {360, 640}, {1920, 1080}, {800, 600}}};
  Dice dice(number);
  const auto& viewport = kViewports[number % kViewports.size()];
  Flight flight{.widthPx = viewport[0], .heightPx = viewport[1]};
  double azimuthDeg = dice.between(0, 360);
  const double elevationDeg = dice.between(-5, 85);
  const double turn = dice.between(0, 1) < 0.5 ? 1.0 : -1.0;
  Camera lens;
  lens.fovRad = 0.2 * std::pow(500.0, dice.between(0, 1)) * kRadPerDeg;
  if ((number + number / kViewports.size()) % 3 == 2) lens.orthoHeightM = 1;  // in each viewport by turns
  const Camera start = fittedFromEverywhere(bounds, elevationDeg, lens, flight.widthPx, flight.heightPx);
  const std::string name =
      "flight " + std::to_string(number) + " " + formatFixed(flight.widthPx, 0) + "x" +
      formatFixed(flight.heightPx, 0) +
      (lens.orthoHeightM ? ", orthographic" : ", " + formatFixed(lens.fovRad / kRadPerDeg, 1) + " deg");
  double zoom = 1;
  const auto record = [&](int leg) {
    flight.cameras.push_back(turnedTo(start, start.target, azimuthDeg, elevationDeg, zoom));
    flight.names.push_back({.flight = name,
                            .frame = static_cast<int>(flight.names.size()),
                            .azimuthDeg = std::fmod(azimuthDeg + 720, 360),
                            .elevationDeg = elevationDeg,
                            .leg = leg});
  };
  for (int i = 0; i < kRoundFrames; ++i, azimuthDeg += turn) record(0);
  for (int i = 0; i < kZoomFrames; ++i, zoom *= kZoomStep, azimuthDeg += 0.25 * turn) record(1);
  for (int i = 0; i < kZoomFrames; ++i, zoom /= kZoomStep, azimuthDeg += 0.25 * turn) record(2);
  return flight;
}

FlownFlight fly(const Model& model, const Scene& scene, const Values& values, Flight flight, AuditTally& tally) {
  FlownFlight flown{.flight = std::move(flight), .layouts = {}};
  Placer placer;
  Placer stillPlacer;
  CpuFields cpu;
  CpuVisibility visible;
  placer.setScene(model, scene);
  stillPlacer.setScene(model, scene);
  cpu.setScene(scene);
  DistanceFields fields;
  ScopeVisibility visibility;
  std::array<Layout, 3> still;
  for (std::size_t i = 0; i < flown.flight.cameras.size(); ++i) {
    const View view(flown.flight.cameras[i], flown.flight.widthPx, flown.flight.heightPx, scene.bounds);
    cpu.produce(view, fields);
    visible.measure(scene, view, visibility);
    const bool rests = flown.flight.restEvery > 0 && i > 0 && i % flown.flight.restEvery == 0;
    const auto placeIn = [&](Placer& by, bool settled, Layout& layout) {
      if (settled)
        by.placeSettled(view, fields, values, layout, &visibility);
      else
        by.place(view, fields, values, layout, &visibility);
    };
    placeIn(placer, rests, flown.layouts.emplace_back());
    for (Layout& layout : still) placeIn(stillPlacer, rests && &layout == &still.front(), layout);
    measureStill(model, still[0], still[1], flown.flight.names[i], tally);
    measureStill(model, still[1], still[2], flown.flight.names[i], tally);
  }
  return flown;
}

namespace {

/// Something flat of a fixed size on screen, tied to a point of the world.
struct FrozenBox {
  Vec3 world{0.0};
  Vec2 size{0.0};
  [[nodiscard]] std::optional<Box2> in(const View& view) const {
    if (!view.inFrontOfNear(world)) return std::nullopt;
    const Vec2 center = view.toScreen(world);
    return Box2{center - size * 0.5, center + size * 0.5};
  }
};

/// Ties a box to the point of a plane that is under its middle; to `otherwise` when the plane is seen edge-on.
FrozenBox freeze(const Box2& box, const View& view, const Vec3& point, const Vec3& normal, const Vec3& otherwise) {
  const View::Ray ray = view.rayThrough(box.center());
  const double facing = glm::dot(ray.direction, normal);
  return {std::abs(facing) > 1e-6 ? ray.origin + ray.direction * (glm::dot(point - ray.origin, normal) / facing)
                                  : otherwise,
          box.max - box.min};
}

/// The first frame, with what is flat in it tied to the world.
class FrozenFrame {
public:
  FrozenFrame(const Layout& first, const Scene& scene) : first_(first) {
    for (const PlacedLine& line : first.lines) {
      const Vec3 normal = line.planeKind == PlaneKind::kNone ? first.view.forward() : line.plane.normal;
      labels_.push_back(line.label ? freeze(*line.label, first.view, line.line.start, normal, line.line.middle())
                                   : FrozenBox{});
    }
    for (const PlacedHandle& handle : first.others) {
      const Vec3 middle = scene.scopes[handle.scope].box.center();
      boxes_.push_back(freeze(handle.box, first.view, middle, first.view.forward(), middle));
      anchors_.push_back(freeze({handle.anchor, handle.anchor}, first.view, middle, first.view.forward(), middle));
    }
  }

  /// The frame as another camera sees it. What is not before the viewer is not there.
  [[nodiscard]] Layout seenFrom(const View& view) const {
    Layout layout;
    layout.view = view;
    layout.hidden = first_.hidden;
    layout.visibleScopes = first_.visibleScopes;
    for (std::size_t i = 0; i < first_.lines.size(); ++i) addLine(i, layout);
    for (std::size_t i = 0; i < first_.others.size(); ++i) {
      const auto box = boxes_[i].in(view);
      const auto anchor = anchors_[i].in(view);
      if (!box || !anchor) continue;
      if (first_.others[i].arc && drawnArc(first_.others[i], view).curve.empty()) continue;
      PlacedHandle& handle = layout.others.emplace_back(first_.others[i]);
      handle.box = *box;
      handle.anchor = anchor->min;
    }
    return layout;
  }

private:
  void addLine(std::size_t i, Layout& layout) const {
    const PlacedLine& fixed = first_.lines[i];
    const auto before = [&](const Segment& s) { return layout.view.inFrontOfNear(s); };
    if (!before(fixed.line) || !before(fixed.base)) return;
    PlacedLine& line = layout.lines.emplace_back(fixed);
    line.lineScreen = layout.view.toScreen(line.line);
    line.baseScreen = layout.view.toScreen(line.base);
    if (!line.extensionStart.empty()) line.extensionStart = {line.baseScreen.start, line.lineScreen.start};
    if (!line.extensionEnd.empty()) line.extensionEnd = {line.baseScreen.end, line.lineScreen.end};
    for (Handle& handle : line.handles) handle.screen = handle.atEnd ? line.lineScreen.end : line.lineScreen.start;
    if (line.label) line.label = labels_[i].in(layout.view);
  }

  const Layout& first_;
  std::vector<FrozenBox> labels_;
  std::vector<FrozenBox> boxes_, anchors_;
};

}  // namespace

std::vector<Layout> frozen(const FlownFlight& flown, const Scene& scene) {
  const FrozenFrame first(flown.layouts.front(), scene);
  std::vector<Layout> layouts;
  for (const Camera& camera : flown.flight.cameras) {
    layouts.push_back(first.seenFrom(View(camera, flown.flight.widthPx, flown.flight.heightPx, scene.bounds)));
  }
  return layouts;
}

}  // namespace dimline
