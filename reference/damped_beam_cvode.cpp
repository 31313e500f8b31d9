#include <Eigen/Dense>
#include <limits>

#include "reference/beam_march.hpp"
#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"
#include "reference/legendre_beam.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ModalState = Eigen::Map<const VectorXd>;

constexpr double kLargestNumber = std::numeric_limits<double>::max();

/// Slope w_s = sum q_k phi_k: M q'' + (retardation K + viscous M) q' + K q = 0. ModalState: q, q', energy
/// dissipated.
struct Discretization {
  Discretization(const BeamDamping& damping_value, int modes) : damping(damping_value) {
    const detail::LegendreBeam raw = detail::legendre_beam(modes, modes + 2);
    beam = detail::in_modal_coordinates(raw, detail::mass_factor(raw));
    const MatrixXd factor = detail::mass_factor(beam);
    mass = factor.transpose() * factor;
    restoring = mass.llt().solve(MatrixXd(beam.stiffness.asDiagonal()));
    tip = beam.phi.transpose() * beam.weights;
  }

  Eigen::Index n() const { return mass.rows(); }

  VectorXd start(const Release& release) const {
    VectorXd state = VectorXd::Zero(2 * n() + 1);
    if (release.shape == Release::Shape::static_load) {
      state.head(n()) = release.amount * tip.cwiseQuotient(beam.stiffness);
    } else {
      state(0) = release.amount / tip(0);
    }
    return state;
  }

  void rhs(const ModalState& state, Eigen::Map<VectorXd> derivative) const {
    const auto q = state.head(n());
    const auto v = state.segment(n(), n());
    derivative.head(n()) = v;
    derivative.segment(n(), n()).noalias() = -restoring * (q + damping.retardation * v);
    derivative.segment(n(), n()) -= damping.viscous * v;
    derivative(2 * n()) =
        damping.retardation * v.dot(beam.stiffness.cwiseProduct(v)) + damping.viscous * v.dot(mass * v);
  }

  void jacobian(const ModalState& state, Eigen::Map<MatrixXd> j) const {
    const auto v = state.segment(n(), n());
    j.block(0, n(), n(), n()).setIdentity();
    j.block(n(), 0, n(), n()) = -restoring;
    j.block(n(), n(), n(), n()) = -damping.retardation * restoring;
    j.block(n(), n(), n(), n()).diagonal().array() -= damping.viscous;
    j.row(2 * n()).segment(n(), n()) =
        2 * (damping.retardation * beam.stiffness.cwiseProduct(v) + damping.viscous * (mass * v)).transpose();
  }

  BeamSample sample(double time, const ModalState& state) const {
    const auto q = state.head(n());
    const auto v = state.segment(n(), n());
    BeamSample at{};
    at.time = time;
    at.y = tip.dot(q);
    at.y_rate = tip.dot(v);
    at.angle = beam.phi_tip.dot(q);
    at.angle_rate = beam.phi_tip.dot(v);
    at.kinetic = v.dot(mass * v) / 2;
    at.elastic = q.dot(beam.stiffness.cwiseProduct(q)) / 2;
    at.dissipated = state(2 * n());
    return at;
  }

  BeamDamping damping;
  detail::LegendreBeam beam;
  MatrixXd mass;       ///< M, the identity to rounding
  MatrixXd restoring;  ///< M^-1 K
  VectorXd tip;        ///< w(1) = tip . q
};

}  // namespace

BeamHistory damped_beam_cvode(const BeamDamping& damping, const Release& release,
                              const std::vector<double>& times, const BeamResolution& resolution) {
  require_between("retardation", damping.retardation, 0, kLargestNumber);
  require_between("viscous", damping.viscous, 0, kLargestNumber);
  require_between("release amount", release.amount, -kLargestNumber, kLargestNumber);
  require_times(times);
  const Discretization beam(damping, resolution.modes);
  return detail::march_beam(beam, beam.start(release), times, resolution, "damped beam by CVODE");
}

}  // namespace fiberchain::reference
