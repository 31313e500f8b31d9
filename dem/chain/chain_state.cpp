#include "dem/chain/chain_state.hpp"

#include "dem/bond/dashpot_matrix.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
Eigen::Matrix<double, motions<Dim>, motions<Dim>> eigen(const Square<double, motions<Dim>>& A) {
  return Eigen::Map<const Eigen::Matrix<double, motions<Dim>, motions<Dim>, Eigen::RowMajor>>(&A.c[0][0]);
}

}  // namespace

template <int Dim>
ChainState<Dim> at_rest(const Poses<Dim>& poses) {
  return {poses, std::vector<Vec<double, Dim>>(poses.size()), std::vector<Spin<double, Dim>>(poses.size())};
}

template <int Dim>
double total_energy(const Chain<Dim>& chain, const ChainState<Dim>& state) {
  double sum = elastic_energy(chain, state.poses);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    const double share = mass_share(chain.fiber, static_cast<int>(i));
    const double m = share * sphere_mass(chain.fiber), J = share * sphere_inertia(chain.fiber);
    sum += 0.5 * (m * dot(state.velocity[i], state.velocity[i]) + J * dot(state.spin[i], state.spin[i]));
  }
  return sum;
}

template <int Dim>
SphereVector<Dim> sphere_inertias(const Fiber& fiber, int sphere) {
  const double share = mass_share(fiber, sphere);
  SphereVector<Dim> inertias;
  inertias.template head<Dim>().setConstant(share * sphere_mass(fiber));
  inertias.template tail<spin_size<Dim>>().setConstant(share * sphere_inertia(fiber));
  return inertias;
}

template <int Dim>
ChainVector<Dim> dashpot_forces(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                const ChainVector<Dim>& velocity) {
  ChainVector<Dim> forces(poses.size(), SphereVector<Dim>::Zero());
  if (!damped(chain.fiber)) return forces;
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const Vec<double, Dim> r = poses[i + 1].position - poses[i].position;
    const SphereVector<Dim> difference = velocity[i + 1] - velocity[i],
                            mean = 0.5 * (velocity[i] + velocity[i + 1]);
    const RelativeMotion<double, Dim> motion{displacement_part<Dim>(difference), rotation_part<Dim>(mean),
                                             rotation_part<Dim>(difference)};
    const BondLoads<double, Dim> loads = act_at_middle(r, dashpot_action(bond, r, (1 / norm(r)) * r, motion));
    forces[i] += motion_of<Dim>(loads.force_on_first, loads.moment_on_first);
    forces[i + 1] += motion_of<Dim>(-loads.force_on_first, loads.moment_on_second);
  }
  return forces;
}

template <int Dim>
void add_dashpots(const Chain<Dim>& chain, const Poses<Dim>& poses, double factor, ChainTangent<Dim>& A) {
  if (!damped(chain.fiber)) return;
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const Vec<double, Dim> r = poses[i + 1].position - poses[i].position;
    const DashpotMatrix<double, Dim> C = dashpot_matrix(bond, r, (1 / norm(r)) * r);
    const auto coupling = eigen<Dim>(C.coupling);
    A.diagonal[i] += factor * eigen<Dim>(C.first);
    A.diagonal[i + 1] += factor * eigen<Dim>(C.second);
    A.upper[i] += factor * coupling;
    A.lower[i + 1] += factor * coupling.transpose();
  }
}

template <int Dim>
ChainTangent<Dim> motion_matrix(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                const Boundary<Dim>& boundary, ChainTangent<Dim> K,
                                const MatrixFactors& factors) {
  ChainTangent<Dim> A = std::move(K);
  for (int i = 0; i < A.blocks(); ++i) {
    for (auto* block : {&A.lower[i], &A.diagonal[i], &A.upper[i]}) *block *= factors.stiffness;
    A.diagonal[i].diagonal() += factors.inertia * sphere_inertias<Dim>(chain.fiber, i);
  }
  add_dashpots(chain, poses, factors.damping, A);
  hold_clamped(A, boundary);
  return A;
}

#define FIBERCHAIN_INSTANTIATE(Dim)                                                                         \
  template ChainState<Dim> at_rest<Dim>(const Poses<Dim>&);                                                 \
  template double total_energy<Dim>(const Chain<Dim>&, const ChainState<Dim>&);                             \
  template SphereVector<Dim> sphere_inertias<Dim>(const Fiber&, int);                                       \
  template ChainVector<Dim> dashpot_forces<Dim>(const Chain<Dim>&, const Poses<Dim>&,                       \
                                                const ChainVector<Dim>&);                                   \
  template void add_dashpots<Dim>(const Chain<Dim>&, const Poses<Dim>&, double, ChainTangent<Dim>&);        \
  template ChainTangent<Dim> motion_matrix<Dim>(const Chain<Dim>&, const Poses<Dim>&, const Boundary<Dim>&, \
                                                ChainTangent<Dim>, const MatrixFactors&);
FIBERCHAIN_INSTANTIATE(2)
FIBERCHAIN_INSTANTIATE(3)
#undef FIBERCHAIN_INSTANTIATE

}  // namespace fiberchain::dem
