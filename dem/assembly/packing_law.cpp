#include "dem/assembly/packing_law.hpp"

#include "dem/bond/branch_steps.hpp"
#include "dem/bond/laws/failing_bond.hpp"
#include "dem/bond/laws/viscoelastic_bond.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

template <BondForm form>
constexpr PackingLaw library_law = packing_law_with<form>(packing_kernel);

/// A fiber's bonds with branches, one after the other, as they are in lanes.
template <BondForm form>
class ViscoelasticBonds {
 public:
  using Law = ViscoelasticBond<BondLawType<form>>;
  using History = BondLawHistory<Law, double, 3>;

  explicit ViscoelasticBonds(const Fiber& fiber)
      : branches_(branch_steps(fiber, 0, 3)), strains_(memory_view<3>(branches_, nullptr, form, 0).bond) {}

  /// Numbers of a bond.
  std::size_t size() const { return numbers_of<History> + strains_.size(); }

  /// Reads a bond: its history and the strains of its branches.
  void read(const double* numbers, std::size_t stride) {
    history_ = get_strided<History>(numbers, stride);
    for (std::size_t n = 0; n < strains_.size(); ++n)
      strains_[n] = numbers[(numbers_of<History> + n) * stride];
  }

  double energy(const BondParameters<double>& law, const BondConfiguration<double, 3>& now) const {
    return Law::stored_energy(law, history_, now) +
           branch_energy<Law::keeps_strain, 3>(law, branches_.view(), strains_.data());
  }
  BondLoads<double, 3> loads(const BondParameters<double>& law, const BondConfiguration<double, 3>& now) {
    return Law::template loads<true>(law, branches_.view(), history_, strains_.data(), now, 0.0);
  }
  const History& history() const { return history_; }

 private:
  BranchSteps branches_;
  std::vector<double> strains_;
  History history_{};
};

template <BondForm form>
void start(const Chain<3>& chain, const ChainState<3>& state, int bond, double* history, std::size_t stride) {
  using Bonds = ViscoelasticBonds<form>;
  for (std::size_t n = 0; n < Bonds(chain.fiber).size(); ++n) history[n * stride] = 0;
  packing_law_detail::start<typename Bonds::Law>(chain, state, bond, history, stride);
}

template <BondForm form>
BondSums sums(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
              const double* histories, std::size_t stride, std::size_t bond_stride) {
  ViscoelasticBonds<form> bonds(chain.fiber);
  BondSums sum{};
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    bonds.read(histories + i * bond_stride, stride);
    with_configuration(chain, state, i, [&](const BondConfiguration<double, 3>& now) {
      sum.energy += bonds.energy(law, now);
      sum.bending += packing_law_detail::bending_of<typename ViscoelasticBonds<form>::Law>(
          chain, state, i, bonds.history(), now);
    });
  }
  return sum;
}

template <BondForm form>
BondState state(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
                int bond, const double* numbers, std::size_t stride) {
  ViscoelasticBonds<form> bonds(chain.fiber);
  bonds.read(numbers, stride);
  return with_configuration(chain, state, bond, [&](const BondConfiguration<double, 3>& now) -> BondState {
    const double angle = packing_law_detail::bending_of<typename ViscoelasticBonds<form>::Law>(
        chain, state, bond, bonds.history(), now);
    return {bonds.loads(law, now).force_on_first, angle};
  });
}

template <BondForm form>
constexpr PackingLaw viscoelastic_law{
    .form = form,
    .from_poses = BondLawType<form>::from_poses,
    .largest_stiffness = [](const Fiber&) { return 1.0; },  // time steps count with the branches already
    .kernel = packing_kernel,
    .start = start<form>,
    .sums = sums<form>,
    .state = state<form>,
    .intact_place = -1};

template <BondForm form>
using FailingLaw = FailingBond<BondLawType<form>>;
template <BondForm form>
using FailingHistory = BondLawHistory<FailingLaw<form>, double, 3>;

template <BondForm form>
BondSums failing_sums(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
                      const double* histories, std::size_t stride, std::size_t bond_stride) {
  using Law = FailingLaw<form>;
  BondSums sum{};
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const auto history = get_strided<FailingHistory<form>>(histories + i * bond_stride, stride);
    sum.plastic_work += history.failure.work;
    if (history.failure.intact == 0) continue;
    ++sum.whole;
    with_configuration(chain, state, i, [&](const BondConfiguration<double, 3>& now) {
      sum.energy += Law::stored_energy(law, history, now);
      sum.bending += packing_law_detail::bending_of<Law>(chain, state, i, history, now);
    });
  }
  return sum;
}

template <BondForm form>
BondState failing_state(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
                        int bond, const double* numbers, std::size_t stride) {
  using Law = FailingLaw<form>;
  auto history = get_strided<FailingHistory<form>>(numbers, stride);
  if (history.failure.intact == 0) return {{}, 0};
  return with_configuration(chain, state, bond, [&](const BondConfiguration<double, 3>& now) -> BondState {
    const double angle = packing_law_detail::bending_of<Law>(chain, state, bond, history, now);
    return {Law::loads(law, history, now, 0.0).force_on_first, angle};
  });
}

template <BondForm form>
constexpr PackingLaw failing_law{
    .form = form,
    .from_poses = BondLawType<form>::from_poses,
    .largest_stiffness = [](const Fiber&) { return 1.0; },
    .kernel = packing_kernel,
    .start = packing_law_detail::start<FailingLaw<form>>,
    .sums = failing_sums<form>,
    .state = failing_state<form>,
    .intact_place = static_cast<int>(numbers_of<FailingHistory<form>>) - 1,
    .failure_place = static_cast<int>(numbers_of<FailingHistory<form>> - numbers_of<BondFailure<double>>)};

}  // namespace

const PackingLaw& packing_law(const AssemblyOptions& options) {
  if (options.law != nullptr) return *options.law;
  return with_bond_form(options.form, []<BondForm form>() -> const PackingLaw& { return library_law<form>; });
}

const PackingLaw& packing_law(const AssemblyOptions& options, const Fiber& fiber) {
  if (fiber.branches.empty() && !fails(fiber)) return packing_law(options);
  if (fails(fiber) && options.law == nullptr)
    return with_bond_form(options.form,
                          []<BondForm form>() -> const PackingLaw& { return failing_law<form>; });
  if (fails(fiber))
    throw InvalidInput(
        "bonds that break or yield are not allowed: these bonds have a law from outside of the library");
  if (options.law != nullptr) {
    throw InvalidInput(
        "Maxwell branches are not allowed: these bonds have a law from outside of the library");
  }
  return with_bond_form(options.form,
                        []<BondForm form>() -> const PackingLaw& { return viscoelastic_law<form>; });
}

}  // namespace fiberchain::dem
