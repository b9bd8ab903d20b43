#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/model_statistics.h"
#include "math/camera.h"
#include "model/model.h"

namespace dimline {

/// How long one frame, or one change of the model, takes (ms): medians of one run. Nothing where it was not measured.
struct BenchTimes {
  std::optional<double> preprocess;  ///< the placer's part of a change: clusters, object planes, order
  std::optional<double> placer;
  std::optional<double> cpuFields;
  std::optional<double> gpuFields;   ///< asked for and waited for, nothing else in between
  std::optional<double> visibility;  ///< of all scopes, on the CPU
  /// After a change of the parameter that takes longest: the model built anew, and all that places and measures prepared.
  std::optional<double> rebuild;
  std::optional<double> straightforward;  ///< see Straightforward
};

/// One model's times, in two runs: what differs between them is the machine's noise.
struct BenchResult {
  std::string model;
  std::size_t parameters = 0;
  ModelStatistics statistics;
  std::array<BenchTimes, 2> runs;
};

struct BenchPlan {
  int frames = 360;             ///< of one orbit at an elevation of 30 degrees
  double sidePx = 1000;         ///< of the viewport, a square
  bool gpu = false;             ///< also the GPU's fields
  bool straightforward = true;  ///< on a few of the frames, as it takes long
  bool changes = true;          ///< preprocess and rebuild
};

/// The views of one orbit, around a model as large as that.
std::vector<View> benchViews(const Bounds& bounds, const BenchPlan& plan);

/// Measures a model at its default values. An error when the GPU is asked for and there is none.
Result<BenchResult> benchModel(const Model& model, const BenchPlan& plan);

/// The middle one, of an even number the greater; nothing of nothing.
std::optional<double> median(std::vector<double> samples);

/// The mean of the two runs, and how far each is from it, as a share.
struct Steady {
  double ms = 0;
  double noise = 0;
};
std::optional<Steady> steady(const BenchResult& result, std::optional<double> BenchTimes::* what);

}  // namespace dimline
