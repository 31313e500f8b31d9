#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compare/figures/figure.hpp"
#include "dem/equilibrium/stability.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"

/// The rest state of one clamped, loaded fiber, and the tables and figure that show it.
namespace fiberchain::compare {

/// Where a sphere stands, lengths over L: x along the straight fiber, y along the part of the load across
/// it, z across both; the angle is the one between the fiber's axis there and x, toward y.
struct Station {
  double x;
  double y;
  double z;
  double angle;  ///< [rad]
};

struct CantileverRest {
  std::vector<Station> spheres;            ///< from the clamp to the free end
  double residual;                         ///< largest moment out of balance over P L
  dem::Stability stability;                ///< in the scene's dimension
  std::optional<std::int64_t> iterations;  ///< Newton iterations, if solved
  std::optional<std::int64_t> steps;       ///< time steps, if marched
  double run_time;                         ///< [s]
};

/// Solves or marches the scene to rest.
/// @throws dem::InvalidInput, dem::NoConvergence, dem::Diverged
CantileverRest rest_of(const dem::CantileverScene& scene);

/// Largest strain that stretch or shear can have under the scene's load and weight (measure/strain.hpp).
double strain_bound(const dem::CantileverScene& scene);

/// One row: what was asked, the free end, the Elastica's and the departure from it (missing unless the load
/// is across the fiber), and what the run cost.
dem::Table cantilever_table(const dem::CantileverScene& scene, const CantileverRest& rest);

/// A row per sphere.
dem::Table shape_table(const CantileverRest& rest);

/// The spheres' centers beside the Elastica's curve (left out unless the load is across the fiber).
Figure shape_figure(const dem::CantileverScene& scene, const CantileverRest& rest);

}  // namespace fiberchain::compare
