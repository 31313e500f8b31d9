#pragma once

namespace fiberchain::dem {

/// What the threads of this program together have had of the processors up to now [s].
double processor_time();

/// Adds what is had during its life to a sum.
class ProcessorTimer {
 public:
  explicit ProcessorTimer(double& sum) : sum_(sum), begin_(processor_time()) {}
  ~ProcessorTimer() { sum_ += processor_time() - begin_; }
  ProcessorTimer(const ProcessorTimer&) = delete;
  ProcessorTimer& operator=(const ProcessorTimer&) = delete;

 private:
  double& sum_;
  double begin_;
};

}  // namespace fiberchain::dem
