#include "dem/motion/kernels/chain_lane.hpp"

#include <cmath>

#include "dem/bond/branch_steps.hpp"

namespace fiberchain::dem {

bool blown_up(double length, double rest_length) {
  return !(length <= 10 * rest_length && length >= 0.1 * rest_length);
}

template <int Dim>
void put_state(ChainBatch<Dim>& block, int lane, const Chain<Dim>& chain, const ChainState<Dim>& state) {
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    MovingSphere<double, Dim> sphere = block.sphere(lane, static_cast<int>(i));
    sphere.pose = state.poses[i];
    sphere.velocity = state.velocity[i];
    sphere.spin = state.spin[i];
    block.set_sphere(lane, static_cast<int>(i), sphere);
  }
  block.start_histories(lane, chain, state);
}

namespace {

template <int Dim, class SphereAt>
ChainState<Dim> state_of(int spheres, const SphereAt& sphere_at) {
  ChainState<Dim> state;
  for (int i = 0; i < spheres; ++i) {
    const MovingSphere<double, Dim> s = sphere_at(i);
    state.poses.push_back(s.pose);
    state.velocity.push_back(s.velocity);
    state.spin.push_back(s.spin);
  }
  return state;
}

}  // namespace

template <int Dim>
ChainState<Dim> lagged_state(const ChainBatch<Dim>& block, int lane, int spheres) {
  return state_of<Dim>(spheres, [&](int i) { return block.sphere(lane, i); });
}

template <int Dim>
ChainState<Dim> state_now(const ChainBatch<Dim>& block, int lane, int spheres) {
  const auto now = block.spheres_now(lane);
  return state_of<Dim>(spheres, [&](int i) { return now[i]; });
}

template <int Dim>
double branch_energy(const ChainBatch<Dim>& block, int lane, const Chain<Dim>& chain, BondForm form) {
  if (chain.fiber.branches.empty()) return 0;
  const BranchSteps steps = branch_steps(chain.fiber, 0, Dim);
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  double sum = 0;
  with_bond_form(form, [&]<BondForm own>() {
    using Law = ViscoelasticBond<BondLawType<own>>;
    for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
      const std::vector<double> numbers = block.bond_numbers(lane, i);
      sum += branch_energy<Law::keeps_strain, Dim>(
          bond, steps.view(), numbers.data() + numbers_of<BondLawHistory<Law, double, Dim>>);
    }
  });
  return sum;
}

template <int Dim>
int broken_sphere(const ChainBatch<Dim>& block, int lane, const Fiber& fiber) {
  const double l = bond_length(fiber);
  Vec<double, Dim> before = block.sphere(lane, 0).pose.position;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const MovingSphere<double, Dim> s = block.sphere(lane, i);
    const double length = norm(s.pose.position - before);
    const bool finite = std::isfinite(length + dot(s.velocity, s.velocity) + dot(s.spin, s.spin));
    if (!finite || (i > 0 && blown_up(length, l))) return i;
    before = s.pose.position;
  }
  return -1;
}

#define FIBERCHAIN_INSTANTIATE(Dim)                                                               \
  template void put_state<Dim>(ChainBatch<Dim>&, int, const Chain<Dim>&, const ChainState<Dim>&); \
  template ChainState<Dim> lagged_state<Dim>(const ChainBatch<Dim>&, int, int);                   \
  template ChainState<Dim> state_now<Dim>(const ChainBatch<Dim>&, int, int);                      \
  template double branch_energy<Dim>(const ChainBatch<Dim>&, int, const Chain<Dim>&, BondForm);   \
  template int broken_sphere<Dim>(const ChainBatch<Dim>&, int, const Fiber&);
FIBERCHAIN_INSTANTIATE(2)
FIBERCHAIN_INSTANTIATE(3)
#undef FIBERCHAIN_INSTANTIATE

}  // namespace fiberchain::dem
