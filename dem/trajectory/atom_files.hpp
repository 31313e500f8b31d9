#pragma once

#include <string>

#include "dem/trajectory/frame.hpp"

// Frames as text that programs for atoms read: a file is its frames one behind the other. Spheres are atoms,
// fibers molecules, numbered from 1; those that are not there are left out. SI units.
namespace fiberchain::dem {

/// LAMMPS's text dump (OVITO, VMD): id, mol, type, radius, place, velocity.
std::string lammps_frame(const TrajectoryFrame& frame);

/// Extended XYZ (OVITO, ASE): the box as Lattice and Origin, the same of each sphere.
std::string extended_xyz_frame(const TrajectoryFrame& frame);

}  // namespace fiberchain::dem
