#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/two_spheres.hpp"

// Impacts of one sphere: the eight tests of Chung & Ooi, Granular Matter 13 (2011) 643-656. Their parameters
// are taken from the input files of other codes, which data/published/README.md names.
namespace fiberchain::compare {

/// A solid sphere.
struct ImpactBody {
  double radius, youngs_modulus, poisson_ratio, density;  ///< [m], [Pa], [-], [kg/m^3]
};

/// In the plane: x from the first to the second, y across, spin from x to y.
struct ImpactCase {
  int test;  ///< 1 to 8
  std::string material;
  ImpactBody first;
  std::optional<ImpactBody> second;  ///< none: a rigid plane
  double restitution, friction;
  reference::PlanarMotion first_motion, second_motion;
};

/// Angles of incidence 5, 10 ... 85 degrees.
std::vector<double> impact_angles();
/// Five of them, for a quick look.
std::vector<double> few_impact_angles();

/// The cases of one test. Tests 4 to 8 have one for each angle [degrees], of which the tangent is slip over
/// normal speed; 1 to 3 are head on. Throws InputError for a test that there is not.
std::vector<ImpactCase> impact_cases(int test, const std::vector<double>& angles);

inline constexpr int impact_tests = 8;

reference::ElasticBody elastic_body(const ImpactBody& body);
/// The second body; a rigid plane where there is none.
reference::ElasticBody second_body(const ImpactCase& impact);

double closing_speed(const ImpactCase& impact);  ///< [m/s] > 0
/// Velocity of the second's surface over the first's along it, for motions before or after [m/s].
double slip(const ImpactCase& impact, const reference::PlanarMotion& first,
            const reference::PlanarMotion& second);

}  // namespace fiberchain::compare
