#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dem/assembly/assembly.hpp"

// How a packing goes, and what is read from that: the stages of Fig 11, the parts of Fig 12.
namespace fiberchain::compare {

/// A packing at one moment.
struct PackingSample {
  double time;             ///< [s]
  double bending_angle;    ///< mean over all bonds, Fig 12 [rad]
  double largest_bending;  ///< [rad]
  double mean_height;      ///< of the sphere centers over the floor [m]
  double height;           ///< below which 95 % of the centers lie [m]
  double vertical_speed;   ///< mean, up is positive [m/s]
  double speed;            ///< root of the mean square [m/s]
  double solid_fraction;   ///< between the floor and `height`
  double coordination;     ///< contacts of a sphere with spheres that it is not bonded to
  double order;            ///< of the bonds along the vertical: -1/2 all level, 0 isotropic, 1 all upright
  dem::EnergyBalance energy;
};

using PackingHistory = std::vector<PackingSample>;

/// The stages of Fig 11.
enum class PackingStage { reaching, densest, expanded, at_rest };
inline constexpr PackingStage kPackingStages[] = {PackingStage::reaching, PackingStage::densest,
                                                  PackingStage::expanded, PackingStage::at_rest};

std::string_view name(PackingStage stage);

/// Samples of the stages by these rules, each looked for after the one before:
/// - reaching the bottom: the mean vertical velocity is lowest, so that from here on the floor carries more
/// than the weight;
/// - densest: the first lowest mean height, where the mean vertical velocity turns upward;
/// - expanded: the first highest mean height after that;
/// - at rest: the last sample.
/// A stage that does not come is left out.
std::optional<std::size_t> find_stage(std::span<const PackingSample> history, PackingStage stage);

/// The parts of Fig 12.
struct BendingParts {
  double peak, peak_time;      ///< largest mean bending angle [rad], [s]
  double trough, trough_time;  ///< smallest after it
  double plateau;              ///< mean over the last fifth of the time
  double unrest;  ///< half the distance of the largest from the smallest in that fifth, over the plateau
};

/// Throws InputError for fewer than 10 samples.
BendingParts bending_parts(std::span<const PackingSample> history);

/// Of a quantity over several seeds.
struct Spread {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation of one, by count - 1; NaN for a single one
  double least = 0, most = 0;
};

/// Throws InputError for no values.
Spread spread_of(std::span<const double> values);

/// Two-sided 95 % half width of the mean, by Student's t; NaN for a single value.
double half_width(const Spread& spread);

}  // namespace fiberchain::compare
