#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem/chain/chain_state.hpp"
#include "dem/model/fluid.hpp"
#include "dem/model/interrupted.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/physics.hpp"
#include "dem/simd/instruction_set.hpp"

// Fibers in a flow, followed in time.
namespace fiberchain::dem {

/// How a fiber in a flow is followed.
enum class FlowMethod {
  inertialess,    ///< velocities from the balance of forces, implicit in the bonds (CVODE); total form
  cvode,          ///< with inertia, implicit (CVODE); free draining, total form
  leapfrog,       ///< with inertia, explicit in the bonds, drag solved within the step; free draining
  leapfrog_stiff  ///< the same with springs and dashpots solved within the step, too
};

constexpr std::string_view name(FlowMethod method) {
  switch (method) {
    case FlowMethod::cvode:
      return "cvode";
    case FlowMethod::leapfrog:
      return "leapfrog";
    case FlowMethod::leapfrog_stiff:
      return "leapfrog-stiff";
    default:
      return "inertialess";
  }
}

/// Whether chains march in lanes.
constexpr bool is_leapfrog(FlowMethod method) {
  return method == FlowMethod::leapfrog || method == FlowMethod::leapfrog_stiff;
}

/// A free fiber in a fluid and where it starts. It starts with the velocities of the undisturbed flow.
template <int Dim>
struct FlowCase {
  Chain<Dim> chain;
  Poses<Dim> start;  ///< may be strained
  Fluid fluid;
  Boundary<Dim> boundary{};  ///< dead loads; clamped spheres with free draining only
};

/// Throws InvalidInput for a fiber, fluid or start that makes no sense, or rolling friction, which is not
/// built in a fluid.
template <int Dim>
void check(const FlowCase<Dim>& flow);

/// The start with the velocities of the undisturbed flow; clamped spheres rest.
template <int Dim>
ChainState<Dim> carried_state(const FlowCase<Dim>& flow);

struct FlowOptions {
  FlowMethod method = FlowMethod::inertialess;
  double tolerance = 1e-8;          ///< inertialess, cvode: local error relative to L and to 1 rad
  BondForm form = BondForm::total;  ///< leapfrog only; the others have the total form
  std::optional<double> step_ratio = std::nullopt;  ///< leapfrogs: largest dt / t_b; left out: 0.8 of the
                                                    ///< stable step, or of the stiff one's limits
  bool allow_unstable = false;                      ///< leapfrog: march even beyond the stable step
  InstructionSet instruction_set = best_instruction_set();
  StopRequest asked_to_stop = {};  ///< asked at every time of interest
};

/// The state at a time of interest; velocities are those of that moment.
template <int Dim>
using FlowSample = std::function<void(double time, const ChainState<Dim>& state)>;

struct FlowRecord {
  Work work;
  double time_step;     ///< leapfrog; of the others the mean [s]
  double reached;       ///< [s]
  std::string failure;  ///< empty; else time, step, sphere and likely cause, and `reached` is before it
};

/// Integrates the motion of one fiber and hands its state out at the times, which must rise from 0 or later.
/// The leapfrog takes whole steps to each of them. Throws InvalidInput for a case that makes no sense or is
/// not built, Interrupted when asked to stop.
template <int Dim>
FlowRecord integrate_in_flow(const FlowCase<Dim>& flow, const std::vector<double>& times,
                             const FlowOptions& options, const FlowSample<Dim>& sample);

}  // namespace fiberchain::dem
