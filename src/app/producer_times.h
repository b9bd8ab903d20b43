#pragma once

#include <algorithm>

namespace dimline {

/// What is known of the two producers' times for a model on this machine, the main thread's time for an answer each: who does better where nobody has said who shall measure.
///
/// The CPU answers within the frame, the GPU some frames later; so as long as the CPU takes no more than its budget of a frame, it is the better one whatever the GPU could do.
class ProducerTimes {
public:
  explicit ProducerTimes(double cpuBudgetMs) : cpuBudgetMs_(cpuBudgetMs) {}

  [[nodiscard]] bool gpuIsBetter() const { return cpuSamples_ >= kCpuSamples && cpuMs_ > cpuBudgetMs_ && gpuMs_ < cpuMs_; }

  void cpuTook(double ms) {
    cpuMs_ = cpuSamples_ == 0 ? ms : std::min(cpuMs_, ms);
    ++cpuSamples_;
  }
  void gpuTook(double ms) { gpuMs_ = gpuSamples_++ < kGpuWarmUp ? 0.0 : ms; }

  /// Another model.
  void forget() {
    cpuSamples_ = 0;
    gpuMs_ = 0;
  }
  /// Another context, which will have to be warmed up too.
  void forgetGpu() {
    gpuMs_ = 0;
    gpuSamples_ = 0;
  }

private:
  /// The first measurement of a scene pays for memory, so that the best of a few counts.
  static constexpr int kCpuSamples = 3;
  /// The first answer of a context pays for its shaders, so that it does not count.
  static constexpr int kGpuWarmUp = 1;

  double cpuBudgetMs_;
  double cpuMs_ = 0, gpuMs_ = 0;
  int cpuSamples_ = 0, gpuSamples_ = 0;
};

}  // namespace dimline
