#include "reference/elastica_motion.hpp"

#include <algorithm>
#include <cmath>

#include "reference/errors.hpp"

namespace fiberchain::reference::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Roots of the sections' inertias times their rotations: rotary mass = factor^T factor.
MatrixXd rotary_factor(const LegendreBeam& beam, const BeamLayout& layout) {
  MatrixXd rows(beam.nodes.size() + 1, beam.phi.cols());
  rows.topRows(beam.nodes.size()) =
      std::sqrt(layout.rotary_inertia) * beam.weights.cwiseSqrt().asDiagonal() * beam.phi;
  rows.bottomRows(1) = std::sqrt(layout.tip_inertia) * beam.phi_tip.transpose();
  return rows;
}

/// int_0^{s_j} at every node with the root of its weight, and int_0^1 with the root of the tip's mass.
MatrixXd velocity_rows(const LegendreBeam& beam, const BeamLayout& layout) {
  MatrixXd rows(beam.nodes.size() + 1, beam.nodes.size());
  rows.topRows(beam.nodes.size()) = beam.weights.cwiseSqrt().asDiagonal() * beam.integral;
  rows.bottomRows(1) = std::sqrt(layout.tip_mass) * beam.weights.transpose();
  return rows;
}

/// Angles, their rates and accelerations at the nodes.
struct Nodal {
  Nodal(const LegendreBeam& beam, const double* q, const double* v, Index n)
      : theta(beam.phi * Map<const VectorXd>(q, n)),
        rate(beam.phi * Map<const VectorXd>(v, n)),
        cosine(theta.array().cos()),
        sine(theta.array().sin()) {}

  VectorXd theta, rate, cosine, sine;
};

/// sum_k G_jk sin(theta_j - theta_k) a_k and the same with the cosine.
VectorXd sine_sum(const MatrixXd& g, const Nodal& at, const VectorXd& a) {
  return at.sine.cwiseProduct(g * at.cosine.cwiseProduct(a)) -
         at.cosine.cwiseProduct(g * at.sine.cwiseProduct(a));
}

VectorXd cosine_sum(const MatrixXd& g, const Nodal& at, const VectorXd& a) {
  return at.cosine.cwiseProduct(g * at.cosine.cwiseProduct(a)) +
         at.sine.cwiseProduct(g * at.sine.cwiseProduct(a));
}

/// G_jk sin(theta_j - theta_k).
MatrixXd sine_kernel(const MatrixXd& g, const Nodal& at) {
  return at.sine.asDiagonal() * g * at.cosine.asDiagonal() -
         MatrixXd(at.cosine.asDiagonal() * g * at.sine.asDiagonal());
}

MatrixXd cosine_kernel(const MatrixXd& g, const Nodal& at) {
  return at.cosine.asDiagonal() * g * at.cosine.asDiagonal() +
         MatrixXd(at.sine.asDiagonal() * g * at.sine.asDiagonal());
}

}  // namespace

ElasticaMotion::ElasticaMotion(const BeamLayout& layout_value, int modes) : layout(layout_value) {
  // cos(theta) of a curve of degree n is resolved by twice as many points
  const LegendreBeam raw = legendre_beam(modes, modes + modes / 2 + 4);
  velocity = velocity_rows(raw, layout);
  const MatrixXd moving = velocity * raw.phi;
  const MatrixXd turning = rotary_factor(raw, layout);
  MatrixXd factor(moving.rows() + turning.rows(), modes);
  factor << moving, turning;
  beam = in_modal_coordinates(raw, factor);
  kernel = velocity.transpose() * velocity;
  const MatrixXd modal_turning = rotary_factor(beam, layout);
  rotary = modal_turning.transpose() * modal_turning;
}

MatrixXd ElasticaMotion::mass(const VectorXd& cosine, const VectorXd& sine) const {
  const MatrixXd x = velocity * (cosine.asDiagonal() * beam.phi);
  const MatrixXd y = velocity * (sine.asDiagonal() * beam.phi);
  MatrixXd m = rotary;
  m.noalias() += x.transpose() * x;
  m.noalias() += y.transpose() * y;
  return m;
}

void ElasticaMotion::rhs(std::span<const double> state, std::span<double> derivative) const {
  const Map<const VectorXd> q(state.data(), n());
  const Map<const VectorXd> v(state.data() + n(), n());
  const Nodal at(beam, q.data(), v.data(), n());
  const VectorXd centripetal = sine_sum(kernel, at, at.rate.array().square());
  const VectorXd force =
      -beam.phi.transpose() * centripetal - beam.stiffness.cwiseProduct(q + layout.retardation * v);
  Map<VectorXd> d(derivative.data(), size());
  d.head(n()) = v;
  d.segment(n(), n()) = mass(at.cosine, at.sine).llt().solve(force);
  d(2 * n()) = layout.retardation * v.dot(beam.stiffness.cwiseProduct(v));
}

void ElasticaMotion::jacobian(std::span<const double> state, std::span<double> entries) const {
  const Map<const VectorXd> v(state.data() + n(), n());
  const Nodal at(beam, state.data(), v.data(), n());
  VectorXd derivative(size());
  rhs(state, {derivative.data(), static_cast<std::size_t>(size())});
  const VectorXd acceleration = beam.phi * derivative.segment(n(), n());
  const VectorXd square = at.rate.array().square();
  const MatrixXd sines = sine_kernel(kernel, at);

  // derivative of h by the nodal angles: of column k through theta_k, of row j through theta_j
  MatrixXd by_theta = sines * acceleration.asDiagonal();
  by_theta.noalias() -= cosine_kernel(kernel, at) * square.asDiagonal();
  by_theta.diagonal() += cosine_sum(kernel, at, square) - sine_sum(kernel, at, acceleration);

  MatrixXd by_q = beam.phi.transpose() * by_theta * beam.phi;
  by_q.diagonal() += beam.stiffness;
  MatrixXd by_v = 2 * beam.phi.transpose() * (sines * at.rate.asDiagonal()) * beam.phi;
  by_v.diagonal() += layout.retardation * beam.stiffness;
  const Eigen::LLT<MatrixXd> solver(mass(at.cosine, at.sine));
  Map<MatrixXd> j(entries.data(), size(), size());
  j.block(0, n(), n(), n()).setIdentity();
  j.block(n(), 0, n(), n()) = -solver.solve(by_q);
  j.block(n(), n(), n(), n()) = -solver.solve(by_v);
  j.row(2 * n()).segment(n(), n()) = 2 * layout.retardation * beam.stiffness.cwiseProduct(v).transpose();
}

VectorXd ElasticaMotion::equilibrium(double load) const {
  require_between("release amount", load, -1000, 1000);
  VectorXd q = VectorXd::Zero(n());
  const int stages = 1 + static_cast<int>(std::abs(load));
  for (int stage = 1; stage <= stages; ++stage) {
    const double part = load * stage / stages;
    double change = 1;
    for (int i = 0; i < 60 && change > 1e-14; ++i) {
      const ArrayXd theta = (beam.phi * q).array();
      const VectorXd pull = part * beam.weights.array() * theta.cos();
      const VectorXd turn = part * beam.weights.array() * theta.sin();
      MatrixXd tangent = beam.phi.transpose() * turn.asDiagonal() * beam.phi;
      tangent.diagonal() += beam.stiffness;
      const VectorXd step = tangent.llt().solve(beam.phi.transpose() * pull - beam.stiffness.cwiseProduct(q));
      q += step;
      change = std::sqrt(step.dot(beam.stiffness.cwiseProduct(step)) / q.dot(beam.stiffness.cwiseProduct(q)));
    }
    if (load != 0 && !(change < 1e-10))
      throw NoConvergence("static shape of the Elastica before its release");
  }
  return q;
}

VectorXd ElasticaMotion::start(const Release& release) const {
  VectorXd state = VectorXd::Zero(size());
  if (release.shape == Release::Shape::static_load) {
    state.head(n()) = equilibrium(release.amount);
  } else {
    require_between("release amount", release.amount, -0.5, 0.5);
    state(0) = release.amount / beam.phi.col(0).dot(beam.weights);
  }
  return state;
}

BeamSample ElasticaMotion::sample(double time, std::span<const double> state) const {
  const Map<const VectorXd> q(state.data(), n());
  const Map<const VectorXd> v(state.data() + n(), n());
  const Nodal at(beam, q.data(), v.data(), n());
  // 1 - cos(theta) as 2 sin^2(theta/2): small deflections keep their shortening's digits
  const VectorXd half = (at.theta.array() / 2).sin();
  BeamSample s{};
  s.time = time;
  s.y = beam.weights.dot(at.sine);
  s.x = 2 * beam.weights.dot(half.cwiseProduct(half));
  s.angle = beam.phi_tip.dot(q);
  s.y_rate = beam.weights.dot(at.cosine.cwiseProduct(at.rate));
  s.x_rate = beam.weights.dot(at.sine.cwiseProduct(at.rate));
  s.angle_rate = beam.phi_tip.dot(v);
  s.kinetic = v.dot(mass(at.cosine, at.sine) * v) / 2;
  s.elastic = q.dot(beam.stiffness.cwiseProduct(q)) / 2;
  s.dissipated = state[static_cast<std::size_t>(2 * n())];
  return s;
}

}  // namespace fiberchain::reference::detail
