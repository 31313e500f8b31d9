#pragma once

#include "compare/results/table.hpp"
#include "dem/assembly/assembly.hpp"
#include "dem/io/frame.hpp"
#include "dem/io/packing_scene.hpp"

// A packing at one moment, as a run writes it.
namespace fiberchain::compare {

struct RunMoment {
  std::int64_t step;
  double time;  ///< [s]
  std::int64_t contacts;
  double height;        ///< below which 95 % of the sphere centers lie, over the room's floor [m]
  double bending_mean;  ///< over all bonds [rad]
  dem::EnergyBalance energy;
};

/// Against gravity; along z without.
dem::Vec<double, 3> upward(const dem::io::PackingScene& scene);

RunMoment measure(const dem::Assembly& assembly, const dem::io::PackingScene& scene);

/// Columns of stored energies and, where `booked`, of what each mechanism took.
std::vector<std::string> energy_columns(bool booked);
NamedRow energy_cells(const dem::EnergyBalance& energy, bool booked);

/// An empty log.
Table run_log_table(const dem::io::PackingScene& scene);

/// A line of it.
Table run_log_row(const RunMoment& moment, const dem::io::PackingScene& scene, double step_rate,
                  double time_left);

/// All spheres, with room for those that come later.
dem::io::Frame frame_of(const dem::Assembly& assembly, const dem::io::PackingScene& scene);

}  // namespace fiberchain::compare
