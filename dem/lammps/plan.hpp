#pragma once

#include <cstdint>
#include <vector>

#include "dem/bond/laws/laws.hpp"
#include "dem/contact/contact_body.hpp"
#include "dem/contact/wall_record.hpp"
#include "dem/model/domain.hpp"
#include "dem/motion/moving_sphere.hpp"

// What every rank knows of a packing beside its spheres.
namespace fiberchain::dem::mpi {

/// A group of fibers as numbers, so that one rank can tell it to all.
struct GroupNumbers {
  MarchParameters<double, 3> march;
  double weight[3];           ///< of a sphere that is not an end [N]
  double radius, mass;        ///< [m], of a sphere that is not an end [kg]
  std::int64_t first;         ///< number of its first sphere
  std::int64_t fibers;        ///< how many
  std::int32_t spheres;       ///< of each
  std::int32_t contact_kind;  ///< among bodies in contact
  bool damped;                ///< bonds have dashpots
};

struct Plan {
  Domain domain;  ///< walls that are driven as they stand
  BondForm form = BondForm::total;
  double step = 0, time_shift = 0;   ///< time = steps step + time_shift [s]
  std::vector<GroupNumbers> groups;  ///< by rising first sphere
  std::int32_t contact_kinds = 0;
  bool rolls = false;                                    ///< contacts have rolling friction
  bool oriented = true;                                  ///< orientations are followed
  std::vector<double> pair_parameters, wall_parameters;  ///< of the contact law, as Contacts has them
  double law_reach = 0, skin = 0;  ///< gap up to which contacts act, of neighbors beyond [m]

  double time(std::int64_t steps) const { return static_cast<double>(steps) * step + time_shift; }
  std::int64_t spheres() const {
    return groups.empty() ? 0 : groups.back().first + groups.back().fibers * groups.back().spheres;
  }
  double largest_radius() const;
  double smallest_radius() const;
};

/// Whether two spheres of these numbers are joined by a bond.
bool are_bonded(const GroupNumbers& group, std::int64_t lower, std::int64_t higher);

}  // namespace fiberchain::dem::mpi
