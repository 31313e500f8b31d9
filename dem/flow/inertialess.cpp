#include "dem/flow/inertialess.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "dem/chain/pose_numbers.hpp"
#include "dem/flow/draining_balance.hpp"
#include "dem/flow/interacting_balance.hpp"
#include "dem/motion/cvode_session.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
using Balance = std::variant<DrainingBalance<Dim>, InteractingBalance<Dim>>;

template <int Dim>
Balance<Dim> balance_of(const FlowCase<Dim>& flow) {
  if (flow.fluid.hydrodynamics == Hydrodynamics::free_draining) {
    return DrainingBalance<Dim>(flow.chain, flow.boundary, flow.fluid);
  }
  return InteractingBalance<Dim>(flow.chain, flow.boundary, flow.fluid);
}

/// How far a sphere has turned from one orientation to another.
struct Turn2 {
  double c, s;
};
Turn2 turn_between(double from, double to) { return {std::cos(to - from), std::sin(to - from)}; }
Quaternion<double> turn_between(const Quaternion<double>& from, const Quaternion<double>& to) {
  return to * conjugate(from);
}
Turn2 back(const Turn2& turn) { return {turn.c, -turn.s}; }
Quaternion<double> back(const Quaternion<double>& turn) { return conjugate(turn); }

SphereVector<2> turned(const Turn2& t, const SphereVector<2>& v) {
  return {t.c * v[0] - t.s * v[1], t.s * v[0] + t.c * v[1], v[2]};
}
SphereVector<3> turned(const Quaternion<double>& q, const SphereVector<3>& v) {
  return motion_of<3>(rotate(q, displacement_part<3>(v)), rotate(q, rotation_part<3>(v)));
}

}  // namespace

template <int Dim>
struct InertialessMotion<Dim>::Solver {
  Balance<Dim> balance;
  int spheres, bonds;
  double displacement_error, rotation_error;
  std::optional<CvodeSession> session{};
  Poses<Dim> factors_at{}, at_last_rates{}, at_rates_before{};
  double factors_gamma = 0, last_size = 0;
  int uses = 0;
  Work work{};

  Poses<Dim> unpack(const double* numbers) const {
    Poses<Dim> poses(spheres);
    for (int i = 0; i < spheres; ++i) poses[i] = read_pose<Dim>(numbers + i * pose_size<Dim>);
    return poses;
  }

  ChainVector<Dim> velocities(double time, const Poses<Dim>& poses) {
    work.bond_evaluations += bonds;
    return std::visit([&](const auto& b) { return b.velocities(time, poses); }, balance);
  }

  void rates(double time, const double* numbers, double* out) {
    const Poses<Dim> poses = unpack(numbers);
    at_rates_before = std::exchange(at_last_rates, poses);
    const ChainVector<Dim> v = velocities(time, poses);
    for (int i = 0; i < spheres; ++i, out += pose_size<Dim>) {
      for (int c = 0; c < Dim; ++c) out[c] = v[i][c];
      write_rate(poses[i].orientation, rotation_part<Dim>(v[i]), out + Dim);
    }
  }

  /// Size of a correction in allowed errors, root of the mean square as CVODE's.
  double size(const ChainVector<Dim>& x) const {
    double sum = 0;
    for (const auto& own : x) {
      sum += own.template head<Dim>().squaredNorm() / (displacement_error * displacement_error) +
             own.template tail<spin_size<Dim>>().squaredNorm() / (rotation_error * rotation_error);
    }
    return std::sqrt(sum / (spheres * sphere_motions<Dim>));
  }

  /// At the last poses that Newton's iterations previous_step to: the tension of predicted ones, whose
  /// strains are extrapolated, would stiffen or soften the bonds across them by far more than the fiber's
  /// own.
  void set_up(const CvodeProblem::Newton& newton) {
    factors_at = newton.again > 0 || at_rates_before.empty() ? at_last_rates : at_rates_before;
    std::visit([&](auto& b) { b.set_up(newton.time, factors_at, newton.gamma); }, balance);
    factors_gamma = newton.gamma;
    uses = 0;
    ++work.factorizations;
  }

  ChainVector<Dim> correction(const ChainVector<Dim>& b, const Poses<Dim>& poses, double gamma) {
    ChainVector<Dim> x(spheres);
    for (int i = 0; i < spheres; ++i) {
      x[i] = turned(back(turn_between(factors_at[i].orientation, poses[i].orientation)), b[i]);
    }
    std::visit([&](const auto& own) { own.solve_in_place(x); }, balance);
    const double scale = 2 / (1 + gamma / factors_gamma);  // as CVODE's for a gamma that has moved on
    for (int i = 0; i < spheres; ++i) {
      x[i] = scale * turned(turn_between(factors_at[i].orientation, poses[i].orientation), x[i]);
    }
    ++work.linear_solves;
    ++uses;
    return x;
  }

  /// Newton's correction x of the motions; a kept matrix is made anew where gamma has moved on, the matrix
  /// has served long, or corrections do not shrink to a fifth.
  void solve(const CvodeProblem::Newton& newton, const double* b, double* out) {
    const Poses<Dim> poses = unpack(newton.y);
    ChainVector<Dim> rhs(spheres);
    for (int i = 0; i < spheres; ++i) {
      const double* own = b + i * pose_size<Dim>;
      Vec<double, Dim> moved;
      for (int c = 0; c < Dim; ++c) moved[c] = own[c];
      rhs[i] = motion_of<Dim>(moved, rotation_of(poses[i].orientation, own + Dim));
    }
    const bool fresh = factors_gamma == newton.gamma && uses <= newton.again;
    if (uses == 0 || std::abs(newton.gamma / factors_gamma - 1) > 0.25 || uses > 40) set_up(newton);
    ChainVector<Dim> x = correction(rhs, poses, newton.gamma);
    if (newton.again > 0 && !fresh && size(x) > 0.2 * last_size) {
      set_up(newton);
      x = correction(rhs, poses, newton.gamma);
    }
    last_size = size(x);
    for (int i = 0; i < spheres; ++i, b += pose_size<Dim>, out += pose_size<Dim>) {
      double own[orientation_size<Dim>];
      write_rate(poses[i].orientation, rotation_part<Dim>((x[i] - rhs[i]).eval()), own);
      for (int c = 0; c < Dim; ++c) out[c] = x[i][c];
      for (int c = 0; c < orientation_size<Dim>; ++c) out[Dim + c] = b[Dim + c] + own[c];
    }
  }
};

template <int Dim>
InertialessMotion<Dim>::InertialessMotion(const FlowCase<Dim>& flow, double tolerance) {
  check<Dim>(flow.fluid);
  refuse_branches(flow.chain.fiber, "fibers in a fluid");
  refuse_failure(flow.chain.fiber, "fibers in a fluid");
  const int n = static_cast<int>(flow.start.size());
  solver_ = std::make_unique<Solver>(Solver{balance_of(flow), n, flow.chain.fiber.aspect_ratio,
                                            tolerance * fiber_length(flow.chain.fiber), tolerance});
  Solver& s = *solver_;
  CvodeProblem problem;
  problem.start.resize(n * pose_size<Dim>);
  problem.tolerances.resize(problem.start.size());
  for (int i = 0; i < n; ++i) write_pose(flow.start[i], problem.start.data() + i * pose_size<Dim>);
  for (std::size_t i = 0; i < problem.start.size(); ++i) {
    problem.tolerances[i] =
        static_cast<int>(i % pose_size<Dim>) < Dim ? s.displacement_error : s.rotation_error;
  }
  problem.max_steps = 1000000;
  problem.rates = [&s](double time, const double* y, double* rate) { s.rates(time, y, rate); };
  problem.solve = [&s](const CvodeProblem::Newton& newton, const double* b, double* x) {
    s.solve(newton, b, x);
  };
  s.session.emplace(std::move(problem));
}

template <int Dim>
InertialessMotion<Dim>::~InertialessMotion() = default;
template <int Dim>
InertialessMotion<Dim>::InertialessMotion(InertialessMotion&&) noexcept = default;

template <int Dim>
ChainState<Dim> InertialessMotion<Dim>::at(double time) {
  ChainState<Dim> state = at_rest<Dim>(solver_->unpack(solver_->session->at(time)));
  const ChainVector<Dim> v = solver_->velocities(time, state.poses);
  for (std::size_t i = 0; i < v.size(); ++i) {
    state.velocity[i] = displacement_part<Dim>(v[i]);
    state.spin[i] = rotation_part<Dim>(v[i]);
  }
  return state;
}

template <int Dim>
Work InertialessMotion<Dim>::work() const {
  Work work = solver_->work;
  work.steps = solver_->session->steps();
  return work;
}

template class InertialessMotion<2>;
template class InertialessMotion<3>;

}  // namespace fiberchain::dem
