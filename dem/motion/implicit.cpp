#include "dem/motion/implicit.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/bond/strain_change.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Size of the strain change in energy: its inner product weighted by the stiffnesses, and what it pushes
/// with.
template <int Dim>
BondStress<double, Dim> weighted(const BondParameters<double>& bond, const StrainChange<Dim>& z) {
  Vec<double, Dim> force = bond.shear * z.separation;
  force[0] = bond.stretch * z.separation[0];
  return {force, scale_spin(bond.twist, bond.bend, z.rotation)};
}

/// Stress at the middle of the step, corrected so that its work is U(end) - U(start).
template <int Dim>
BondStress<double, Dim> consistent_stress(const BondParameters<double>& bond,
                                          const BondKinematics<double, Dim>& middle,
                                          const StrainChange<Dim>& z, double energy_change,
                                          double position_size) {
  BondStress<double, Dim> stress = bond_stress(bond, middle.separation, middle.rotation);
  const double work = dot(stress.force, z.separation) + dot(stress.moment, z.rotation);
  const BondStress<double, Dim> push = weighted<Dim>(bond, z);
  const double size = dot(push.force, z.separation) + dot(push.moment, z.rotation);
  // where the strain changes by less than this, the energies differ by rounding only, and there is nothing to
  // correct: the correction is of third order in the change
  const double least = bond.stretch * position_size * position_size * 1e-14;
  const double scale = (energy_change - work) * size / (size * size + least * least);
  return {stress.force + scale * push.force, stress.moment + scale * push.moment};
}

template <int Dim>
double energy_of_bond(const Chain<Dim>& chain, const Poses<Dim>& poses, int bond) {
  const auto k = bond_kinematics(chain, poses, bond);
  return bond_energy(bond_parameters(chain.fiber), k.separation, k.rotation);
}

template <int Dim>
void move_by(Poses<Dim>& poses, const ChainVector<Dim>& velocity, double time) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].position = poses[i].position + time * displacement_part<Dim>(velocity[i]);
    turn_by_vector(poses[i].orientation, time * rotation_part<Dim>(velocity[i]));
  }
}

}  // namespace

template <int Dim>
ImplicitMotion<Dim>::ImplicitMotion(Chain<Dim> chain, Boundary<Dim> boundary, ChainState<Dim> state,
                                    ImplicitOptions options)
    : chain_(std::move(chain)),
      boundary_(std::move(boundary)),
      state_(std::move(state)),
      options_(options),
      acceleration_(state_.poses.size(), SphereVector<Dim>::Zero()),
      before_(acceleration_) {
  if (state_.poses.size() != chain_.poses.size() || state_.velocity.size() != state_.poses.size() ||
      state_.spin.size() != state_.poses.size()) {
    throw InvalidInput("a motion needs a pose, a velocity and a spin for every sphere of its chain");
  }
  refuse_branches(chain_.fiber, "the implicit midpoint");
  refuse_failure(chain_.fiber, "the implicit midpoint");
  for (const int sphere : boundary_.clamped) state_.velocity[sphere] = {}, state_.spin[sphere] = {};
  for (int i = 0; i < chain_.fiber.aspect_ratio; ++i)
    energy_.push_back(energy_of_bond(chain_, state_.poses, i));
}

template <int Dim>
typename ImplicitMotion<Dim>::Trial ImplicitMotion<Dim>::trial(const ChainVector<Dim>& mean_velocity,
                                                               double dt) const {
  Trial t{state_.poses, applied_loads(boundary_, static_cast<int>(state_.poses.size()))};
  Poses<Dim> end = state_.poses;
  move_by<Dim>(t.middle, mean_velocity, dt / 2);
  move_by<Dim>(end, mean_velocity, dt);
  const BondParameters<double> bond = bond_parameters(chain_.fiber);
  const double length = fiber_length(chain_.fiber);
  for (int i = 0; i < chain_.fiber.aspect_ratio; ++i) {
    const double energy_change = energy_of_bond(chain_, end, i) - energy_[i];
    const auto k = bond_kinematics(chain_, t.middle, i);
    const SphereVector<Dim> first = dt * mean_velocity[i], second = dt * mean_velocity[i + 1],
                            difference = second - first;
    const StrainChange<Dim> z = strain_change<Dim>(k, displacement_part<Dim>(difference),
                                                   rotation_part<Dim>(first), rotation_part<Dim>(second));
    const auto loads = bond_loads(k, consistent_stress(bond, k, z, energy_change, length));
    t.out_of_balance[i] += motion_of<Dim>(loads.force_on_first, loads.moment_on_first);
    t.out_of_balance[i + 1] += motion_of<Dim>(-loads.force_on_first, loads.moment_on_second);
  }
  const ChainVector<Dim> dashpots = dashpot_forces(chain_, t.middle, mean_velocity);
  for (std::size_t i = 0; i < dashpots.size(); ++i) {
    const SphereVector<Dim> change =
        2 * (mean_velocity[i] - motion_of<Dim>(state_.velocity[i], state_.spin[i]));
    t.out_of_balance[i] +=
        dashpots[i] - sphere_inertias<Dim>(chain_.fiber, static_cast<int>(i)).cwiseProduct(change) / dt;
  }
  for (const int sphere : boundary_.clamped) t.out_of_balance[sphere].setZero();
  return t;
}

template <int Dim>
ChainTangent<Dim> ImplicitMotion<Dim>::matrix(const Poses<Dim>& middle, double dt) const {
  return motion_matrix(chain_, middle, boundary_, stiffness(chain_, middle, Boundary<Dim>{}),
                       {2 / dt, 1.0, dt / 2});
}

template <int Dim>
void ImplicitMotion<Dim>::accept(const Poses<Dim>& middle, const ChainVector<Dim>& mean_velocity, double dt) {
  const ChainVector<Dim> dashpots = dashpot_forces(chain_, middle, mean_velocity);
  for (std::size_t i = 0; i < dashpots.size(); ++i) dissipated_ -= dt * dashpots[i].dot(mean_velocity[i]);
  move_by<Dim>(state_.poses, mean_velocity, dt);
  before_ = acceleration_;
  for (std::size_t i = 0; i < state_.poses.size(); ++i) {
    const Vec<double, Dim> v = 2.0 * displacement_part<Dim>(mean_velocity[i]) - state_.velocity[i];
    const Spin<double, Dim> w = 2.0 * rotation_part<Dim>(mean_velocity[i]) - state_.spin[i];
    acceleration_[i] = (1 / dt) * (motion_of<Dim>(v, w) - motion_of<Dim>(state_.velocity[i], state_.spin[i]));
    state_.velocity[i] = v;
    state_.spin[i] = w;
  }
  for (int i = 0; i < chain_.fiber.aspect_ratio; ++i) energy_[i] = energy_of_bond(chain_, state_.poses, i);
  ++work_.steps;
}

/// Newton's method with a matrix that is set up anew only where it no longer serves.
template <int Dim>
bool ImplicitMotion<Dim>::solve_step(double dt) {
  const double length = fiber_length(chain_.fiber);
  ChainVector<Dim> mean(state_.poses.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const SphereVector<Dim> expected =
        work_.steps > 1 ? (2 * acceleration_[i] - before_[i]).eval() : acceleration_[i];
    mean[i] = motion_of<Dim>(state_.velocity[i], state_.spin[i]) + dt / 2 * expected;
  }
  if (factors_step_ != dt) factors_.reset();
  double previous = 0;
  for (int n = 0; n < options_.max_iterations; ++n) {
    Trial now = trial(mean, dt);
    work_.bond_evaluations += chain_.fiber.aspect_ratio;
    const bool fresh = !factors_;
    if (fresh) {
      factors_.emplace(matrix(now.middle, dt));
      factors_step_ = dt;
      ++work_.factorizations;
    }
    ChainVector<Dim>& change = now.out_of_balance;
    factors_->solve_in_place(change);
    ++work_.linear_solves;
    const double moved = dt * size_of<Dim>(mean, length), corrected = dt * size_of<Dim>(change, length);
    if (!std::isfinite(corrected)) break;
    // at the rounding of the positions corrections stop shrinking, even with a new matrix
    const bool at_rounding =
        n > 0 && (corrected < 1e-15 || (fresh && corrected < 1e-7 * moved && corrected > 0.1 * previous));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += change[i];
    // what is left is at most the correction times the rate at which corrections shrink
    const double left = n > 0 ? corrected * std::min(corrected / previous, 1.0) : corrected;
    if (left <= options_.tolerance * moved || corrected == 0 || at_rounding) {
      accept(now.middle, mean, dt);
      return true;
    }
    if (n > 0 && corrected > 0.1 * previous) factors_.reset();
    previous = corrected;
  }
  factors_.reset();
  return false;
}

template <int Dim>
void ImplicitMotion<Dim>::step(double dt) {
  constexpr int halvings = 10;
  double left = dt, length = dt;
  for (int halved = 0; left > 1e-12 * dt;) {
    if (solve_step(std::min(length, left))) {
      left -= std::min(length, left);
    } else if (++halved <= halvings) {
      length /= 2;
    } else {
      throw Diverged(fmt::format(
          "the implicit step did not converge at step {:.0f} (dt = {:.6g} s); likely cause: a step "
          "too long for how fast the chain turns",
          work_.steps, dt));
    }
  }
}

template class ImplicitMotion<2>;
template class ImplicitMotion<3>;

}  // namespace fiberchain::dem
