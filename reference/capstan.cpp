#include "reference/capstan.hpp"

#include <cmath>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

/// Moment of an elastica that makes this angle with its force F, far from where it is straight.
double free_moment(double bending_stiffness, double force, double angle) {
  return std::sqrt(2 * bending_stiffness * force * (1 - std::cos(angle)));
}

struct Arc {
  double growth;    ///< of ln T with the angle
  double pressure;  ///< p/T [1/m]
  double couple;    ///< mu r [m]
};

Arc arc_of(const Capstan& c) {
  const double couple = c.friction * c.rod_radius, growth = tension_growth(c);
  return {growth, 1 / (c.radius * (1 + couple * growth / c.radius)), couple};
}

/// Where the rod comes to the drum: the tension behind the point force, by the angle.
double tension_behind(const Capstan& c, const Arc& arc, double force, double angle) {
  return force * (std::cos(angle) + c.friction * std::sin(angle)) /
         (1 + c.friction * arc.couple * arc.pressure);
}

double held_angle(const Capstan& c, const Arc& arc, double force) {
  const auto moment_out_of_balance = [&](double angle) {
    const double point_force =
        force * std::sin(angle) - arc.couple * arc.pressure * tension_behind(c, arc, force, angle);
    return free_moment(c.bending_stiffness, force, angle) - c.bending_stiffness / c.radius -
           arc.couple * point_force;
  };
  if (!(moment_out_of_balance(std::numbers::pi) > 0))
    throw InvalidArgument("held_force", force, "larger, so that the rod is bent down to the drum");
  return detail::find_root(moment_out_of_balance, 0, std::numbers::pi, {}, "where a rod comes to its drum");
}

}  // namespace

double euler_eytelwein(double friction, double turning) {
  if (!(friction >= 0)) throw InvalidArgument("friction", friction, "0 or more");
  if (!(turning >= 0)) throw InvalidArgument("turning", turning, "0 or more");
  return std::exp(friction * turning);
}

double tension_growth(const Capstan& c) {
  // growth (1 + mu (r/rho) growth) = mu (1 - r/rho)
  const double thickness = c.rod_radius / c.radius, drive = c.friction * (1 - thickness);
  return 2 * drive / (1 + std::sqrt(1 + 4 * c.friction * thickness * drive));
}

CapstanPull drawn_over(const Capstan& c, double held_force) {
  require_positive("radius", c.radius);
  require_positive("bending_stiffness", c.bending_stiffness);
  require_positive("held_force", held_force);
  require_between("rod_radius", c.rod_radius, 0, c.radius);
  require_between("friction", c.friction, 0, 10);
  require_positive("turning", c.turning);
  const Arc arc = arc_of(c);
  CapstanPull pull{.force = 0, .touching = 0, .held_angle = held_angle(c, arc, held_force), .drawn_angle = 0};
  const double begin = tension_behind(c, arc, held_force, pull.held_angle);
  const auto force_at = [&](double angle, double end) {
    return end * (1 + c.friction * arc.couple * arc.pressure) /
           (std::cos(angle) - c.friction * std::sin(angle));
  };
  const auto moment_out_of_balance = [&](double angle) {
    const double end = begin * std::exp(arc.growth * (c.turning - pull.held_angle - angle));
    const double force = force_at(angle, end);
    const double point_force = force * std::sin(angle) + arc.couple * arc.pressure * end;
    return free_moment(c.bending_stiffness, force, angle) - c.bending_stiffness / c.radius +
           arc.couple * point_force;
  };
  if (!(moment_out_of_balance(0) < 0))
    throw InvalidArgument("held_force", held_force,
                          "smaller, so that friction's couple does not straighten the rod where it leaves");
  const double steepest = 0.999 * std::atan2(1, c.friction);  // the point force lies in the cone of friction
  const double most = std::fmin(steepest, c.turning - pull.held_angle);
  if (!(most > 0 && moment_out_of_balance(most) > 0))
    throw InvalidArgument("turning", c.turning, "so large that an arc of the rod touches the drum");
  pull.drawn_angle = detail::find_root(moment_out_of_balance, 0, most, {}, "where a rod leaves its drum");
  pull.touching = c.turning - pull.held_angle - pull.drawn_angle;
  pull.force = force_at(pull.drawn_angle, begin * std::exp(arc.growth * pull.touching));
  return pull;
}

}  // namespace fiberchain::reference
