#pragma once

#include <array>

#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"

/// One cantilever let go: its run, and the tables and figure that show it.
namespace fiberchain::compare {

struct ReleaseRun {
  dem::Integrator integrator;
  std::string reason;  ///< why this integrator, if it was chosen here
  dem::Work work;
  double time_step;                         ///< mean [s]
  std::string step_note;                    ///< empty, or why it is not the step asked for
  double period;                            ///< first mode of the straight chain, damped [s]
  double damping_modes;                     ///< its damping ratio
  double damping;                           ///< xi_f of the first mode alone (measure/first_mode_damping.hpp)
  std::string damping_note;                 ///< empty, or why it is NaN
  double frequency;                         ///< of the same, else from crossings of zero [rad/s]
  double run_time;                          ///< [s]
  std::vector<double> time, y, z, energy;   ///< samples [s], over L, [J]
  std::string failure;                      ///< empty, else where and why the run stopped
  std::vector<std::array<double, 3>> last;  ///< places of the spheres in the last good state, over L
};

/// How a release will be integrated.
struct ReleasePlan {
  dem::Integrator integrator;
  std::string reason;  ///< why this integrator, if it was chosen here
  double time_step;    ///< [s]
  double steps;
};

/// Finds the loaded equilibrium, but marches nothing. Throws as run_release().
ReleasePlan plan_release(const dem::ReleaseScene& scene);

/// Throws dem::InvalidInput, dem::NoConvergence, and InputError if the first mode is overdamped.
ReleaseRun run_release(const dem::ReleaseScene& scene);

/// One row: what was asked, the integrator, damping and what it took.
dem::Table release_table(const dem::ReleaseScene& scene, const ReleaseRun& run);

/// A row a sample.
dem::Table release_history_table(const ReleaseRun& run);

/// The last good state, a row a sphere: where the run ended, or blew up right after.
dem::Table release_last_table(const ReleaseRun& run);

Figure release_figure(const dem::ReleaseScene& scene, const ReleaseRun& run);

}  // namespace fiberchain::compare
