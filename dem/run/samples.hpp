#pragma once

#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"
#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/wall_surface.hpp"

// A packing at one moment as the log and the trajectory record it.
namespace fiberchain::dem {

struct RunMoment {
  std::int64_t step;
  double time;  ///< [s]
  std::int64_t contacts;
  double height;        ///< below which 95 % of the sphere centers lie, over the room's floor [m]
  double bending_mean;  ///< over all bonds [rad]
  double overlap_mean;  ///< of the contacts, over the smaller radius; 0 where nothing touches
  double overlap_peak;  ///< the deepest since the start, likewise
  EnergyBalance energy;
  std::int64_t pieces = 0;  ///< of the fibers that are in
};

/// Against gravity; along z without.
Vec<double, 3> upward(const PackingScene& scene);

RunMoment measure(const Assembly& assembly, const PackingScene& scene);
/// The same with memory that is kept from one moment to the next.
RunMoment measure(const Assembly& assembly, const PackingScene& scene, std::vector<double>& room);

/// Columns of the stored energies and, where energy is accounted, of all mechanisms and the total.
std::vector<std::string> energy_columns(bool accounted);
NamedRow energy_cells(const EnergyBalance& energy, bool accounted);

/// Whether fibers have bonds that break.
bool bonds_break(const PackingScene& scene);

/// An empty log.
Table run_log_table(const PackingScene& scene);

/// A line of it.
Table run_log_row(const RunMoment& moment, const PackingScene& scene, double step_rate, double time_left);

/// Of all walls, cut to the scene's box.
std::vector<WallSurface> wall_surfaces(const PackingScene& scene);
/// Whether none of them moves, comes or goes from one moment to another; false where one is not a number.
bool walls_stay(const PackingScene& scene, double from, double to);

/// All spheres, contacts where the scene asks for them, and where walls are. Spheres of batches to come are
/// reserved as absent, those that found no room are missing. `inserted` has the fibers of each group that
/// came after the start.
TrajectoryFrame frame_of(const Assembly& assembly, const PackingScene& scene,
                         const std::vector<std::int64_t>& inserted = {});
/// The same into a frame before, whose memory is kept.
void fill_frame(const Assembly& assembly, const PackingScene& scene,
                const std::vector<std::int64_t>& inserted, TrajectoryFrame& frame);

}  // namespace fiberchain::dem
