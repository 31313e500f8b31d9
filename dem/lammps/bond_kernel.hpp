#pragma once

#include <cstdint>

#include "dem/bond/laws/laws.hpp"
#include "dem/simd/instruction_set.hpp"

// Bonds one by one in lanes, wherever their spheres lie in memory: LAMMPS parts a fiber over its ranks.
namespace fiberchain::dem::mpi {

/// Numbers of a bond's history in memory: the strain of the incremental form.
inline constexpr int bond_history_size = 6;

/// Bonds of fibers of one kind. Orientations as of SphereStorage, else three numbers a sphere as LAMMPS has
/// them; lanes read one number beyond those of the last slot.
struct BondView {
  const std::int32_t *first, *second;  ///< slots of their spheres, padded to whole vectors by the last bond
  std::int32_t count;                  ///< without pads
  const double *position, *velocity, *spin, *orientation;
  double* history;  ///< a row of bond_history_size a slot: of the bond behind this sphere
  double *force, *torque;
  const BondParameters<double>* parameters;
  double inverse_length;  ///< 1 / l_0 [1/m]
  double step;            ///< that led here, 0 before the first [s]
};

struct BondKernel {
  int width;
  /// Adds the loads of all bonds to their spheres; histories move on.
  void (*act)(const BondView&);
  /// Orientations of the slots [begin, end) go on by a step [s] of their spins.
  void (*turn)(double* orientation, const double* spin, std::int32_t begin, std::int32_t end, double step);
};

/// Of one instruction set: form by form, without dashpots and with.
template <InstructionSet set>
struct BondKernels {
  static const BondKernel* table();
};

const BondKernel& bond_kernel(BondForm form, bool damped, InstructionSet set);

}  // namespace fiberchain::dem::mpi
