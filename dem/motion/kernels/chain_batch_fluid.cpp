#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/motion/half_step.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/leapfrog.hpp"

// What a fluid does to a block of lanes, and the half steps between velocities and poses.
namespace fiberchain::dem {
template <int Dim>
void ChainBatch<Dim>::set_fluid(int lane, const Fluid& fluid, double time) {
  if (!fluid_) throw InvalidInput("a fluid is not allowed: the physics of these lanes has none");
  if (fluid.hydrodynamics != Hydrodynamics::free_draining) {
    throw InvalidInput(
        fmt::format("hydrodynamics = {} is not allowed: chains that march explicitly are free draining",
                    name(fluid.hydrodynamics)));
  }
  check<Dim>(fluid);
  fluids_[lane] = {stokes_drag(fluid, fibers_[lane]), fluid.flow, time, steps_in_fluid_};
  dem::set_step(parameters_of_[lane], fibers_[lane], fluids_[lane].drag, parameters_of_[lane].step);
  put_parameters(lane);
  steady_ =
      std::ranges::none_of(fluids_, [](const LaneFluid& f) { return static_cast<bool>(f.flow.at_time); });
  if (steady_) fill_gradients(1);
}

template <int Dim>
void ChainBatch<Dim>::set_loads(int lane, const Boundary<Dim>& boundary) {
  if (!fluid_)
    throw InvalidInput("loads on every sphere are not allowed: the physics of these lanes has no fluid");
  std::vector<EndLoad<double, Dim>> loads(bonds_ + 1, EndLoad<double, Dim>{});
  for (const Load<Dim>& load : boundary.loads) {
    if (load.sphere < 0 || load.sphere > bonds_) {
      throw InvalidInput(fmt::format("load at sphere {} is not allowed: the chain has spheres 0 to {}",
                                     load.sphere, bonds_));
    }
    EndLoad<double, Dim>& sum = loads[load.sphere];
    sum = {sum.force + load.force, sum.moment + load.moment};
  }
  for (int copy = lane; copy < (along_ ? 1 : kernel_.width); ++copy) {
    if (used(copy) != lane) continue;
    for (int i = 0; i <= bonds_; ++i)
      dead_.put(loads[i], place(copy, i, numbers_of<EndLoad<double, Dim>>), stride());
  }
  loaded_ = loaded_ || !boundary.loads.empty();
}

template <int Dim>
void ChainBatch<Dim>::set_step(int lane, double step) {
  std::vector<MovingSphere<double, Dim>> now = spheres_now(lane);
  LaneFluid& fluid = fluids_[lane];
  MarchParameters<double, Dim>& p = parameters_of_[lane];
  fluid.time += (steps_in_fluid_ - fluid.step) * p.step;
  fluid.step = steps_in_fluid_;
  dem::set_step(p, fibers_[lane], fluid.drag, step);
  put_parameters(lane);
  for (int copy = lane; copy < kernel_.width; ++copy) {
    if (used(copy) == lane) put_branches(copy, step);
  }
  for (int i = 0; i <= bonds_; ++i) {
    if (kernel_.half_kick == nullptr) move_half_step(lane, i, now[i], true);
    set_sphere(lane, i, now[i]);
  }
  if (kernel_.half_kick == nullptr) return;
  start();  // dashpots at the velocities of this moment
  const LaneArray back = half_kicked(true);
  for (int i = 0; i <= bonds_; ++i)
    set_sphere(lane, i, with_velocities(sphere(lane, i), sphere_in(back, lane, i)));
}

template <int Dim>
Gradient ChainBatch<Dim>::gradient_now(int lane, int steps_ahead) const {
  const LaneFluid& fluid = fluids_[lane];
  return gradient_at(fluid.flow,
                     fluid.time + (steps_in_fluid_ + steps_ahead - fluid.step) * parameters_of_[lane].step);
}

template <int Dim>
void ChainBatch<Dim>::fill_gradients(int steps) {
  constexpr std::size_t size = Dim * Dim;
  const std::size_t width = kernel_.width;
  for (int n = 0; n < steps; ++n) {
    Gradient A{};
    for (std::size_t lane = 0; lane < width; ++lane) {
      if (static_cast<int>(lane) < lanes_) A = gradient_now(static_cast<int>(lane), n);
      for (int c = 0; c < Dim * Dim; ++c)
        gradients_.data()[(n * size + c) * width + lane] = A[c / Dim][c % Dim];
    }
  }
}

template <int Dim>
EndLoad<double, Dim> ChainBatch<Dim>::load_now(int lane, int index) const {
  EndLoad<double, Dim> load{};
  if (fluid_) dead_.get(load, place(lane, index, numbers_of<EndLoad<double, Dim>>), stride());
  const LoadRamp<double, Dim>& ramp = parameters_of_[lane].ramp;
  const double factor = ramp_factor(ramp.rate, steps_on_ramp_);
  const auto add = [&](const EndLoad<double, Dim>& more) {
    load = {load.force + more.force, load.moment + more.moment};
  };
  if (index == 0) add(blend(ramp.first_from, ramp.first_to, factor));
  if (index == bonds_) add(blend(ramp.last_from, ramp.last_to, factor));
  return load;
}

template <int Dim>
void ChainBatch<Dim>::move_half_step(int lane, int index, MovingSphere<double, Dim>& s, bool back) const {
  if (fixed(index)) return;
  const EndLoad<double, Dim> load = load_now(lane, index);
  dem::move_half_step(s, index, load, fibers_[lane], fluids_[lane].drag, gradient_now(lane, 0),
                      parameters_of_[lane].step, back);
}

template <int Dim>
std::vector<MovingSphere<double, Dim>> ChainBatch<Dim>::spheres_now(int lane) const {
  std::vector<MovingSphere<double, Dim>> now;
  for (int i = 0; i <= bonds_; ++i) now.push_back(sphere(lane, i));
  if (kernel_.half_kick != nullptr) {
    const LaneArray kicked = half_kicked(false);
    for (int i = 0; i <= bonds_; ++i) now[i] = with_velocities(now[i], sphere_in(kicked, lane, i));
  } else {
    for (int i = 0; i <= bonds_; ++i) move_half_step(lane, i, now[i], false);
  }
  return now;
}

#define FIBERCHAIN_INSTANTIATE(Dim)                                                                \
  template void ChainBatch<Dim>::set_fluid(int, const Fluid&, double);                             \
  template void ChainBatch<Dim>::set_loads(int, const Boundary<Dim>&);                             \
  template void ChainBatch<Dim>::set_step(int, double);                                            \
  template Gradient ChainBatch<Dim>::gradient_now(int, int) const;                                 \
  template void ChainBatch<Dim>::fill_gradients(int);                                              \
  template EndLoad<double, Dim> ChainBatch<Dim>::load_now(int, int) const;                         \
  template void ChainBatch<Dim>::move_half_step(int, int, MovingSphere<double, Dim>&, bool) const; \
  template std::vector<MovingSphere<double, Dim>> ChainBatch<Dim>::spheres_now(int) const;
FIBERCHAIN_INSTANTIATE(2)
FIBERCHAIN_INSTANTIATE(3)
#undef FIBERCHAIN_INSTANTIATE

}  // namespace fiberchain::dem
