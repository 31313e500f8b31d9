#include "dem/motion/kernels/chain_batch.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "dem/bond/branch_steps.hpp"
#include "dem/chain/chain_bond.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/relaxation.hpp"

namespace fiberchain::dem {
namespace {

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
    throw InvalidInput(
        fmt::format("chains = {} is not allowed: a block takes 1 to {}", chains.size(), width));
  }
  for (const Chain<Dim>& chain : chains) {
    if (chain.fiber.aspect_ratio != chains[0].fiber.aspect_ratio ||
        chain.natural.empty() != chains[0].natural.empty()) {
      throw InvalidInput(
          "chains side by side must have the same aspect ratio and all be straight at rest or none");
    }
  }
}

/// Steps whose gradients are made together where the flow changes.
constexpr int steps_a_chunk = 64;

}  // namespace

template <int Dim>
ChainBatch<Dim>::ChainBatch(const std::vector<Chain<Dim>>& chains, Clamps clamps,
                            const std::vector<double>& steps, const std::vector<double>& drag,
                            const Physics& physics, InstructionSet set)
    : kernel_(chain_kernel(physics, set)),
      form_(physics.form),
      lanes_(static_cast<int>(chains.size())),
      viscoelastic_(physics.branches),
      clamps_(clamps),
      fluid_(physics.fluid) {
  check_chains(chains, kernel_.width);
  bonds_ = chains[0].fiber.aspect_ratio;
  // along the lanes a fluid takes all spheres to be equally heavy
  const bool even = !fluid_ || end_mass_share(chains[0].fiber) == 1;
  along_ = lanes_ == 1 && even && kernel_.march_single_chain != nullptr && bonds_ >= kernel_.width;
  const std::size_t width = kernel_.width, column = along_ ? bonds_ + 2 : width * (bonds_ + 1);
  spheres_ = LaneArray(column * numbers_of<MovingSphere<double, Dim>>);
  start_memory(chains[0].fiber);
  history_ = LaneArray(column * memory_.bond);
  workspace_ = LaneArray(kernel_.workspace(bonds_) * width);
  dead_ = LaneArray(fluid_ ? column * numbers_of<EndLoad<double, Dim>> : 0);
  gradients_ = LaneArray(fluid_ ? steps_a_chunk * Dim * Dim * width : 0);
  fluids_.resize(chains.size());
  for (const Chain<Dim>& chain : chains) fibers_.push_back(chain.fiber);
  loads_ = LaneArray(along_ ? column * numbers_of<BondLoads<double, Dim>> : 0);
  mobile_ = LaneArray(bonds_ + 1);
  for (int i = 0; i <= bonds_; ++i) mobile_.put(fixed(i) ? 0.0 : 1 / mass_share(chains[0].fiber, i), i, 1);
  natural_ = LaneArray(chains[0].natural.size() * numbers_of<NaturalEnds<double, Dim>> * width);
  parameters_ = LaneArray(numbers_of<MarchParameters<double, Dim>> * width);
  for (int lane = 0; lane < (along_ ? 1 : kernel_.width); ++lane) {
    const Chain<Dim>& chain = chains[used(lane)];
    MarchParameters<double, Dim> p = march_parameters<Dim>(chain.fiber, {}, steps[used(lane)]);
    p.drag = drag[used(lane)];
    p.ramp.rate = 1;
    parameters_of_.push_back(p);
    parameters_.put(p, lane, kernel_.width);
    put_branches(lane, p.step);
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> sphere{};
      sphere.pose = chain.poses[i];
      set_sphere(lane, i, sphere);
    }
    if (viscoelastic_) start_histories(lane, chain, at_rest<Dim>(chain.poses));
    for (std::size_t i = 0; i < chain.natural.size(); ++i) {
      natural_.put(chain.natural[i], place(lane, static_cast<int>(i), numbers_of<NaturalEnds<double, Dim>>),
                   stride());
    }
  }
  if (along_) {  // the parameters are a whole vector in every mode
    for (int lane = 1; lane < kernel_.width; ++lane) parameters_.put(parameters_of_[0], lane, kernel_.width);
  }
  start();
}

template <int Dim>
void ChainBatch<Dim>::start_memory(const Fiber& fiber) {
  memory_.bond = kernel_.history;
  if (!viscoelastic_) return;
  const BranchSteps own = branch_steps(fiber, 0, Dim);
  branches_ = LaneArray(own.steps.size() * numbers_of<BranchStep<double>> * kernel_.width);
  memory_ = memory_view<Dim>(own, branches_.data(), form_, kernel_.history);
}

template <int Dim>
void ChainBatch<Dim>::put_branches(int lane, double step) {
  if (!viscoelastic_) return;
  const BranchSteps own = branch_steps(fibers_[used(lane)], step, Dim);
  if (memory_view<Dim>(own, branches_.data(), form_, kernel_.history) != memory_) {
    throw InvalidInput("chains side by side must have the same numbers of Maxwell branches");
  }
  const std::size_t width = kernel_.width, size = numbers_of<BranchStep<double>>;
  for (std::size_t j = 0; j < own.steps.size(); ++j)
    branches_.put(own.steps[j], j * size * width + lane, width);
}

template <int Dim>
void ChainBatch<Dim>::start() {
  along_ ? kernel_.start_single_chain(view()) : kernel_.start(view());
}

template <int Dim>
ChainBatchView ChainBatch<Dim>::view() {
  return {.bonds = bonds_,
          .clamps = clamps_,
          .spheres = spheres_.data(),
          .history = history_.data(),
          .natural = natural_.data(),
          .parameters = parameters_.data(),
          .stride = static_cast<int>(stride()),
          .mobile = mobile_.data(),
          .workspace = workspace_.data(),
          .loads = loads_.data(),
          .dead = loaded_ ? dead_.data() : nullptr,
          .gradients = gradients_.data(),
          .gradient_stride = steady_ ? 0 : Dim * Dim * kernel_.width,
          .memory = memory_};
}

template <int Dim>
void ChainBatch<Dim>::set_ramp(int lane, const Boundary<Dim>& from, const Boundary<Dim>& to,
                               double ramp_steps) {
  MarchParameters<double, Dim>& p = parameters_of_[lane];
  p.ramp = {load_at(from, 0), load_at(to, 0), load_at(from, bonds_), load_at(to, bonds_),
            1 / std::max(ramp_steps, 1.0)};
  put_parameters(lane);
}

template <int Dim>
void ChainBatch<Dim>::put_parameters(int lane) {
  for (int copy = lane; copy < kernel_.width; ++copy) {
    if (used(copy) == lane) parameters_.put(parameters_of_[lane], copy, kernel_.width);
  }
}

template <int Dim>
void ChainBatch<Dim>::march(int steps) {
  for (int done = 0; done < steps;) {
    const int now = steady_ ? steps - done : std::min(steps - done, steps_a_chunk);
    if (!steady_) fill_gradients(now);
    (along_ ? kernel_.march_single_chain : kernel_.march)(view(), steps_on_ramp_, now);
    steps_on_ramp_ += now;
    steps_in_fluid_ += now;
    done += now;
  }
}

template <int Dim>
MovingSphere<double, Dim> ChainBatch<Dim>::sphere_in(const LaneArray& spheres, int lane, int index) const {
  MovingSphere<double, Dim> sphere{};
  spheres.get(sphere, place(lane, index, numbers_of<MovingSphere<double, Dim>>), stride());
  return sphere;
}

template <int Dim>
void ChainBatch<Dim>::set_sphere(int lane, int index, const MovingSphere<double, Dim>& sphere) {
  MovingSphere<double, Dim> placed = sphere;
  if (fixed(index)) placed.velocity = {}, placed.spin = {};
  spheres_.put(placed, place(lane, index, numbers_of<MovingSphere<double, Dim>>), stride());
}

template <int Dim>
BondHistory<double, Dim> ChainBatch<Dim>::history(int lane, int bond) const {
  BondHistory<double, Dim> history{};
  if (form_ != BondForm::incremental) return history;
  if (!viscoelastic_) {
    history_.get(history, place(lane, bond, memory_.bond), stride());
    return history;
  }
  BondFrameHistory<double, Dim> own{};
  history_.get(own, place(lane, bond, memory_.bond), stride());
  return out_of_frame(own, unit(sphere(lane, bond + 1).pose.position - sphere(lane, bond).pose.position));
}

template <int Dim>
void ChainBatch<Dim>::set_history(int lane, int bond, const BondHistory<double, Dim>& history) {
  if (form_ != BondForm::incremental) return;
  if (!viscoelastic_) {
    history_.put(history, place(lane, bond, memory_.bond), stride());
  } else {
    const auto e = unit(sphere(lane, bond + 1).pose.position - sphere(lane, bond).pose.position);
    history_.put(in_frame(history, e), place(lane, bond, memory_.bond), stride());
  }
}

template <int Dim>
void ChainBatch<Dim>::start_histories(int lane, const Chain<Dim>& chain, const ChainState<Dim>& state) {
  with_bond_form(form_, [&]<BondForm form>() {
    for (int i = 0; i < bonds_; ++i) {
      set_bond_numbers(lane, i, std::vector<double>(memory_.bond, 0.0));
      const std::size_t first = place(lane, i, memory_.bond);
      if (viscoelastic_) {
        history_.put(start_history<ViscoelasticBond<BondLawType<form>>>(chain, state, i), first, stride());
      } else {
        history_.put(start_history<BondLawType<form>>(chain, state, i), first, stride());
      }
    }
  });
}

template <int Dim>
std::vector<double> ChainBatch<Dim>::bond_numbers(int lane, int bond) const {
  std::vector<double> numbers(memory_.bond);
  const double* first = history_.data() + place(lane, bond, memory_.bond);
  for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] = first[n * stride()];
  return numbers;
}

template <int Dim>
void ChainBatch<Dim>::set_bond_numbers(int lane, int bond, const std::vector<double>& numbers) {
  double* first = history_.data() + place(lane, bond, memory_.bond);
  for (std::size_t n = 0; n < numbers.size(); ++n) first[n * stride()] = numbers[n];
}

template <int Dim>
LaneArray ChainBatch<Dim>::half_kicked(bool back) const {
  LaneArray moved = spheres_.copy();
  auto* own = const_cast<ChainBatch*>(this);  // writes what each march writes anew, and the copy
  if (!steady_) own->fill_gradients(1);
  ChainBatchView kicked = own->view();
  kicked.spheres = moved.data();
  kernel_.half_kick(kicked, steps_on_ramp_, back);
  return moved;
}

template <int Dim>
void ChainBatch<Dim>::synchronize() {
  start();
  if (kernel_.half_kick != nullptr) {
    const LaneArray back = half_kicked(true);
    for (int lane = 0; lane < kernel_.width; ++lane) {
      for (int i = 0; i <= bonds_; ++i) {
        set_sphere(lane, i, with_velocities(sphere(lane, i), sphere_in(back, lane, i)));
      }
    }
    return;
  }
  for (int lane = 0; lane < (along_ ? 1 : kernel_.width); ++lane) {
    for (int i = 0; i <= bonds_; ++i) {
      MovingSphere<double, Dim> s = sphere(lane, i);
      move_half_step(used(lane), i, s, true);
      set_sphere(lane, i, s);
    }
  }
}

template <int Dim>
Poses<Dim> ChainBatch<Dim>::poses(int lane) const {
  Poses<Dim> poses;
  for (int i = 0; i <= bonds_; ++i) poses.push_back(sphere(lane, i).pose);
  return poses;
}

template <int Dim>
std::vector<double> ChainBatch<Dim>::saved() const {
  std::vector<double> all{steps_on_ramp_, steps_in_fluid_};
  for (const LaneArray* a : {&spheres_, &history_, &workspace_})
    all.insert(all.end(), a->data(), a->data() + a->size());
  return all;
}

template <int Dim>
void ChainBatch<Dim>::restore(const std::vector<double>& saved) {
  steps_on_ramp_ = saved[0];
  steps_in_fluid_ = saved[1];
  const double* from = saved.data() + 2;
  for (LaneArray* a : {&spheres_, &history_, &workspace_}) {
    std::copy_n(from, a->size(), a->data());
    from += a->size();
  }
}

template class ChainBatch<2>;
template class ChainBatch<3>;

}  // namespace fiberchain::dem
