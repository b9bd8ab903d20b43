#include "cli/bench_measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/audit_flight.h"
#include "cli/bench_straightforward.h"
#include "cli/field_measurer.h"
#include "placement/placer.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kElevationDeg = 30.0;
constexpr std::size_t kStraightforwardFrames = 12;  // no multiple of 5
constexpr double kStraightforwardBudgetMs = 4000.0;
constexpr double kRepeatBudgetMs = 1500.0;
constexpr double kRepeatMsPerFrame = 12.5;  // who asks for few frames wants it short
constexpr int kPreprocessRepeats = 15;

template <typename Work>
double timeMs(Work work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One orbit's frames: fields, visibility and lines, one after the other as in a page.
Status timeFrames(const Model& model, const Scene& scene, const std::vector<View>& views, FieldMeasurer* gpu,
                  BenchTimes& times) {
  const Values values(model.parameters());
  Placer placer;
  CpuFields producer;
  CpuVisibility visible;
  placer.setScene(model, scene);
  producer.setScene(scene);
  DistanceFields fields;
  DistanceFields gpuFields;
  ScopeVisibility visibility;
  Layout layout;
  std::vector<double> placerMs, cpuMs, gpuMs, visibilityMs;
  for (const View& view : views) {
    cpuMs.push_back(timeMs([&] { producer.produce(view, fields); }));
    visibilityMs.push_back(timeMs([&] { visible.measure(scene, view, visibility); }));
    placerMs.push_back(timeMs([&] { placer.place(view, fields, values, layout, &visibility); }));
    if (gpu == nullptr) continue;
    Status status = okStatus();
    gpuMs.push_back(timeMs([&] { status = gpu->measure(view, gpuFields); }));
    if (!status) return status;
  }
  times.placer = median(std::move(placerMs));
  times.cpuFields = median(std::move(cpuMs));
  times.gpuFields = median(std::move(gpuMs));
  times.visibility = median(std::move(visibilityMs));
  return okStatus();
}

void timeStraightforward(const Model& model, const Scene& scene, const std::vector<View>& views, BenchTimes& times) {
  Straightforward straightforward(model, scene);
  std::vector<double> samples;
  double spentMs = 0;
  const std::size_t most = std::min(kStraightforwardFrames, views.size());
  for (std::size_t i = 0; i < most && spentMs < kStraightforwardBudgetMs; ++i) {
    // So that a few frames stand for the whole way round, far ones come one after the other.
    const std::size_t frame = (i * 5 % most) * views.size() / most;
    samples.push_back(timeMs([&] { straightforward.place(views[frame]); }));
    spentMs += samples.back();
  }
  times.straightforward = median(std::move(samples));
}

void timeChanges(const Model& model, const Scene& scene, int frames, BenchTimes& times) {
  std::vector<double> preprocessMs;
  Placer placer;
  for (int i = 0; i < kPreprocessRepeats; ++i) preprocessMs.push_back(timeMs([&] { placer.setScene(model, scene); }));
  times.preprocess = median(std::move(preprocessMs));

  // Every parameter once a little off its default, over and over while there is time.
  std::vector<std::vector<double>> rebuildMs(model.parameters().size());
  CpuFields producer;
  double spentMs = 0;
  const double budgetMs = std::min(kRepeatBudgetMs, frames * kRepeatMsPerFrame);
  for (double share = 0.1; share < 0.4 && spentMs < budgetMs; share += 0.1) {
    for (std::size_t i = 0; i < model.parameters().size(); ++i) {
      const Parameter& parameter = model.parameters()[i];
      Values values(model.parameters());
      values.set(i, clampValue(parameter, parameter.defaultValue + share * (parameter.max - parameter.defaultValue)));
      rebuildMs[i].push_back(timeMs([&] {
        const Scene changed = model.definition.build(values);
        placer.setScene(model, changed);
        producer.setScene(changed);
      }));
      spentMs += rebuildMs[i].back();
    }
  }
  for (std::vector<double>& of : rebuildMs) times.rebuild = std::max(times.rebuild, median(std::move(of)));
}

}  // namespace

std::optional<double> median(std::vector<double> samples) {
  if (samples.empty()) return std::nullopt;
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  return *middle;
}

std::optional<Steady> steady(const BenchResult& result, std::optional<double> BenchTimes::* what) {
  const auto& first = result.runs[0].*what;
  const auto& second = result.runs[1].*what;
  if (!first || !second) return std::nullopt;
  const double mean = 0.5 * (*first + *second);
  return Steady{mean, mean > 0 ? std::abs(*first - mean) / mean : 0.0};
}

std::vector<View> benchViews(const Bounds& bounds, const BenchPlan& plan) {
  std::vector<View> views;
  for (const Camera& camera : orbit(bounds, kElevationDeg, 360.0 / plan.frames, plan.sidePx, plan.sidePx).cameras) {
    views.emplace_back(camera, plan.sidePx, plan.sidePx, bounds);
  }
  return views;
}

Result<BenchResult> benchModel(const Model& model, const BenchPlan& plan) {
  const Scene scene = model.definition.build(Values(model.parameters()));
  BenchResult result{.model = model.definition.name,
                     .parameters = model.parameters().size(),
                     .statistics = statisticsOf(model, scene),
                     .runs = {}};
  std::unique_ptr<FieldMeasurer> gpu;
  if (plan.gpu) {
    auto made = FieldMeasurer::onGpu(scene);
    if (!made) return made.error();
    gpu = std::move(made).value();
  }
  const std::vector<View> views = benchViews(scene.bounds, plan);
  for (BenchTimes& times : result.runs) {
    if (Status status = timeFrames(model, scene, views, gpu.get(), times); !status) return status.error();
    if (plan.straightforward) timeStraightforward(model, scene, views, times);
    if (plan.changes) timeChanges(model, scene, plan.frames, times);
  }
  return result;
}

}  // namespace dimline
