#pragma once

#include <cstdint>

#include "dem/assembly/assembly.hpp"
#include "dem/chain/bending.hpp"
#include "dem/chain/chain_bond.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/simd/as_numbers.hpp"

// A bond law as an assembly uses it, outside of the inner loops. The history of a bond lies in lanes: its
// numbers `stride` doubles apart.
namespace fiberchain::dem {

/// Over bonds.
struct BondSums {
  double energy;            ///< stored [J]
  double bending;           ///< angles [rad]
  double plastic_work = 0;  ///< of all, broken ones included [J]
  std::int64_t whole = 0;   ///< that are not broken, of which energy and bending are
};

/// Functions of one law. BondParameters are those of the chain's fiber.
struct PackingLaw {
  BondForm form;
  bool from_poses;                            ///< orientations must be followed
  double (*largest_stiffness)(const Fiber&);  ///< of a spring, over that of the fiber's bonds [-]
  const PackingKernel& (*kernel)(const Physics&, InstructionSet);
  /// History of bond `bond` in the state its fiber starts from.
  void (*start)(const Chain<3>&, const ChainState<3>&, int bond, double* history, std::size_t stride);
  /// Of a fiber's bonds; `bond_stride` doubles from one bond's history to the next.
  BondSums (*sums)(const BondParameters<double>&, const Chain<3>&, const ChainState<3>&,
                   const double* histories, std::size_t stride, std::size_t bond_stride);
  BondState (*state)(const BondParameters<double>&, const Chain<3>&, const ChainState<3>&, int bond,
                     const double* history, std::size_t stride);
  /// Flag of a bond that can break: 1 intact, 0 broken. Its place in the history; -1 where bonds do not
  /// break.
  int intact_place;
  int failure_place = -1;  ///< of BondFailure in the history; -1 where bonds neither break nor yield
};

namespace packing_law_detail {

template <class Law>
void start(const Chain<3>& chain, const ChainState<3>& state, int bond, double* history, std::size_t stride) {
  put_strided(start_history<Law>(chain, state, bond), history, stride);
}

/// Angle between the bond's ends, 0 at rest [rad].
template <class Law>
double bending_of(const Chain<3>& chain, const ChainState<3>& state, int bond,
                  const BondLawHistory<Law, double, 3>& history, const BondConfiguration<double, 3>& now) {
  if constexpr (Law::from_poses) {
    return bending_angle(chain, state.poses, bond);
  } else {
    return Law::bending_angle(history, now);
  }
}

template <class Law>
BondSums sums(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
              const double* histories, std::size_t stride, std::size_t bond_stride) {
  BondSums sum{};
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const auto history = get_strided<BondLawHistory<Law, double, 3>>(histories + i * bond_stride, stride);
    with_configuration(chain, state, i, [&](const BondConfiguration<double, 3>& now) {
      sum.energy += Law::stored_energy(law, history, now);
      sum.bending += bending_of<Law>(chain, state, i, history, now);
    });
  }
  sum.whole = chain.fiber.aspect_ratio;
  return sum;
}

template <class Law>
BondState state(const BondParameters<double>& law, const Chain<3>& chain, const ChainState<3>& state,
                int bond, const double* numbers, std::size_t stride) {
  const auto history = get_strided<BondLawHistory<Law, double, 3>>(numbers, stride);
  return with_configuration(chain, state, bond, [&](const BondConfiguration<double, 3>& now) -> BondState {
    const double angle = bending_of<Law>(chain, state, bond, history, now);
    if constexpr (Law::from_poses) {
      return {(Law::loads(law, history, now) + dashpot_loads(law, now)).force_on_first, angle};
    } else {
      return {Law::template action<true>(law, history, now).force, angle};
    }
  });
}

/// A law whose bonds can break ends its history with the flag `intact`.
template <class Law>
constexpr int intact_place_of() {
  using History = BondLawHistory<Law, double, 3>;
  if constexpr (requires(History h) { h.intact; }) {
    return static_cast<int>(numbers_of<History>) - 1;
  } else {
    return -1;
  }
}

}  // namespace packing_law_detail

/// The law of a form with the kernels given.
template <BondForm form>
constexpr PackingLaw packing_law_with(const PackingKernel& (*kernel)(const Physics&, InstructionSet)) {
  using Law = BondLawType<form>;
  return {
      .form = form,
      .from_poses = Law::from_poses,
      .largest_stiffness = [](const Fiber& fiber) { return Law::largest_stiffness(bond_parameters(fiber)); },
      .kernel = kernel,
      .start = packing_law_detail::start<Law>,
      .sums = packing_law_detail::sums<Law>,
      .state = packing_law_detail::state<Law>,
      .intact_place = packing_law_detail::intact_place_of<Law>()};
}

/// A law from outside of the library, for AssemblyOptions::law; its kernels are LawKernels<form>.
template <BondForm form>
inline constexpr PackingLaw outside_law = packing_law_with<form>(law_kernel<form>);

/// The law that an assembly runs with: that of its bonds without Maxwell branches.
const PackingLaw& packing_law(const AssemblyOptions& options);
/// The law of a fiber's bonds. Throws InvalidInput for a fiber with branches whose bonds have a law from
/// outside of the library.
const PackingLaw& packing_law(const AssemblyOptions& options, const Fiber& fiber);

}  // namespace fiberchain::dem
