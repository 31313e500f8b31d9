#pragma once

#include "compare/flow/study.hpp"

// What a flexible fiber does as it turns over in shear: the regimes that Forgacs and Mason named (J. Colloid
// Sci. 14 (1959) 457 and 473), told apart by measured quantities.
namespace fiberchain::compare {

/// A fiber that has just turned into the quadrant in which the flow compresses it: along (-1, 0.05).
struct RegimeCase {
  int spheres = 31;
  double elasto_viscous = 1000;  ///< 3 pi mu rate L^4/(E I)
  double turns = 0.52;           ///< how long, in periods of the rigid chain
  double bend = 0.01;            ///< height over L of a parabola at the start; an S has a third of it
  double tolerance = 1e-7;
};

/// By the first that holds:
/// - coil: somewhere along the fiber its direction turns by 3/2 pi or more at one moment: it is folded more
/// than once;
/// - snake turn: the ends change places in more than twice as many half turns as the fiber's long axis goes
/// through: it
///   swings back, the bend travels along the fiber;
/// - C-shaped: the end-to-end distance falls below 0.9 of the straight one's: the fiber buckles and turns
/// over bent (into
///   a C where the even mode leads, as from the start here; into an S where it does not);
/// - springy: it falls below 0.99;
/// - rigid.
enum class Regime { rigid, springy, c_shaped, snake_turn, coil };

std::string_view name(Regime regime);

struct RegimePoint {
  RegimeCase asked;
  Regime regime;
  double end_to_end_least;  ///< over the straight fiber's
  double gradient_extent;   ///< largest extent along the gradient, over L
  double direction_span;    ///< largest difference of direction along the fiber at one moment [rad]
  double stretch;           ///< largest relative change of the fiber's length along its spheres
  int inflections;          ///< most changes of the sign of bends above a fifth of the largest, while bent
  int half_turns;           ///< of the vector from end to end
  int axis_half_turns;      ///< of the long axis (gyration tensor), net
  double period;            ///< rate times period, of the half turns; NaN without
  std::vector<FlowShape>
      turning;         ///< the fiber while it first is less than 0.95 L long in the flow's direction
  double run_time;     ///< [s]
  std::string status;  ///< "finished", else why not
};

std::vector<RegimePoint> regime_points(const std::vector<RegimeCase>& cases, const OrbitOptions& options);

FlowStudy regime_study(const OrbitOptions& options);

}  // namespace fiberchain::compare
