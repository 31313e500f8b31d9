#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/flow/orbit.hpp"
#include "dem/record/table.hpp"

// What is asked of fibers in a flow, question by question: cases, table, figures.
namespace fiberchain::compare {

struct FlowStudy {
  dem::Table table;
  std::vector<std::pair<std::string, Figure>> figures = {};          ///< by the name of their files
  std::vector<std::pair<std::string, dem::Table>> more_tables = {};  ///< likewise
  int failed = 0;                                                    ///< rows that could not be measured
};

/// Fig 5: chains of these numbers of spheres, once for each kind of hydrodynamics.
struct PeriodSweep {
  std::vector<int> spheres{2, 3, 4, 5, 6, 8, 11, 15, 20, 30, 50, 75, 101};
  std::vector<int> interacting{2, 3, 5, 8, 11, 20, 30, 50};  ///< the same for interactions
  std::vector<int> stresslets{2, 3, 5, 8, 11, 20, 30};       ///< and stresslets
};

/// Stiff enough that the chain is rigid, half an orbit in the plane.
std::vector<OrbitCase> period_cases(const PeriodSweep& sweep);

/// Orbit period against aspect ratio: chains, their rigid limit, correlations.
FlowStudy period_study(const PeriodSweep& sweep, const OrbitOptions& options);

/// Orbit constants in the plane and three out of it, as C/(1 + C).
inline const std::vector<double> kOrbitConstants{0.2, 0.5, 0.8, 1};

/// A stiff chain, in space, followed for that many orbits: distance from Jeffery's closed form and drift of
/// the orbit constant.
struct JefferyRun {
  OrbitPoint point;
  double distance;  ///< largest |p - p_Jeffery| in the first orbit
  double drift;     ///< largest relative change of C, or of |p_z| in the plane
  double constant;  ///< C/(1 + C) at the start
};
std::vector<JefferyRun> jeffery_runs(int spheres, double orbits, const std::vector<double>& constants,
                                     const OrbitOptions& options);
FlowStudy jeffery_study(const OrbitOptions& options);

/// Finite stiffness: period over the rigid chain's less 1 against mu rate/E, and its order.
struct StiffnessPoint {
  int spheres;
  double viscous_ratio;  ///< mu rate/E
  double correction;     ///< period over the rigid chain's - 1
  double order;          ///< from the row before; NaN in the first
};
std::vector<StiffnessPoint> stiffness_points(int spheres, const std::vector<double>& ratios,
                                             const OrbitOptions& options);
FlowStudy stiffness_study(const OrbitOptions& options);

}  // namespace fiberchain::compare
