#include "dem/motion/lanes/block.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

template <class Value>
constexpr std::size_t numbers = sizeof(Value) / sizeof(double);

template <int Dim>
EndLoad<double, Dim> load_at(const Boundary<Dim>& boundary, int sphere) {
  EndLoad<double, Dim> sum{};
  for (const Load<Dim>& load : boundary.loads) {
    if (load.sphere == sphere) sum = {sum.force + load.force, sum.moment + load.moment};
  }
  return sum;
}

template <int Dim>
void check_chains(const std::vector<Chain<Dim>>& chains, int width) {
  if (chains.empty() || static_cast<int>(chains.size()) > width) {
    throw InvalidInput(fmt::format("chains = {} is not allowed: a block takes 1 to {}", chains.size(), width));
  }
  for (const Chain<Dim>& chain : chains) {
    if (chain.fiber.aspect_ratio != chains[0].fiber.aspect_ratio || chain.natural.empty() != chains[0].natural.empty()) {
      throw InvalidInput("chains side by side must have the same aspect ratio and all be straight at rest or none");
    }
  }
}

}  // namespace

LaneArray::LaneArray(std::size_t size)
    : data_(static_cast<double*>(::operator new[](std::max<std::size_t>(size, 1) * sizeof(double),
                                                  std::align_val_t{lane_alignment}))) {
  std::fill_n(data_.get(), size, 0.0);
}

template <int Dim>
MarchingBlock<Dim>::MarchingBlock(const std::vector<Chain<Dim>>& chains, Clamps clamps,
                                  const std::vector<double>& steps, const std::vector<double>& drag,
                                  const Physics& physics, InstructionSet set)
    : kernel_(lane_kernel(physics, set)), lanes_(static_cast<int>(chains.size())), clamps_(clamps) {
  check_chains(chains, kernel_.width);
  bonds_ = chains[0].fiber.aspect_ratio;
  const std::size_t width = kernel_.width;
  spheres_ = LaneArray((bonds_ + 1) * numbers<MovingSphere<double, Dim>> * width);
  history_ = LaneArray(bonds_ * numbers<BondHistory<double, Dim>> * width);
  natural_ = LaneArray(chains[0].natural.size() * numbers<NaturalEnds<double, Dim>> * width);
  parameters_ = LaneArray(numbers<MarchParameters<double, Dim>> * width);
  for (int lane = 0; lane < kernel_.width; ++lane) {
    const int used = std::min(lane, lanes_ - 1);
    const Chain<Dim>& chain = chains[used];
    MarchParameters<double, Dim> p{};
    p.bond = bond_parameters(chain.fiber);
    p.inverse_mass = 1 / sphere_mass(chain.fiber);
    p.inverse_inertia = 1 / sphere_inertia(chain.fiber);
    p.step = steps[used];
    p.drag = drag[used];
    p.ramp.rate = 1;
    parameters_of_.push_back(p);
    parameters_.put(p, 0, lane, kernel_.width);
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> sphere{};
      sphere.pose = chain.poses[i];
      set_sphere(lane, i, sphere);
    }
    for (std::size_t i = 0; i < chain.natural.size(); ++i) {
      natural_.put(chain.natural[i], i * numbers<NaturalEnds<double, Dim>>, lane, kernel_.width);
    }
  }
  kernel_.start(view());
}

template <int Dim>
LaneBlock MarchingBlock<Dim>::view() {
  return {bonds_, clamps_, spheres_.data(), history_.data(), natural_.data(), parameters_.data()};
}

template <int Dim>
void MarchingBlock<Dim>::set_ramp(int lane, const Boundary<Dim>& from, const Boundary<Dim>& to, double ramp_steps) {
  MarchParameters<double, Dim>& p = parameters_of_[lane];
  p.ramp = {load_at(from, 0), load_at(to, 0), load_at(from, bonds_), load_at(to, bonds_), 1 / std::max(ramp_steps, 1.0)};
  parameters_.put(p, 0, lane, kernel_.width);
  if (lane == lanes_ - 1) {
    for (int unused = lanes_; unused < kernel_.width; ++unused) parameters_.put(p, 0, unused, kernel_.width);
  }
}

template <int Dim>
void MarchingBlock<Dim>::march(int steps) {
  kernel_.march(view(), steps_on_ramp_, steps);
  steps_on_ramp_ += steps;
}

template <int Dim>
MovingSphere<double, Dim> MarchingBlock<Dim>::sphere(int lane, int index) const {
  MovingSphere<double, Dim> sphere{};
  spheres_.get(sphere, index * numbers<MovingSphere<double, Dim>>, lane, kernel_.width);
  return sphere;
}

template <int Dim>
void MarchingBlock<Dim>::set_sphere(int lane, int index, const MovingSphere<double, Dim>& sphere) {
  MovingSphere<double, Dim> placed = sphere;
  const bool fixed = (index == 0 && clamps_.first) || (index == bonds_ && clamps_.last);
  if (fixed) placed.velocity = {}, placed.spin = {};
  spheres_.put(placed, index * numbers<MovingSphere<double, Dim>>, lane, kernel_.width);
}

template <int Dim>
BondHistory<double, Dim> MarchingBlock<Dim>::history(int lane, int bond) const {
  BondHistory<double, Dim> history{};
  history_.get(history, bond * numbers<BondHistory<double, Dim>>, lane, kernel_.width);
  return history;
}

template <int Dim>
void MarchingBlock<Dim>::set_history(int lane, int bond, const BondHistory<double, Dim>& history) {
  history_.put(history, bond * numbers<BondHistory<double, Dim>>, lane, kernel_.width);
}

template <int Dim>
void MarchingBlock<Dim>::synchronize() {
  kernel_.start(view());
  for (int lane = 0; lane < kernel_.width; ++lane) {
    const MarchParameters<double, Dim>& p = parameters_of_[lane];
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> s = sphere(lane, i);
      if (i == 0) s.force = s.force + p.ramp.first_from.force, s.moment = s.moment + p.ramp.first_from.moment;
      if (i == bonds_) s.force = s.force + p.ramp.last_from.force, s.moment = s.moment + p.ramp.last_from.moment;
      const MovingSphere<double, Dim> now = sphere(lane, i);
      s.velocity = s.velocity - (0.5 * p.step * p.inverse_mass) * s.force;
      s.spin = s.spin - (0.5 * p.step * p.inverse_inertia) * s.moment;
      s.force = now.force;
      s.moment = now.moment;
      set_sphere(lane, i, s);
    }
  }
}

template <int Dim>
Poses<Dim> MarchingBlock<Dim>::poses(int lane) const {
  Poses<Dim> poses;
  for (int i = 0; i <= bonds_; ++i) poses.push_back(sphere(lane, i).pose);
  return poses;
}

template class MarchingBlock<2>;
template class MarchingBlock<3>;

}  // namespace fiberchain::dem
