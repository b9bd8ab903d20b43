#include "cli/audit_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ostream>
#include <thread>

#include "cli/audit_measure.h"
#include "cli/audit_odds.h"
#include "core/text.h"

// A flight is placed first, frame after frame, as frames know of each other; that is quick. Its frames are then held
// against their pixels, each for itself and so on all processors. The parts are added up in the order of the frames.

namespace dimline {

namespace {

constexpr std::array kElevationsDeg = {10.0, 30.0, 60.0};
constexpr int kEveryAtExtremes = 15;
constexpr int kEveryInFlights = 12;

/// How many steps make up an angle.
int framesIn(double deg, double stepDeg) { return std::max(1, static_cast<int>(std::lround(deg / stepDeg))); }

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Tallies {
  AuditTally placed;
  AuditTally frozen;
};

/// A flight with all that its frames are measured against.
struct FlightAudit {
  const Model& model;
  const Scene& scene;
  const FlownFlight& flown;
  const std::vector<Layout>& frozenLayouts;
  std::size_t every;
};

/// The frames from number `first` of the measured ones up to `last`.
void measureFrames(const FlightAudit& audit, std::size_t first, std::size_t last, Tallies& tallies) {
  MaskPicture mask;
  DepthPicture depth;
  Odds odds(audit.model, audit.scene, audit.flown.layouts, audit.flown.flight.names);
  for (std::size_t k = first; k < last; ++k) {
    const std::size_t i = k * audit.every;
    const Layout& layout = audit.flown.layouts[i];
    const Layout& fixed = audit.frozenLayouts[i];
    depth.draw(audit.scene, layout.view);
    mask.read(depth.mask());
    const FrameName& name = audit.flown.flight.names[i];
    AuditedFrame frame{&audit.model, &audit.scene, &layout, &mask, &depth};
    // Between the pictures in which a movement rests lie others, of which nothing is said.
    if (audit.flown.flight.restEvery == 0) frame.odds = &odds;
    frame.number = i;
    measureFrame(frame, name, true, tallies.placed);
    frame.layout = &fixed;
    measureFrame(frame, name, false, tallies.frozen);
  }
}

class Auditor {
public:
  Auditor(const Model& model, const AuditPlan& plan, std::ostream& progress)
      : model_(model), plan_(plan), progress_(progress) {}

  AuditPart& begin(const std::string& title) {
    parts_.emplace_back().title = title;
    start_ = std::chrono::steady_clock::now();
    return parts_.back();
  }

  /// `restEvery`: see Flight; the frames held against their pixels are then to be those.
  void orbits(const Values& values, const std::string& prefix, int every, int restEvery = 0) {
    const Scene scene = model_.definition.build(values);
    for (const double elevationDeg : kElevationsDeg) {
      Flight flight = orbit(scene.bounds, elevationDeg, plan_.stepDeg, plan_.widthPx, plan_.heightPx);
      flight.restEvery = static_cast<std::size_t>(restEvery);
      for (FrameName& name : flight.names) name.flight = prefix + name.flight;
      audit(scene, values, std::move(flight), every);
    }
  }

  void flights(const Values& values, int every, int restEvery = 0) {
    const Scene scene = model_.definition.build(values);
    for (int i = 0; i < plan_.flights; ++i) {
      Flight flight = randomFlight(scene.bounds, static_cast<std::uint64_t>(i));
      flight.restEvery = static_cast<std::size_t>(restEvery);
      audit(scene, values, std::move(flight), every);
    }
  }

  /// At its ends, a parameter; at each of them, a choice.
  void extremes(const Values& values) {
    for (std::size_t i = 0; i < model_.parameters().size(); ++i) {
      const Parameter& parameter = model_.parameters()[i];
      std::vector<double> ends{parameter.min, parameter.max};
      if (parameter.type == ParameterType::kChoice) {
        ends.clear();
        for (std::size_t choice = 0; choice < parameter.choices.size(); ++choice)
          ends.push_back(static_cast<double>(choice));
      }
      for (const double end : ends) {
        if (end == values.at(i)) continue;
        Values changed = values;
        changed.set(i, end);
        orbits(changed, parameter.name + "=" + formatValue(parameter, end) + " ",
               plan_.every.value_or(kEveryAtExtremes));
      }
    }
  }

  std::vector<AuditPart> take() { return std::move(parts_); }

private:
  void audit(const Scene& scene, const Values& values, Flight flight, int every);

  const Model& model_;
  const AuditPlan& plan_;
  std::ostream& progress_;
  std::vector<AuditPart> parts_;
  std::chrono::steady_clock::time_point start_;
};

void Auditor::audit(const Scene& scene, const Values& values, Flight flight, int every) {
  AuditPart& part = parts_.back();
  const FlownFlight flown = fly(model_, scene, values, std::move(flight), part.placed);
  const std::vector<Layout> frozenLayouts = frozen(flown, scene);
  if (flown.flight.restEvery == 0) {
    Odds odds(model_, scene, flown.layouts, flown.flight.names);
    measureSteps(model_, flown.layouts, flown.flight.names, &odds, part.placed);
    measureSteps(model_, frozenLayouts, flown.flight.names, nullptr, part.frozen);
  }

  const FlightAudit work{model_, scene, flown, frozenLayouts, static_cast<std::size_t>(every)};
  const std::size_t measured = (flown.layouts.size() + work.every - 1) / work.every;
  const std::size_t threadCount =
      std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, std::max<std::size_t>(measured, 1));
  std::vector<Tallies> tallies(threadCount);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < threadCount; ++t) {
    threads.emplace_back(
        [&, t] { measureFrames(work, measured * t / threadCount, measured * (t + 1) / threadCount, tallies[t]); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Tallies& sum : tallies) {
    part.placed.add(sum.placed);
    part.frozen.add(sum.frozen);
  }
  part.flights.push_back({values, flown.flight});
  part.frames += flown.layouts.size();
  part.framesMeasured += measured;
  part.seconds = secondsSince(start_);
  progress_ << model_.definition.name << ", " << part.title << ": " << flown.flight.names.front().flight << " done, "
            << part.frames << " frames in " << formatFixed(part.seconds, 1) << " s\n"
            << std::flush;
}

}  // namespace

std::vector<AuditPart> auditModel(const Model& model, const Values& values, const AuditPlan& plan,
                                  std::ostream& progress) {
  Auditor auditor(model, plan, progress);
  auditor.begin("orbits");
  auditor.orbits(values, "", plan.every.value_or(1));
  if (plan.restDeg) {
    auditor.begin("rests");
    const int frames = framesIn(*plan.restDeg, plan.stepDeg);
    auditor.orbits(values, "", frames, frames);
  }
  if (plan.extremes) {
    auditor.begin("extremes");
    auditor.extremes(values);
  }
  if (plan.flights > 0) {
    auditor.begin("flights");
    auditor.flights(values, plan.every.value_or(kEveryInFlights));
    if (plan.restDeg) {
      auditor.begin("flight-rests");
      const int frames = framesIn(*plan.restDeg, 1);
      auditor.flights(values, frames, frames);
    }
  }
  return auditor.take();
}

}  // namespace dimline
