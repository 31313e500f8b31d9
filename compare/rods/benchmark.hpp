#pragma once

#include <string_view>
#include <vector>

#include "dem/equilibrium/rod_path.hpp"
#include "dem/model/fiber.hpp"
#include "reference/rod_path.hpp"

// Benchmarks of rods in space: the chain by dem, the rod it stands for by reference, and the numbers that
// both give. Lengths are over L, forces over E I / L^2, moments over E I / L, forces per length over E I /
// L^3.
namespace fiberchain::compare {

/// A fiber of touching spheres under the benchmark's load.
struct RodSetting {
  dem::BondModel bond = dem::BondModel::paper;
  int bonds = 20;
  double poisson_ratio = 0.3;
  double load = 1;      ///< what it is of says the benchmark
  double spacing = 1;   ///< length of a bond over the diameter
  bool sheared = true;  ///< whether the reference of the paper's bond shears; otherwise it is Kirchhoff's
};

/// One problem by both; both give as many numbers.
struct RodBenchmark {
  std::string_view name;
  std::string_view load_is = "-";  ///< in words; "-": there is none
  double load = 1;                 ///< the usual one
  int multiple = 2;                ///< bonds are a multiple of it
  std::size_t shown = 0;           ///< the number that tables show
  double order_paper = 2;          ///< in 1 / bonds, expected
  double order_corrected = 4;
  std::vector<double> (*chain)(const RodSetting&);
  std::vector<double> (*rod)(const RodSetting&);
  int order_bonds = 40;  ///< from which to twice as many the order is taken: asymptotic, above rounding
};

/// All of them, in the order of the tables.
const std::vector<RodBenchmark>& rod_benchmarks();

/// @throws InputError naming those there are
const RodBenchmark& rod_benchmark(std::string_view name);

/// Loads that do not change what a rod is.
std::vector<RodBenchmark> loaded_rods();
/// Columns: loads at which they give way, and what comes behind.
std::vector<RodBenchmark> column_rods();
/// Frames of two members, rings that are twisted: loads at which they turn back or leave their plane.
std::vector<RodBenchmark> frame_rods();
std::vector<RodBenchmark> twisted_rings();

/// The fiber of a setting, an arc of this angle at rest, its length along the arc kept.
dem::Fiber rod_fiber(const RodSetting& setting, double arc = 0);

double rod_length(const dem::Fiber& fiber);  ///< along the arc [m]

/// The rod that a chain converges to: with E A, and with G A where the bond is the paper's.
reference::SpatialRod continuum_rod(const dem::Fiber& fiber, std::vector<reference::RodSegment> segments,
                                    bool sheared = true);

/// Units of force [N], moment [N m] and force per length [N/m] of a fiber.
struct RodUnits {
  double length, force, moment, line_load;
};
RodUnits rod_units(const dem::Fiber& fiber);

/// Turn of a rod's end at which, slender and straight, it leaves its plane where it is joined to a ring
/// (Michell 1889): 2 pi sqrt(3) E I / (G J) [rad].
double michell_turn(double poisson_ratio);

/// A path of Lee's frame: where its load is, over L = 240 of both members, and how large, in E I / L^2.
struct LeesPath {
  std::vector<double> down, load;
  std::vector<double> limits;  ///< loads at which it turns back
};
/// @param downward where the path ends, over L
LeesPath lees_path_of_chain(const RodSetting& setting, double downward);
LeesPath lees_path_of_rod(const RodSetting& setting, double downward);

/// One point of a path of the chain.
/// @throws dem::NoConvergence where there is no such point
const dem::SingularPoint& first_singular(const dem::RodPath& path, dem::SingularKind kind);

reference::SpaceVector vector_of(const dem::Vec<double, 3>& v);
std::vector<double> over(const dem::Vec<double, 3>& v, double length);
std::vector<double> over(const reference::SpaceVector& v, double length);

}  // namespace fiberchain::compare
