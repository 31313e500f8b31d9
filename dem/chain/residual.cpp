#include "dem/chain/residual.hpp"

#include <algorithm>
#include <cmath>

#include "dem/bond/strain_change.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
void add(SphereVector<Dim>& sum, const Vec<double, Dim>& force, const Spin<double, Dim>& moment) {
  sum.template head<Dim>() += tangent_detail::eigen(force);
  sum.template tail<spin_size<Dim>>() += tangent_detail::eigen(moment);
}

template <int Dim>
void release_clamps(ChainVector<Dim>& forces, const Boundary<Dim>& boundary) {
  for (const int sphere : boundary.clamped) forces[sphere].setZero();
}

/// rho + delta rho
template <int Dim>
Vec<double, Dim> changed_separation(const BondKinematics<double, Dim>& k, const SphereVector<Dim>& first,
                                    const SphereVector<Dim>& second) {
  const SphereVector<Dim> difference = second - first;
  return k.separation + strain_change<Dim>(k, displacement_part<Dim>(difference), rotation_part<Dim>(first),
                                           rotation_part<Dim>(second))
                            .separation;
}

}  // namespace

template <int Dim>
double dot_product(const ChainVector<Dim>& a, const ChainVector<Dim>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

template <int Dim>
double size_of(const ChainVector<Dim>& motion, double length) {
  double largest = 0;
  for (const SphereVector<Dim>& v : motion) {
    const double here = std::max(v.template head<Dim>().cwiseAbs().maxCoeff() / length,
                                 v.template tail<spin_size<Dim>>().cwiseAbs().maxCoeff());
    if (!(here <= largest)) largest = here;  // keeps not-a-number
    if (std::isnan(largest)) break;
  }
  return largest;
}

template <int Dim>
void hold_clamped(ChainTangent<Dim>& A, const Boundary<Dim>& boundary) {
  for (const int sphere : boundary.clamped) {
    A.lower[sphere].setZero();
    A.upper[sphere].setZero();
    A.diagonal[sphere].setIdentity();
  }
}

template <int Dim>
ChainVector<Dim> bond_forces(const Chain<Dim>& chain, const Poses<Dim>& poses) {
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  ChainVector<Dim> forces(poses.size(), SphereVector<Dim>::Zero());
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const auto k = bond_kinematics(chain, poses, i);
    const auto loads = bond_loads(k, bond_stress(bond, k.separation, k.rotation));
    add<Dim>(forces[i], loads.force_on_first, loads.moment_on_first);
    add<Dim>(forces[i + 1], -loads.force_on_first, loads.moment_on_second);
  }
  return forces;
}

template <int Dim>
ChainVector<Dim> applied_loads(const Boundary<Dim>& boundary, int spheres) {
  ChainVector<Dim> forces(spheres, SphereVector<Dim>::Zero());
  for (const Load<Dim>& load : boundary.loads) add<Dim>(forces[load.sphere], load.force, load.moment);
  release_clamps(forces, boundary);
  return forces;
}

template <int Dim>
ChainVector<Dim> net_forces(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary,
                            double factor) {
  ChainVector<Dim> forces = bond_forces(chain, poses);
  for (const Load<Dim>& load : boundary.loads) {
    add<Dim>(forces[load.sphere], factor * load.force, factor * load.moment);
  }
  release_clamps(forces, boundary);
  return forces;
}

template <int Dim>
ChainTangent<Dim> stiffness(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary) {
  constexpr int n = sphere_motions<Dim>;
  const BondParameters<double> bond = bond_parameters(chain.fiber);
  ChainTangent<Dim> K(static_cast<int>(poses.size()));
  for (int i = 0; i < chain.fiber.aspect_ratio; ++i) {
    const BondTangent<Dim> tangent = bond_tangent(bond, bond_kinematics(chain, poses, i));
    K.diagonal[i] -= tangent.template topLeftCorner<n, n>();
    K.upper[i] = -tangent.template topRightCorner<n, n>();
    K.lower[i + 1] = -tangent.template bottomLeftCorner<n, n>();
    K.diagonal[i + 1] -= tangent.template bottomRightCorner<n, n>();
  }
  hold_clamped(K, boundary);
  return K;
}

template <int Dim>
void move(const Chain<Dim>& chain, const Boundary<Dim>& boundary, Poses<Dim>& poses,
          const ChainVector<Dim>& motion) {
  const int last = static_cast<int>(poses.size()) - 1;
  const bool one_clamp = boundary.clamped.size() == 1;
  std::vector<Vec<double, Dim>> separation(last);
  if (one_clamp) {
    for (int i = 0; i < last; ++i)
      separation[i] = changed_separation<Dim>(bond_kinematics(chain, poses, i), motion[i], motion[i + 1]);
  }
  for (int i = 0; i <= last; ++i) {
    turn_by_vector(poses[i].orientation, rotation_part<Dim>(motion[i]));
    if (!one_clamp) poses[i].position = poses[i].position + displacement_part<Dim>(motion[i]);
  }
  if (!one_clamp) return;
  const int clamp = boundary.clamped[0];
  const auto vector = [&](int i) { return bond_kinematics(chain, poses, i).frame.to_global(separation[i]); };
  for (int i = clamp; i < last; ++i) poses[i + 1].position = poses[i].position + vector(i);
  for (int i = clamp; i > 0; --i) poses[i - 1].position = poses[i].position - vector(i - 1);
}

template <int Dim>
Imbalance imbalance(const Poses<Dim>& poses, const ChainVector<Dim>& net, const Boundary<Dim>& boundary,
                    double length) {
  double force_scale = 0, moment_scale = 0;
  for (const Load<Dim>& load : boundary.loads) {
    force_scale = std::max({force_scale, norm(load.force), norm(load.moment) / length});
    moment_scale = std::max({moment_scale, norm(load.force) * length, norm(load.moment)});
  }
  // sums over the part of the chain beyond each cross section; at a clamp they start anew
  Vec<double, Dim> force{};
  Spin<double, Dim> moment{};
  Imbalance worst{0, 0};
  for (int i = static_cast<int>(poses.size()) - 1; i >= 0; --i) {
    if (i + 1 < static_cast<int>(poses.size())) {
      moment = moment + cross(poses[i + 1].position - poses[i].position, force);
    }
    const Vec<double, Dim> here = displacement_part<Dim>(net[i]);
    force = force + here;
    moment = moment + rotation_part<Dim>(net[i]);
    worst.force = std::max(worst.force, norm(force));
    worst.moment = std::max(worst.moment, norm(moment));
  }
  if (force_scale > 0) worst.force /= force_scale;
  if (moment_scale > 0) worst.moment /= moment_scale;
  return worst;
}

template double dot_product<2>(const ChainVector<2>&, const ChainVector<2>&);
template double dot_product<3>(const ChainVector<3>&, const ChainVector<3>&);
template double size_of<2>(const ChainVector<2>&, double);
template double size_of<3>(const ChainVector<3>&, double);
template void hold_clamped<2>(ChainTangent<2>&, const Boundary<2>&);
template void hold_clamped<3>(ChainTangent<3>&, const Boundary<3>&);
template ChainVector<2> bond_forces<2>(const Chain<2>&, const Poses<2>&);
template ChainVector<3> bond_forces<3>(const Chain<3>&, const Poses<3>&);
template ChainVector<2> applied_loads<2>(const Boundary<2>&, int);
template ChainVector<3> applied_loads<3>(const Boundary<3>&, int);
template ChainVector<2> net_forces<2>(const Chain<2>&, const Poses<2>&, const Boundary<2>&, double);
template ChainVector<3> net_forces<3>(const Chain<3>&, const Poses<3>&, const Boundary<3>&, double);
template ChainTangent<2> stiffness<2>(const Chain<2>&, const Poses<2>&, const Boundary<2>&);
template ChainTangent<3> stiffness<3>(const Chain<3>&, const Poses<3>&, const Boundary<3>&);
template void move<2>(const Chain<2>&, const Boundary<2>&, Poses<2>&, const ChainVector<2>&);
template void move<3>(const Chain<3>&, const Boundary<3>&, Poses<3>&, const ChainVector<3>&);
template Imbalance imbalance<2>(const Poses<2>&, const ChainVector<2>&, const Boundary<2>&, double);
template Imbalance imbalance<3>(const Poses<3>&, const ChainVector<3>&, const Boundary<3>&, double);

}  // namespace fiberchain::dem
