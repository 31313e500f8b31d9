#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>
#include <utility>

#include "dem/model/interrupted.hpp"

// Long calls: the interpreter goes on meanwhile, and Ctrl-C stops them.
namespace fiberchain::python {

/// Looks for signals of Python now and then, from the thread it was made in.
class SignalWatch {
 public:
  dem::StopRequest request() {
    return [this] { return asked(); };
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Asking costs the interpreter's lock: ten times a second at most.
  bool asked() {
    constexpr std::chrono::milliseconds between{100};
    if (std::this_thread::get_id() != owner_) return false;
    const Clock::time_point now = Clock::now();
    if (now - last_ < between) return false;
    last_ = now;
    const pybind11::gil_scoped_acquire held;
    return PyErr_CheckSignals() != 0;
  }

  std::thread::id owner_ = std::this_thread::get_id();
  Clock::time_point last_ = Clock::now();
};

/// What `work(asked_to_stop)` returns, without the interpreter's lock.
/// @throws the exception of a signal's handler, KeyboardInterrupt, where that stopped it
template <class Work>
auto released(const Work& work) {
  SignalWatch watch;
  try {
    const pybind11::gil_scoped_release release;
    return work(watch.request());
  } catch (const dem::Interrupted&) {
    if (PyErr_Occurred() != nullptr) throw pybind11::error_already_set();
    throw;
  }
}

}  // namespace fiberchain::python
