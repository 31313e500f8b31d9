#include "compare/damping/table.hpp"

#include <algorithm>
#include <cmath>

#include "compare/damping/references.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/damped_elastica.hpp"

namespace fiberchain::compare {
namespace {

using dem::DashpotLaw;

dem::NamedRow row_of(const DampingPoint& p) {
  const DampingCase& c = p.asked;
  const dem::Fiber fiber = damped_fiber(c);
  const bool retarded = c.dashpots == DashpotLaw::retardation_time;
  return {{"aspect_ratio", std::int64_t{c.aspect_ratio}},
          {"poisson_ratio", c.poisson_ratio},
          {"load", c.load},
          {"bond", std::string(dem::name(c.bond))},
          {"form", std::string(dem::name(c.form))},
          {"dashpots", std::string(dem::name(c.dashpots))},
          {"bond_damping", retarded ? dem::Cell{} : dem::Cell{c.bond_damping}},
          {"retardation_ratio", retarded ? dem::Cell{c.bond_damping} : dem::Cell{}},
          {"force", dem::load_force(fiber, c.load)},
          {"youngs_modulus", c.youngs_modulus},
          {"shear_modulus", fiber.material.shear_modulus},
          {"peaks_first", std::int64_t{c.peaks.first}},
          {"peaks_last", std::int64_t{c.peaks.last}},
          {"fiber_damping", p.damping},
          {"fiber_damping_half_width", p.half_width},
          {"fiber_damping_sine", p.damping_sine},
          {"fiber_damping_paper", p.damping_paper},
          {"fiber_damping_modes", p.damping_modes},
          {"fiber_damping_elastica", p.damping_elastica},
          {"fiber_damping_closed_form", p.damping_closed_form},
          {"fiber_damping_beam", p.damping_beam},
          {"fiber_damping_eq20", p.damping_eq20},
          {"mode_2_estimate", p.mode_2_estimate},
          {"damping_discretization", p.budget.discretization},
          {"damping_shear", p.budget.shear},
          {"damping_time_step", p.budget.time_step},
          {"damping_amplitude", p.budget.amplitude},
          {"damping_peak_fit", p.budget.peak_fit},
          {"frequency", p.frequency},
          {"frequency_modes", p.frequency_modes},
          {"cvode_steps", std::int64_t{p.cvode.steps}},
          {"cvode_right_hand_sides", std::int64_t{p.cvode.right_hand_sides}},
          {"cvode_jacobians", std::int64_t{p.cvode.jacobians}},
          {"cvode_error_test_failures", std::int64_t{p.cvode.error_test_failures}},
          {"cvode_convergence_failures", std::int64_t{p.cvode.convergence_failures}},
          {"step_ratio", p.time_step / dem::bond_time_step(fiber)},
          {"steps", static_cast<std::int64_t>(p.steps)},
          {"status", p.status}};
}

/// Load P L^2 / (E I) of a force on the nominal fiber.
double load_of(double force, int aspect_ratio, double youngs_modulus = 2.6e6) {
  const dem::Fiber fiber = damped_fiber({.aspect_ratio = aspect_ratio, .youngs_modulus = youngs_modulus});
  return force / dem::load_force(fiber, 1.0);
}

/// The case with the dashpots set by `law` so that the first bending mode has the damping ratio wanted: xi_f
/// is proportional to the setting up to its square.
DampingCase with_first_mode(DampingCase asked, DashpotLaw law, double wanted) {
  asked.dashpots = law;
  for (int i = 0; i < 20; ++i) {
    asked.bond_damping *= wanted / reference::first_bending_mode(linear_chain_of(asked)).damping;
  }
  return asked;
}

}  // namespace

std::vector<DampingCase> cases(const DampingSweep& sweep) {
  std::vector<DampingCase> all;
  for (const auto bond : sweep.bond)
    for (const auto form : sweep.form)
      for (const auto law : sweep.dashpots)
        for (const double nu : sweep.poisson_ratio)
          for (const int aspect_ratio : sweep.aspect_ratio)
            for (const double damping : sweep.bond_damping)
              for (const double load : sweep.load)
                all.push_back({.aspect_ratio = aspect_ratio,
                               .poisson_ratio = nu,
                               .load = load,
                               .dashpots = law,
                               .bond_damping = damping,
                               .bond = bond,
                               .form = form,
                               .peaks = sweep.peaks});
  return all;
}

DampingFigureCases damping_figure_cases(PeakRange peaks) {
  DampingFigureCases figures;
  for (const int aspect_ratio : {8, 10}) {
    for (const double load : {largest_mode_release_load, load_of(0.02, aspect_ratio)}) {
      for (const double damping : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0}) {
        // at the large load too light a damping keeps mode 2 for hundreds of periods
        if (load > largest_mode_release_load && damping < 0.1) continue;
        figures.bond_damping.push_back(
            {.aspect_ratio = aspect_ratio, .load = load, .bond_damping = damping, .peaks = peaks});
      }
    }
  }
  for (const double force : {0.00025, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.008, 0.01, 0.0125,
                             0.015, 0.0175, 0.02, 0.025, 0.03}) {
    figures.load.push_back({.load = load_of(force, 10), .peaks = peaks});
  }
  for (const double shear_modulus :
       {0.05e6, 0.07e6, 0.1e6, 0.15e6, 0.2e6, 0.3e6, 0.5e6, 0.7e6, 1e6, 1.5e6, 2e6}) {
    const double youngs_modulus = 2.6 * shear_modulus;
    figures.modulus.push_back(
        {.load = load_of(0.002, 10, youngs_modulus), .youngs_modulus = youngs_modulus, .peaks = peaks});
  }
  for (const int aspect_ratio : {5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60}) {
    figures.aspect_ratio.push_back(
        {.aspect_ratio = aspect_ratio, .load = largest_mode_release_load, .peaks = peaks});
  }
  return figures;
}

dem::Table damping_table(const std::vector<DampingPoint>& points) {
  return tabulate(points, [](const DampingPoint& point) { return row_of(point); });
}

dem::Table dashpot_table(int aspect_ratio, double poisson_ratio) {
  using reference::ChainMotion;
  dem::Table table({"dashpots", "bond_damping", "retardation_ratio", "motion", "mode", "mode_damping",
                    "stable_step_ratio"});
  const DampingCase paper{.aspect_ratio = aspect_ratio, .poisson_ratio = poisson_ratio};
  const double wanted = reference::first_bending_mode(linear_chain_of(paper)).damping;
  for (const DashpotLaw law :
       {DashpotLaw::bond_damping, DashpotLaw::retardation_time, DashpotLaw::bending_only}) {
    const DampingCase asked = with_first_mode(paper, law, wanted);
    const dem::Fiber fiber = damped_fiber(asked);
    const bool retarded = law == DashpotLaw::retardation_time;
    for (const auto& [motion, label] :
         {std::pair{ChainMotion::bending, "bending"}, std::pair{ChainMotion::axial, "axial"},
          std::pair{ChainMotion::twist, "twist"}}) {
      const auto modes =
          reference::chain_modes(linear_chain_of(asked), motion, reference::ChainEnds::clamped_free);
      for (std::size_t mode = 0; mode < std::min<std::size_t>(3, modes.size()); ++mode) {
        table.append({{"dashpots", std::string(dem::name(law))},
                      {"bond_damping", retarded ? dem::Cell{} : dem::Cell{asked.bond_damping}},
                      {"retardation_ratio", retarded ? dem::Cell{asked.bond_damping} : dem::Cell{}},
                      {"motion", std::string(label)},
                      {"mode", static_cast<std::int64_t>(mode + 1)},
                      {"mode_damping", modes[mode].damping},
                      {"stable_step_ratio", dem::stable_time_step(fiber) / dem::bond_time_step(fiber)}});
      }
    }
  }
  return table;
}

dem::Table ring_down_table(const DampingCase& asked, double periods) {
  const dem::Fiber fiber = damped_fiber(asked);
  const reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(asked));
  dem::ReleaseOptions options;
  options.form = asked.form;
  options.samples_per_period = 60;
  const auto record = dem::ring_down<2>({static_release(fiber, mode, asked.load, periods)}, options)[0];
  const TipHistory chain = tip_history(record, dem::fiber_length(fiber));
  const double unit = reference::chain_time_unit(asked.aspect_ratio) * dem::bond_time_step(fiber);
  const double period = 2 * std::acos(-1.0) / mode.eigenvalue.imag();
  const TipHistory elastica = elastica_at(asked, chain.time, unit);
  dem::Table table({"time", "chain_y", "elastica_y"});
  for (std::size_t i = 0; i < chain.time.size(); ++i) {
    table.append({{"time", chain.time[i] / period},
                  {"chain_y", chain.y[i] / chain.y[0]},
                  {"elastica_y", elastica.y[i] / elastica.y[0]}});
  }
  return table;
}

}  // namespace fiberchain::compare
