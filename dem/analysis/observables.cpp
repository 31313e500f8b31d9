#include "dem/analysis/observables.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;
using std::numbers::pi;

/// Contact pairs between different fibers, each pair of fibers once.
std::int64_t distinct(std::vector<std::pair<std::int32_t, std::int32_t>>& pairs) {
  std::ranges::sort(pairs);
  return std::distance(pairs.begin(), std::ranges::unique(pairs).begin());
}

}  // namespace

Mean bending_angles(const Chain<3>& chain, FiberStates fibers) {
  Mean mean;
  for (const ChainState<3>& state : fibers) {
    const int bonds = static_cast<int>(state.poses.size()) - 1;
    for (int i = 0; i < bonds; ++i) mean.sum += bending_angle(chain, state.poses, i);
    mean.count += bonds;
  }
  return mean;
}

Mean turning_angles(FiberStates fibers) {
  Mean mean;
  for (const ChainState<3>& state : fibers) {
    const int last = static_cast<int>(state.poses.size()) - 1;
    for (int i = 1; i < last; ++i) mean.sum += turning_angle(state.poses, i);
    mean.count += std::max(0, last - 1);
  }
  return mean;
}

double quantile(std::vector<double>& values, double fraction) {
  if (values.empty()) throw InvalidInput("quantile of no values");
  if (!(fraction >= 0 && fraction <= 1)) {
    throw InvalidInput(fmt::format("fraction = {} is not allowed: it must be 0 to 1", fraction));
  }
  const double at = fraction * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(at);
  std::ranges::nth_element(values, below);
  const auto above = below + 1 == values.end() ? below : std::ranges::min_element(below + 1, values.end());
  return std::lerp(*below, *above, at - std::floor(at));
}

Heights heights(const PlacedSpheres& spheres, const V& up, double fraction) {
  if (spheres.position.empty()) throw InvalidInput("height of no spheres");
  std::vector<double> h;
  h.reserve(spheres.position.size());
  for (const V& x : spheres.position) h.push_back(dot(x, up));
  std::ranges::sort(h);
  double sum = 0;
  for (const double x : h) sum += x;
  return {h.back(), quantile(h, fraction), sum / static_cast<double>(h.size())};
}

double volume_below(double radius, double h) {
  const double t = std::clamp(h / radius, -1.0, 1.0);
  return pi * radius * radius * radius * (t + 1) * (t + 1) * (2 - t) / 3;
}

std::vector<double> solid_fractions(const PlacedSpheres& spheres, const V& up, double cross_section,
                                    const std::vector<double>& edges) {
  if (edges.size() < 2 || std::ranges::adjacent_find(edges, std::greater_equal{}) != edges.end()) {
    throw InvalidInput("edges of slabs must rise, and be two at least");
  }
  if (!(cross_section > 0)) {
    throw InvalidInput(
        fmt::format("cross section = {} m^2 is not allowed: it must be above 0", cross_section));
  }
  std::vector<double> volume(edges.size() - 1);
  for (std::size_t i = 0; i < spheres.position.size(); ++i) {
    const double center = dot(spheres.position[i], up), R = spheres.radius[i];
    // from the slab that holds its lowest point
    const auto above = std::ranges::upper_bound(edges, center - R);
    std::size_t slab = above == edges.begin() ? 0 : static_cast<std::size_t>(above - edges.begin()) - 1;
    for (; slab < volume.size() && edges[slab] < center + R; ++slab) {
      volume[slab] += volume_below(R, edges[slab + 1] - center) - volume_below(R, edges[slab] - center);
    }
  }
  for (std::size_t k = 0; k < volume.size(); ++k) volume[k] /= cross_section * (edges[k + 1] - edges[k]);
  return volume;
}

Coordination coordination(std::span<const ContactState> contacts, std::span<const std::int32_t> fiber_of) {
  Coordination c;
  std::vector<char> touches(fiber_of.size());
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  const auto spheres = static_cast<std::int64_t>(fiber_of.size());
  for (const ContactState& contact : contacts) {
    const Primitive &first = contact.key.first, &second = contact.key.second;
    if (!is_of_fiber(first) || std::max(first.number, second.number) >= spheres) {
      throw InvalidInput(fmt::format("contact of spheres {} and {}: there are {}", to_number(first),
                                     to_number(second), spheres));
    }
    if (is_facet(second)) {
      ++c.with_walls;
      continue;
    }
    const auto i = static_cast<std::size_t>(first.number), j = static_cast<std::size_t>(second.number);
    touches[i] = touches[j] = 1;
    if (fiber_of[i] == fiber_of[j]) {
      ++c.within_fibers;
    } else {
      ++c.between_fibers;
      pairs.push_back(std::minmax(fiber_of[i], fiber_of[j]));
    }
  }
  if (spheres == 0) return c;
  const double fibers = 1.0 + *std::ranges::max_element(fiber_of), n = static_cast<double>(spheres);
  c.per_sphere = 2 * static_cast<double>(c.between_fibers + c.within_fibers) / n;
  c.per_fiber = 2 * static_cast<double>(c.between_fibers) / fibers;
  c.neighbors_per_fiber = 2 * static_cast<double>(distinct(pairs)) / fibers;
  c.touching_spheres = static_cast<double>(std::ranges::count(touches, 1)) / n;
  return c;
}

std::vector<std::int32_t> fiber_numbers(const std::vector<FiberGroup>& groups) {
  std::vector<std::int32_t> numbers;
  std::int32_t fiber = 0;
  for (const FiberGroup& group : groups) {
    for (const ChainState<3>& state : group.fibers)
      numbers.insert(numbers.end(), state.poses.size(), fiber++);
  }
  return numbers;
}

Orientations::Orientations(const V& up, int classes)
    : up_(up), classes_(static_cast<std::size_t>(std::max(classes, 1))) {}

void Orientations::add(FiberStates fibers) {
  const auto classes = static_cast<double>(classes_.size());
  for (const ChainState<3>& state : fibers) {
    for (std::size_t i = 0; i + 1 < state.poses.size(); ++i) {
      const V r = state.poses[i + 1].position - state.poses[i].position, u = (1 / norm(r)) * r;
      const double full = angle_between(u, up_), angle = std::min(full, pi - full);
      ++classes_[static_cast<std::size_t>(std::min(angle / (pi / 2) * classes, classes - 1))];
      angles_ += angle;
      const double products[6] = {u[0] * u[0], u[1] * u[1], u[2] * u[2],
                                  u[0] * u[1], u[0] * u[2], u[1] * u[2]};
      for (std::size_t k = 0; k < 6; ++k) moments_[k] += products[k];
      ++bonds_;
    }
  }
}

std::array<std::array<double, 3>, 3> Orientations::second_moment() const {
  const double n = static_cast<double>(std::max<std::int64_t>(bonds_, 1));
  const auto& m = moments_;
  return {{{m[0] / n, m[3] / n, m[4] / n}, {m[3] / n, m[1] / n, m[5] / n}, {m[4] / n, m[5] / n, m[2] / n}}};
}

std::array<double, 3> Orientations::principal() const {
  const auto a = second_moment();
  Eigen::Matrix3d A;
  A << a[0][0], a[0][1], a[0][2], a[1][0], a[1][1], a[1][2], a[2][0], a[2][1], a[2][2];
  const Eigen::Vector3d rising =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A, Eigen::EigenvaluesOnly).eigenvalues();
  return {rising[2], rising[1], rising[0]};
}

double Orientations::order() const { return (3 * principal()[0] - 1) / 2; }

double Orientations::order_along_up() const {
  const auto a = second_moment();
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) square += a[i][j] * up_[i] * up_[j];
  }
  return (3 * square - 1) / 2;
}

double Orientations::mean_polar_angle() const {
  return angles_ / static_cast<double>(std::max<std::int64_t>(bonds_, 1));
}

std::vector<double> Orientations::against_isotropic() const {
  std::vector<double> ratio;
  const double width = pi / 2 / static_cast<double>(classes_.size());
  for (std::size_t k = 0; k < classes_.size(); ++k) {
    const double low = width * static_cast<double>(k), share = std::cos(low) - std::cos(low + width);
    ratio.push_back(static_cast<double>(classes_[k]) /
                    static_cast<double>(std::max<std::int64_t>(bonds_, 1)) / share);
  }
  return ratio;
}

KineticEnergy kinetic_energy(const Fiber& fiber, FiberStates fibers) {
  const double m = sphere_mass(fiber), J = sphere_inertia(fiber);
  KineticEnergy energy;
  for (const ChainState<3>& state : fibers) {
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
      const double share = mass_share(fiber, static_cast<int>(i));
      energy.translation += 0.5 * share * m * dot(state.velocity[i], state.velocity[i]);
      energy.rotation += 0.5 * share * J * dot(state.spin[i], state.spin[i]);
    }
  }
  return energy;
}

}  // namespace fiberchain::dem
