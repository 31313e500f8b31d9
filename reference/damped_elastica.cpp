#include "reference/damped_elastica.hpp"

#include <cmath>
#include <limits>

#include "reference/elastica_motion.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

void validate(const BeamLayout& layout) {
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("retardation", layout.retardation, 0, largest);
  require_between("tip_mass", layout.tip_mass, 0, largest);
  require_between("tip_inertia", layout.tip_inertia, 0, largest);
  require_between("rotary_inertia", layout.rotary_inertia, 0, largest);
}

}  // namespace

BeamLayout chain_layout(int bonds, double bond_damping) {
  require_between("bonds", bonds, 1, 100000);
  require_between("bond_damping", bond_damping, 0, std::numeric_limits<double>::max());
  const double n = bonds;
  // J = 0.4 m R^2 with R = l/2; sqrt(2 J / K_bend) = sqrt(3.2) t_b and the time unit is 4 n^2 t_b
  return {bond_damping / (std::sqrt(5.0) * n * n), 0.5 / n, 0.05 / (n * n * n), 0.1 / (n * n)};
}

double chain_time_unit(int bonds) {
  require_between("bonds", bonds, 1, 100000);
  return 4.0 * bonds * bonds;
}

BeamHistory damped_elastica(const BeamLayout& layout, const Release& release,
                            const std::vector<double>& times, const BeamResolution& resolution) {
  validate(layout);
  require_times(times);
  const detail::ElasticaMotion motion(layout, resolution.modes);
  const Eigen::VectorXd start = motion.start(release);
  const std::span<const double> initial(start.data(), static_cast<std::size_t>(start.size()));
  detail::Cvode cvode(
      resolution.method,
      [&](double, std::span<const double> state, std::span<double> d) { motion.rhs(state, d); },
      [&](double, std::span<const double> state, std::span<double> j) { motion.jacobian(state, j); }, 0,
      initial, resolution.tolerances, "damped Elastica by CVODE");
  BeamHistory history;
  for (const double time : times) {
    history.samples.push_back(motion.sample(time, time == 0 ? initial : cvode.advance(time)));
  }
  history.statistics = cvode.statistics();
  return history;
}

std::vector<double> beam_frequencies(const BeamLayout& layout, int modes) {
  validate(layout);
  const Eigen::VectorXd omega = detail::ElasticaMotion(layout, modes).beam.stiffness.cwiseSqrt();
  return {omega.begin(), omega.end()};
}

double amplitude_frequency_coefficient() {
  const detail::LegendreBeam beam = detail::ElasticaMotion({}, 20).beam;
  const Eigen::VectorXd slope = beam.phi.col(0) / beam.phi.col(0).dot(beam.weights);
  const Eigen::VectorXd phi = beam.integral * slope;
  const Eigen::VectorXd stretch = beam.integral * slope.cwiseProduct(slope);
  const double omega2 = beam.stiffness(0);
  // phi'' by phi'''' = omega^2 phi: phi''(s) = omega^2 int_s^1 int phi
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(slope.size());
  const auto from_tip = [&](const Eigen::VectorXd& f) -> Eigen::VectorXd {
    return beam.weights.dot(f) * ones - beam.integral * f;
  };
  const Eigen::VectorXd curvature = omega2 * from_tip(from_tip(phi));
  const double bending = beam.weights.dot(curvature.cwiseProduct(slope).cwiseAbs2());
  const double sinking = beam.weights.dot(stretch.cwiseAbs2());
  const double mass = beam.weights.dot(phi.cwiseAbs2());
  return (1.5 * bending - 0.5 * omega2 * sinking) / (2 * omega2 * mass);
}

}  // namespace fiberchain::reference
