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
                                                  std::align_val_t{lane_alignment}))),
      size_(size) {
  std::fill_n(data_.get(), size, 0.0);
}

template <int Dim>
MarchingBlock<Dim>::MarchingBlock(const std::vector<Chain<Dim>>& chains, Clamps clamps,
                                  const std::vector<double>& steps, const std::vector<double>& drag,
                                  const Physics& physics, InstructionSet set)
    : kernel_(lane_kernel(physics, set)), lanes_(static_cast<int>(chains.size())), clamps_(clamps) {
  check_chains(chains, kernel_.width);
  bonds_ = chains[0].fiber.aspect_ratio;
  along_ = lanes_ == 1 && kernel_.march_along != nullptr && bonds_ >= kernel_.width;
  const std::size_t width = kernel_.width, column = along_ ? bonds_ + 2 : width * (bonds_ + 1);
  spheres_ = LaneArray(column * numbers<MovingSphere<double, Dim>>);
  history_ = LaneArray(column * numbers<BondHistory<double, Dim>>);
  workspace_ = LaneArray(kernel_.workspace(bonds_) * width);
  loads_ = LaneArray(along_ ? column * numbers<BondLoads<double, Dim>> : 0);
  mobile_ = LaneArray(bonds_ + 1);
  for (int i = 0; i <= bonds_; ++i) mobile_.put(fixed(i) ? 0.0 : 1.0, i, 1);
  natural_ = LaneArray(chains[0].natural.size() * numbers<NaturalEnds<double, Dim>> * width);
  parameters_ = LaneArray(numbers<MarchParameters<double, Dim>> * width);
  for (int lane = 0; lane < (along_ ? 1 : kernel_.width); ++lane) {
    const int used = std::min(lane, lanes_ - 1);
    const Chain<Dim>& chain = chains[used];
    MarchParameters<double, Dim> p{};
    p.bond = bond_parameters(chain.fiber);
    p.inverse_length = 1 / bond_length(chain.fiber);
    p.impulse = steps[used] / sphere_mass(chain.fiber);
    p.angular_impulse = steps[used] / sphere_inertia(chain.fiber);
    p.step = steps[used];
    p.drag = drag[used];
    p.rolling_arm = chain.fiber.rolling_friction * sphere_radius(chain.fiber) / 2;
    p.ramp.rate = 1;
    parameters_of_.push_back(p);
    parameters_.put(p, lane, kernel_.width);
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> sphere{};
      sphere.pose = chain.poses[i];
      set_sphere(lane, i, sphere);
    }
    for (std::size_t i = 0; i < chain.natural.size(); ++i) {
      natural_.put(chain.natural[i], place(lane, static_cast<int>(i), numbers<NaturalEnds<double, Dim>>), stride());
    }
  }
  if (along_) {  // the parameters are a whole vector in every mode
    for (int lane = 1; lane < kernel_.width; ++lane) parameters_.put(parameters_of_[0], lane, kernel_.width);
  }
  start();
}

template <int Dim>
void MarchingBlock<Dim>::start() {
  along_ ? kernel_.start_along(view()) : kernel_.start(view());
}

template <int Dim>
LaneBlock MarchingBlock<Dim>::view() {
  return {bonds_, clamps_, spheres_.data(), history_.data(), natural_.data(), parameters_.data(),
          static_cast<int>(stride()), mobile_.data(), workspace_.data(), loads_.data()};
}

template <int Dim>
void MarchingBlock<Dim>::set_ramp(int lane, const Boundary<Dim>& from, const Boundary<Dim>& to, double ramp_steps) {
  MarchParameters<double, Dim>& p = parameters_of_[lane];
  p.ramp = {load_at(from, 0), load_at(to, 0), load_at(from, bonds_), load_at(to, bonds_), 1 / std::max(ramp_steps, 1.0)};
  parameters_.put(p, lane, kernel_.width);
  if (lane == lanes_ - 1) {
    for (int unused = lanes_; unused < kernel_.width; ++unused) parameters_.put(p, unused, kernel_.width);
  }
}

template <int Dim>
void MarchingBlock<Dim>::march(int steps) {
  (along_ ? kernel_.march_along : kernel_.march)(view(), steps_on_ramp_, steps);
  steps_on_ramp_ += steps;
}

template <int Dim>
MovingSphere<double, Dim> MarchingBlock<Dim>::sphere(int lane, int index) const {
  MovingSphere<double, Dim> sphere{};
  spheres_.get(sphere, place(lane, index, numbers<MovingSphere<double, Dim>>), stride());
  return sphere;
}

template <int Dim>
void MarchingBlock<Dim>::set_sphere(int lane, int index, const MovingSphere<double, Dim>& sphere) {
  MovingSphere<double, Dim> placed = sphere;
  if (fixed(index)) placed.velocity = {}, placed.spin = {};
  spheres_.put(placed, place(lane, index, numbers<MovingSphere<double, Dim>>), stride());
}

template <int Dim>
BondHistory<double, Dim> MarchingBlock<Dim>::history(int lane, int bond) const {
  BondHistory<double, Dim> history{};
  history_.get(history, place(lane, bond, numbers<BondHistory<double, Dim>>), stride());
  return history;
}

template <int Dim>
void MarchingBlock<Dim>::set_history(int lane, int bond, const BondHistory<double, Dim>& history) {
  history_.put(history, place(lane, bond, numbers<BondHistory<double, Dim>>), stride());
}

template <int Dim>
void MarchingBlock<Dim>::synchronize() {
  start();
  for (int lane = 0; lane < (along_ ? 1 : kernel_.width); ++lane) {
    const MarchParameters<double, Dim>& p = parameters_of_[lane];
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> s = sphere(lane, i);
      if (i == 0) s.force = s.force + p.ramp.first_from.force, s.moment = s.moment + p.ramp.first_from.moment;
      if (i == bonds_) s.force = s.force + p.ramp.last_from.force, s.moment = s.moment + p.ramp.last_from.moment;
      const MovingSphere<double, Dim> now = sphere(lane, i);
      s.velocity = s.velocity - (0.5 * p.impulse) * s.force;
      s.spin = s.spin - (0.5 * p.angular_impulse) * s.moment;
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

template <int Dim>
std::vector<double> MarchingBlock<Dim>::saved() const {
  std::vector<double> all{steps_on_ramp_};
  for (const LaneArray* a : {&spheres_, &history_, &workspace_}) all.insert(all.end(), a->data(), a->data() + a->size());
  return all;
}

template <int Dim>
void MarchingBlock<Dim>::restore(const std::vector<double>& saved) {
  steps_on_ramp_ = saved[0];
  const double* from = saved.data() + 1;
  for (LaneArray* a : {&spheres_, &history_, &workspace_}) {
    std::copy_n(from, a->size(), a->data());
    from += a->size();
  }
}

template class MarchingBlock<2>;
template class MarchingBlock<3>;

}  // namespace fiberchain::dem
