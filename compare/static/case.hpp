#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/study/jobs.hpp"
#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/stability.hpp"
#include "dem/model/fiber.hpp"
#include "reference/tip_state.hpp"

// The static cantilever: where the chain's free end is, where the Elastica's is, and what the difference is
// made of.
namespace fiberchain::compare {

enum class StaticMethod { solve, march };

std::string_view name(StaticMethod method);

/// One cantilever. Everything is dimensionless: the result does not depend on E, d and density.
struct StaticCase {
  int aspect_ratio = 10;
  double poisson_ratio = 0.3;
  double load = 1;  ///< P L^2 / (E I)
  dem::BondModel bond = dem::BondModel::paper;
  StaticMethod method = StaticMethod::solve;
  dem::BondForm form = dem::BondForm::total;  ///< incremental: with march only
  int dimension = 2;                          ///< 2 planar, 3 spatial
};

/// Departure of the free end from the Elastica, relative to the Elastica's value, split into its causes. In
/// the order shear, stretch, discretization, history, time step, leftover motion each part is the change on
/// taking one more cause in, so their sum is the departure.
struct StaticBudget {
  reference::TipState shear;            ///< Reissner with GA - Elastica
  reference::TipState stretch;          ///< Reissner with GA and EA - Reissner with GA
  reference::TipState discretization;   ///< chain - Reissner with GA and EA
  reference::TipState history;          ///< incremental form at vanishing step - total form
  reference::TipState time_step;        ///< march at its step - at vanishing step, by halving it
  reference::TipState leftover_motion;  ///< march where it stopped - at rest, K^-1 times the forces left
};

struct StaticPoint {
  StaticCase asked;
  reference::TipState tip;  ///< of the chain, y / L, 1 - x / L, rad
  reference::TipState elastica;
  reference::TipState reissner;  ///< with GA and EA
  reference::TipState departure;
  StaticBudget budget;
  double distance;              ///< |dr| / L from the Elastica
  double distance_unstretched;  ///< the same after the stretch part is taken off
  double residual;              ///< moment out of balance over P L
  dem::Stability stability;     ///< of where it stopped
  long iterations;              ///< Newton iterations
  double steps;                 ///< time steps
  double run_time;              ///< of the chain [s]; a lane's share of its block when marching
  double strain;                ///< largest that stretch or shear can have (measure/strain.hpp)
  std::string status;           ///< "converged", with a warning, else the reason, and every number is NaN
};

struct StaticOptions {
  Jobs jobs = 1;
  dem::RelaxOptions march = {};
  std::function<void()> advance = [] {};                 ///< called after each case, from any thread
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// Whether there is an answer.
bool has_converged(const StaticPoint& point);

/// Every case, in the order given. A case that fails keeps its place with its status. Throws
/// dem::InvalidInput or reference::InvalidArgument for a case out of range, and InputError for the
/// incremental form with solve.
std::vector<StaticPoint> static_points(const std::vector<StaticCase>& cases,
                                       const StaticOptions& options = {});

/// The fiber that stands for a case: the nominal one of model.md, d = 2 mm, E = 2.6 MPa, 1000 kg/m^3.
dem::Fiber nominal_fiber(int aspect_ratio, double poisson_ratio, dem::BondModel bond);

}  // namespace fiberchain::compare
