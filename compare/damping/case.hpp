#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/measure/peaks.hpp"
#include "compare/study/jobs.hpp"
#include "dem/model/fiber.hpp"
#include "dem/motion/physics.hpp"
#include "reference/chain_modes.hpp"
#include "reference/cvode.hpp"

// Damped vibration of the cantilever: the damping of the fiber that bonds with dashpots make, measured on the
// chain and held against linear modes, the damped Elastica and the closed form.
namespace fiberchain::compare {

/// One fiber let go. At a given load P L^2/(E I) xi_f does not depend on E, d and density; d and density are
/// those of the nominal fiber.
struct DampingCase {
  int aspect_ratio = 10;
  double poisson_ratio = 0.3;
  double load = 0.05;  ///< P L^2 / (E I) before the release
  dem::DashpotLaw dashpots = dem::DashpotLaw::bond_damping;
  double bond_damping = 1;  ///< xi_b; with DashpotLaw::retardation_time tau / t_b instead
  dem::BondModel bond = dem::BondModel::paper;
  dem::BondForm form = dem::BondForm::incremental;
  double youngs_modulus = 2.6e6;  ///< [Pa]
  PeakRange peaks{1, 10};         ///< of fiber_damping_paper; peak 0 is the point of release
};

/// Where a measured damping departs from the uniform beam's, in parts of the beam's. They add up to the
/// whole.
struct DampingBudget {
  double discretization;  ///< finite bonds, half a sphere more at the free end, spin of the spheres
  double shear;           ///< shear springs and dashpots
  double time_step;       ///< march at vanishing load - linear chain
  double amplitude;       ///< at the load asked for - at vanishing load
  double peak_fit;        ///< the peaks asked for - peaks without mode 2
};

struct DampingPoint {
  DampingCase asked;
  double damping;              ///< xi_f of the first mode alone (first_mode_damping.hpp)
  double half_width;           ///< 95 %, of its fit
  double damping_sine;         ///< second route: damped sine fitted to the same part of the motion
  double damping_paper;        ///< xi_f measured as the paper does
  double damping_modes;        ///< linear chain
  double damping_elastica;     ///< damped Elastica with the chain's mass layout, measured like `damping`
  double damping_closed_form;  ///< (beta_1^2 / sqrt(20)) xi_b / (r_f + 1/2)^2
  double damping_beam;         ///< the uniform beam's, r_f^2 in place of (r_f + 1/2)^2
  double damping_eq20;         ///< the paper's correlation; NaN unless the dashpots are the paper's
  double mode_2_estimate;  ///< what the higher modes do to the asked peaks of a linear beam, in parts of xi_f
  DampingBudget budget;
  double frequency;                  ///< measured [rad/s]
  double frequency_modes;            ///< linear chain, damped [rad/s]
  reference::CvodeStatistics cvode;  ///< of the damped Elastica's run
  double time_step;                  ///< [s]
  double steps;
  std::string status;  ///< "measured", with what is missing; else why nothing was
};

using DampingPoints = std::vector<DampingPoint>;

struct DampingOptions {
  Jobs jobs = 1;
  bool elastica = true;  ///< run the damped Elastica too
  std::function<void()> advance = [] {};
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// Every case in the order given; one that cannot be measured keeps its row with its status. Throws
/// dem::InvalidInput or InputError for a case out of range.
DampingPoints damping_points(const std::vector<DampingCase>& cases, const DampingOptions& options = {});

/// The chain of a case, and the same as the reference's linear chain.
dem::Fiber damped_fiber(const DampingCase& asked);
reference::LinearChain linear_chain_of(const DampingCase& asked);

/// The paper's Eq 20: 0.03709 exp(-0.1615 r_f) xi_b.
double equation_20(int aspect_ratio, double bond_damping);

}  // namespace fiberchain::compare
