#include "dem/motion/cvode.hpp"

#include <algorithm>

#include "dem/chain/pose_numbers.hpp"
#include "dem/motion/cvode_session.hpp"

namespace fiberchain::dem {
namespace {

/// Numbers of one sphere in CVODE's vector: pose, velocity, spin.
template <int Dim>
inline constexpr int sphere_size = pose_size<Dim> + sphere_motions<Dim>;

}  // namespace

template <int Dim>
struct CvodeMotion<Dim>::Solver {
  Chain<Dim> chain;
  Boundary<Dim> boundary;
  std::optional<Medium<Dim>> medium;
  ChainVector<Dim> loads;
  ChainVector<Dim> inertias;
  std::optional<CvodeSession> session;
  // Newton's matrix of one step and what its right-hand side takes
  std::optional<ChainFactors<sphere_motions<Dim>>> factors;
  std::optional<ChainTangent<Dim>> springs;
  Poses<Dim> factors_at;
  Work work;

  int spheres() const { return static_cast<int>(chain.poses.size()); }

  ChainState<Dim> unpack(const double* numbers) const {
    ChainState<Dim> state = at_rest<Dim>(chain.poses);
    for (int i = 0; i < spheres(); ++i, numbers += sphere_size<Dim>) {
      state.poses[i] = read_pose<Dim>(numbers);
      for (int c = 0; c < Dim; ++c) state.velocity[i][c] = numbers[pose_size<Dim> + c];
      for (int c = 0; c < spin_size<Dim>; ++c) state.spin[i][c] = numbers[pose_size<Dim> + Dim + c];
    }
    return state;
  }

  void pack(const ChainState<Dim>& state, double* numbers) const {
    for (int i = 0; i < spheres(); ++i, numbers += sphere_size<Dim>) {
      write_pose(state.poses[i], numbers);
      for (int c = 0; c < Dim; ++c) numbers[pose_size<Dim> + c] = state.velocity[i][c];
      for (int c = 0; c < spin_size<Dim>; ++c) numbers[pose_size<Dim> + Dim + c] = state.spin[i][c];
    }
  }

  void rates(double time, const double* numbers, double* out) {
    const ChainState<Dim> state = unpack(numbers);
    ChainVector<Dim> velocity(spheres()), forces = bond_forces(chain, state.poses);
    for (int i = 0; i < spheres(); ++i) velocity[i] = motion_of<Dim>(state.velocity[i], state.spin[i]);
    const ChainVector<Dim> dashpots = dashpot_forces(chain, state.poses, velocity);
    for (int i = 0; i < spheres(); ++i) forces[i] += dashpots[i] + loads[i];
    if (medium) {
      const ChainVector<Dim> stream = medium->velocity(time, state.poses);
      for (int i = 0; i < spheres(); ++i) forces[i] += medium->drag.cwiseProduct(stream[i] - velocity[i]);
    }
    for (int i = 0; i < spheres(); ++i) forces[i] = forces[i].cwiseQuotient(inertias[i]);
    for (const int sphere : boundary.clamped) forces[sphere].setZero(), velocity[sphere].setZero();
    for (int i = 0; i < spheres(); ++i, out += sphere_size<Dim>) {
      for (int c = 0; c < Dim; ++c) out[c] = velocity[i][c];
      write_rate(state.poses[i].orientation, rotation_part<Dim>(velocity[i]), out + Dim);
      for (int c = 0; c < sphere_motions<Dim>; ++c) out[pose_size<Dim> + c] = forces[i][c];
    }
    work.bond_evaluations += chain.fiber.aspect_ratio;
  }

  void set_up_matrix(const double* predicted, double gamma) {
    factors_at = unpack(predicted).poses;
    springs.emplace(stiffness(chain, factors_at, Boundary<Dim>{}));
    ChainTangent<Dim> A = motion_matrix(chain, factors_at, boundary, *springs, {1.0, gamma, gamma * gamma});
    if (medium) {
      for (auto& block : A.diagonal) block.diagonal() += gamma * medium->drag;
      hold_clamped(A, boundary);
    }
    factors.emplace(A);
    ++work.factorizations;
  }

  /// (I - g J) x = b: with b = (b_x, b_v), (M + g C + g^2 K) x_v = M b_v - g K b_x and x_x = b_x + g x_v. The
  /// changes of the orientation's rate with the orientation itself and of the medium's velocity along the way
  /// are left to Newton's iterations.
  void solve(const double* b, double* x, double gamma) {
    ChainVector<Dim> displaced(spheres()), rhs(spheres());
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim>;
      Vec<double, Dim> moved;
      for (int c = 0; c < Dim; ++c) moved[c] = own[c];
      displaced[i] = motion_of<Dim>(moved, rotation_of(factors_at[i].orientation, own + Dim));
    }
    const ChainVector<Dim> resisted = product(*springs, displaced);
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim> + pose_size<Dim>;
      for (int c = 0; c < sphere_motions<Dim>; ++c)
        rhs[i][c] = inertias[i][c] * own[c] - gamma * resisted[i][c];
    }
    for (const int sphere : boundary.clamped) rhs[sphere].setZero();
    factors->solve_in_place(rhs);
    ++work.linear_solves;
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim>;
      double* out = x + i * sphere_size<Dim>;
      const SphereVector<Dim> advance = gamma * rhs[i];
      double turned[orientation_size<Dim>];
      write_rate(factors_at[i].orientation, rotation_part<Dim>(advance), turned);
      for (int c = 0; c < Dim; ++c) out[c] = own[c] + advance[c];
      for (int c = 0; c < orientation_size<Dim>; ++c) out[Dim + c] = own[Dim + c] + turned[c];
      for (int c = 0; c < sphere_motions<Dim>; ++c) out[pose_size<Dim> + c] = rhs[i][c];
    }
  }

  std::vector<double> allowed_errors(const CvodeTolerance& tolerance) const {
    std::vector<double> errors(spheres() * sphere_size<Dim>);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const int own = static_cast<int>(i % sphere_size<Dim>), moving = own - pose_size<Dim>;
      const bool angular = moving < 0 ? own >= Dim : moving >= Dim;
      errors[i] = tolerance.relative * (angular ? tolerance.angle : tolerance.length) /
                  (moving < 0 ? 1 : tolerance.time);
    }
    return errors;
  }
};

template <int Dim>
CvodeMotion<Dim>::CvodeMotion(const Chain<Dim>& chain, const Boundary<Dim>& boundary,
                              const ChainState<Dim>& start, const CvodeTolerance& tolerance,
                              std::optional<Medium<Dim>> medium)
    : solver_(std::make_unique<Solver>()) {
  refuse_branches(chain.fiber, "CVODE");
  refuse_failure(chain.fiber, "CVODE");
  Solver& s = *solver_;
  s.chain = chain;
  s.boundary = boundary;
  s.medium = std::move(medium);
  s.loads = applied_loads(boundary, s.spheres());
  for (int i = 0; i < s.spheres(); ++i) s.inertias.push_back(sphere_inertias<Dim>(chain.fiber, i));
  CvodeProblem problem;
  problem.start.resize(s.spheres() * sphere_size<Dim>);
  s.pack(start, problem.start.data());
  problem.tolerances = s.allowed_errors(tolerance);
  problem.max_steps = tolerance.max_steps;
  problem.rates = [&s](double time, const double* y, double* rate) { s.rates(time, y, rate); };
  problem.solve = [&s](const CvodeProblem::Newton& newton, const double* b, double* x) {
    if (newton.again == 0) s.set_up_matrix(newton.y, newton.gamma);
    s.solve(b, x, newton.gamma);
  };
  s.session.emplace(std::move(problem));
}

template <int Dim>
CvodeMotion<Dim>::~CvodeMotion() = default;
template <int Dim>
CvodeMotion<Dim>::CvodeMotion(CvodeMotion&&) noexcept = default;

template <int Dim>
ChainState<Dim> CvodeMotion<Dim>::at(double time) {
  return solver_->unpack(solver_->session->at(time));
}

template <int Dim>
Work CvodeMotion<Dim>::work() const {
  Work work = solver_->work;
  work.steps = solver_->session->steps();
  return work;
}

template class CvodeMotion<2>;
template class CvodeMotion<3>;

}  // namespace fiberchain::dem
