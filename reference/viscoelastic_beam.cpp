#include "reference/viscoelastic_beam.hpp"

#include <Eigen/Dense>
#include <limits>

#include "reference/beam_march.hpp"
#include "reference/errors.hpp"
#include "reference/legendre_beam.hpp"

namespace fiberchain::reference {
namespace {

using BeamVector = Eigen::VectorXd;
using BeamState = Eigen::Map<const Eigen::VectorXd>;

/// In coordinates q of the elastic modes, unit masses and stiffnesses omega^2:
/// q'' = -omega^2 (q + retardation q' + sum g_j x_j) - viscous q', x_j' = q' - x_j/tau_j.
/// State: q, q', x_1 ... x_J, energy dissipated.
struct ModalMaxwellBeam {
  ModalMaxwellBeam(const ViscoelasticDamping& damping_value, int modes) : damping(damping_value) {
    const detail::LegendreBeam raw = detail::legendre_beam(modes, modes + 2);
    const detail::LegendreBeam beam = detail::in_modal_coordinates(raw, detail::mass_factor(raw));
    stiffness = beam.stiffness;
    tip = beam.phi.transpose() * beam.weights;
    tip_angle = beam.phi_tip;
  }

  Eigen::Index n() const { return stiffness.size(); }
  Eigen::Index branches() const { return static_cast<Eigen::Index>(damping.spectrum.size()); }
  Eigen::Index size() const { return (2 + branches()) * n() + 1; }
  const PronyTerm& term(Eigen::Index j) const { return damping.spectrum[static_cast<std::size_t>(j)]; }
  Eigen::Index branch_start(Eigen::Index j) const { return (2 + j) * n(); }
  auto branch(const BeamState& state, Eigen::Index j) const { return state.segment(branch_start(j), n()); }

  BeamVector start(const HeldShape& shape) const {
    BeamVector state = BeamVector::Zero(size());
    state.head(n()) = shape.load * tip.cwiseQuotient(stiffness);
    for (std::size_t k = 0; k < shape.modes.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      state(i) += shape.modes[k] / tip(i);
    }
    return state;
  }

  void rhs(const BeamState& state, Eigen::Map<BeamVector> derivative) const {
    const auto v = state.segment(n(), n());
    BeamVector strain = state.head(n()) + damping.beside.retardation * v;
    double loss = damping.beside.retardation * v.dot(stiffness.cwiseProduct(v)) +
                  damping.beside.viscous * v.squaredNorm();
    for (Eigen::Index j = 0; j < branches(); ++j) {
      const auto x = branch(state, j);
      strain += term(j).strength * x;
      derivative.segment(branch_start(j), n()) = v - x / term(j).time;
      loss += term(j).strength / term(j).time * x.dot(stiffness.cwiseProduct(x));
    }
    derivative.head(n()) = v;
    derivative.segment(n(), n()) = -stiffness.cwiseProduct(strain) - damping.beside.viscous * v;
    derivative(size() - 1) = loss;
  }

  void jacobian(const BeamState& state, Eigen::Map<Eigen::MatrixXd> a) const {
    const Eigen::Index last = size() - 1;
    const auto v = state.segment(n(), n());
    const auto diagonal = [&](Eigen::Index row, Eigen::Index column) {
      return a.block(row, column, n(), n()).diagonal();
    };
    diagonal(0, n()).setOnes();
    diagonal(n(), 0) = -stiffness;
    diagonal(n(), n()) = -damping.beside.retardation * stiffness;
    diagonal(n(), n()).array() -= damping.beside.viscous;
    a.row(last).segment(n(), n()) =
        2 * (damping.beside.retardation * stiffness.cwiseProduct(v) + damping.beside.viscous * v).transpose();
    for (Eigen::Index j = 0; j < branches(); ++j) {
      const Eigen::Index at = branch_start(j);
      diagonal(n(), at) = -term(j).strength * stiffness;
      diagonal(at, n()).setOnes();
      diagonal(at, at).setConstant(-1 / term(j).time);
      a.row(last).segment(at, n()) =
          2 * term(j).strength / term(j).time * stiffness.cwiseProduct(branch(state, j)).transpose();
    }
  }

  BeamSample sample(double time, const BeamState& state) const {
    const auto q = state.head(n());
    const auto v = state.segment(n(), n());
    BeamSample at{};
    at.time = time;
    at.y = tip.dot(q);
    at.y_rate = tip.dot(v);
    at.angle = tip_angle.dot(q);
    at.angle_rate = tip_angle.dot(v);
    at.kinetic = v.squaredNorm() / 2;
    at.elastic = q.dot(stiffness.cwiseProduct(q)) / 2;
    for (Eigen::Index j = 0; j < branches(); ++j) {
      const auto x = branch(state, j);
      at.elastic += term(j).strength * x.dot(stiffness.cwiseProduct(x)) / 2;
    }
    at.dissipated = state(size() - 1);
    return at;
  }

  ViscoelasticDamping damping;
  BeamVector stiffness;  ///< omega^2
  BeamVector tip;        ///< w(1) = tip . q
  BeamVector tip_angle;  ///< w_s(1) = tip_angle . q
};

void validate_release(const ViscoelasticDamping& damping, const HeldShape& shape, int modes) {
  constexpr double largest = std::numeric_limits<double>::max();
  validate(damping.spectrum);
  require_between("retardation", damping.beside.retardation, 0, largest);
  require_between("viscous", damping.beside.viscous, 0, largest);
  require_between("load", shape.load, -largest, largest);
  for (const double each : shape.modes) require_between("tip deflection of a mode", each, -largest, largest);
  require_between("modes of the shape", static_cast<double>(shape.modes.size()), 0, modes);
}

}  // namespace

BeamHistory viscoelastic_beam(const ViscoelasticDamping& damping, const HeldShape& shape,
                              const std::vector<double>& times, const BeamResolution& resolution) {
  validate_release(damping, shape, resolution.modes);
  require_times(times);
  const ModalMaxwellBeam beam(damping, resolution.modes);
  return detail::march_beam(beam, beam.start(shape), times, resolution, "viscoelastic beam by CVODE");
}

}  // namespace fiberchain::reference
