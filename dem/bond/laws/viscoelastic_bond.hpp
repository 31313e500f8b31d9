#pragma once

#include "dem/bond/incremental_frame.hpp"
#include "dem/bond/laws/incremental_bond.hpp"
#include "dem/bond/laws/total_bond.hpp"

// Maxwell branches beside the springs of a bond law of the library. Their strains lie behind the law's
// history; how many there are is the fiber's.
namespace fiberchain::dem {

template <class Base>
struct ViscoelasticBond;

/// From poses: branches keep their strains in the bond's mid-frame, of whose turns they know nothing. Their
/// energy is a function of the bond's strain and of what of it has relaxed, their pull its derivative.
template <>
struct ViscoelasticBond<TotalBond> : TotalBond {
  static constexpr bool dissipates = true;
  static constexpr bool keeps_strain = true;  ///< of the step before, with the branches

  template <bool damped, class Real, int Dim>
  static BondLoads<Real, Dim> loads(const BondParameters<Real>& bond, const BondBranches<Real>& branches,
                                    History<Real, Dim>&, Real* memory,
                                    const BondConfiguration<Real, Dim>& now, const Real& dt) {
    const BondKinematics<Real, Dim> k = bond_kinematics(now.first, now.second);
    BondStress<Real, Dim> stress = bond_stress<Real, Dim>(bond, k.separation, k.rotation);
    add_pull(bond, branches, k, memory, dt > Real(0.0), stress);
    if constexpr (damped) {
      return bond_loads(k, stress) + dashpot_loads(bond, now);
    } else {
      return bond_loads(k, stress);
    }
  }

  /// What the bond's strain is now.
  template <class Real, int Dim>
  static BondStrains<Real, Dim> strains(const BondParameters<Real>& bond, const History<Real, Dim>&,
                                        const BondConfiguration<Real, Dim>& now, const Real&) {
    const BondKinematics<Real, Dim> k = bond_kinematics(now.first, now.second);
    const ShearAngle<Real> shear = shear_angle(k.separation);
    return {{stretch_of(bond, k, shear)}, shear_of(bond, k, shear), {k.rotation[0]}, bend_of(k)};
  }

 private:
  template <class Real, int Dim>
  static Real stretch_of(const BondParameters<Real>& bond, const BondKinematics<Real, Dim>& k,
                         const ShearAngle<Real>& shear) {
    return shear.length - bond.unbent_length + bond.rest_length * bond.chord * bend_squared(k.rotation);
  }

  template <class Real, int Dim>
  static Vec<Real, Dim - 1> shear_of(const BondParameters<Real>& bond, const BondKinematics<Real, Dim>& k,
                                     const ShearAngle<Real>& shear) {
    Vec<Real, Dim - 1> strain;
    for (int c = 0; c < Dim - 1; ++c) strain[c] = bond.rest_length * shear.ratio * k.separation[c + 1];
    return strain;
  }

  template <class Real, int Dim>
  static Vec<Real, Dim - 1> bend_of(const BondKinematics<Real, Dim>& k) {
    if constexpr (Dim == 2) {
      return k.rotation;
    } else {
      return {k.rotation[1], k.rotation[2]};
    }
  }

  template <class Real, int Dim, class Mask>
  static void add_pull(const BondParameters<Real>& bond, const BondBranches<Real>& branches,
                       const BondKinematics<Real, Dim>& k, Real* memory, const Mask& moves,
                       BondStress<Real, Dim>& stress) {
    BranchReader<keeps_strain, Real, Real> reader(branches.steps, memory);
    if (branches.stretch > 0 || branches.shear > 0) {
      const ShearAngle<Real> shear = shear_angle(k.separation);
      if (branches.stretch > 0) {
        const Vec<Real, 1> strain{stretch_of(bond, k, shear)};
        add_tension(bond, k, shear, bond.stretch * reader.advance(branches.stretch, strain, moves)[0],
                    stress);
      }
      if (branches.shear > 0) {
        const auto strain = shear_of(bond, k, shear);
        add_shear(k, shear, bond.shear * bond.rest_length * reader.advance(branches.shear, strain, moves),
                  stress);
      }
    }
    if constexpr (Dim == 3) {
      if (branches.twist > 0) {
        const Vec<Real, 1> strain{k.rotation[0]};
        stress.moment[0] = stress.moment[0] + bond.twist * reader.advance(branches.twist, strain, moves)[0];
      }
    }
    if (branches.bend > 0) {
      const Vec<Real, Dim - 1> sum = reader.advance(branches.bend, bend_of(k), moves);
      constexpr int first = Dim == 3 ? 1 : 0;
      for (int c = 0; c < Dim - 1; ++c)
        stress.moment[first + c] = stress.moment[first + c] + bond.bend * sum[c];
    }
  }

  /// N d(l - l_r)
  template <class Real, int Dim>
  static void add_tension(const BondParameters<Real>& bond, const BondKinematics<Real, Dim>& k,
                          const ShearAngle<Real>& shear, const Real& N, BondStress<Real, Dim>& stress) {
    stress.force = stress.force + (N / shear.length) * k.separation;
    const Real chord = Real(2.0) * N * bond.rest_length * bond.chord;
    stress.moment = stress.moment + scale_spin(Real(0.0), chord, k.rotation);
  }

  /// Q d(gamma), gamma = (gamma / |rho_perp|) rho_perp: d gamma = (rho_x n.d rho_perp - |rho_perp| d rho_x) /
  /// l^2 along n = rho_perp / |rho_perp|, (gamma / |rho_perp|) d rho_perp across it.
  template <class Real>
  static void add_shear(const BondKinematics<Real, 2>& k, const ShearAngle<Real>& shear,
                        const Vec<Real, 1>& Q, BondStress<Real, 2>& stress) {
    const Real turn = Q[0] / (shear.length * shear.length);
    stress.force[0] = stress.force[0] - turn * k.separation[1];
    stress.force[1] = stress.force[1] + turn * k.separation[0];
  }

  template <class Real>
  static void add_shear(const BondKinematics<Real, 3>& k, const ShearAngle<Real>& shear,
                        const Vec<Real, 2>& Q, BondStress<Real, 3>& stress) {
    const Vec<Real, 3>& rho = k.separation;
    const Real inverse = Real(1.0) / (shear.length * shear.length);
    const Real along = Q[0] * rho[1] + Q[1] * rho[2];
    const Real radial = along * (rho[0] * inverse - shear.ratio) / (across_squared(rho) + Real(1e-300));
    stress.force[0] = stress.force[0] - along * inverse;
    stress.force[1] = stress.force[1] + shear.ratio * Q[0] + radial * rho[1];
    stress.force[2] = stress.force[2] + shear.ratio * Q[1] + radial * rho[2];
  }
};

/// Summed over the steps, by components along and across the bond.
template <>
struct ViscoelasticBond<IncrementalBond> : IncrementalBond {
  static constexpr bool rolls = false, dissipates = true;
  static constexpr bool keeps_strain = false;

  template <class Real, int Dim>
  using History = BondFrameHistory<Real, Dim>;

  template <int Dim>
  static History<double, Dim> start(const BondParameters<double>& bond,
                                    const BondConfiguration<double, Dim>& now) {
    return in_frame(IncrementalBond::start(bond, now), unit(now.line.vector));
  }

  template <bool damped, class Real, int Dim>
  static BondLoads<Real, Dim> loads(const BondParameters<Real>& bond, const BondBranches<Real>& branches,
                                    History<Real, Dim>& history, Real* memory,
                                    const BondConfiguration<Real, Dim>& now, const Real& dt) {
    const Real bent = bent_squared(history);
    BondStrains<Real, Dim> change = strain_change(history, now.line, now.motion, dt);
    add_strains(history, change);
    // what the tension follows: delta_n + l_0 chord theta_b^2
    const Real bent_now = bent_squared(history);
    change.stretch[0] = change.stretch[0] + bond.rest_length * bond.chord * (bent_now - bent);
    const auto moves = dt > Real(0.0);
    BranchReader<keeps_strain, Real, Real> reader(branches.steps, memory);

    Real N = dem::tension(bond, history.stretch, bent_now);
    if (branches.stretch > 0)
      N = N + bond.stretch * reader.advance(branches.stretch, change.stretch, moves)[0];
    auto shear = dem::shear_of(history);
    if (branches.shear > 0) shear = shear + reader.advance(branches.shear, change.shear, moves);
    const BondAxes<Real, Dim> axes = axes_of(now.line, history);
    const Vec<Real, Dim> force = axes.sum(N, bond.shear * shear);

    Real twist(0.0);
    if constexpr (Dim == 3) {
      twist = bond.twist * history.twist;
      if (branches.twist > 0)
        twist = twist + bond.twist * reader.advance(branches.twist, change.twist, moves)[0];
    }
    auto bend = bending_coefficient(bond, N) * history.bend;
    if (branches.bend > 0) bend = bend + bond.bend * reader.advance(branches.bend, change.bend, moves);
    BondAction<Real, Dim> action{force, moment_of(axes, twist, bend)};
    if constexpr (damped) action = action + dashpot_action(bond, now.line.vector, axes.along, now.motion);
    return act_at_middle(now.line.vector, action);
  }

  /// How the bond's strain has changed in the step that led here.
  template <class Real, int Dim>
  static BondStrains<Real, Dim> strains(const BondParameters<Real>& bond, History<Real, Dim> history,
                                        const BondConfiguration<Real, Dim>& now, const Real& dt) {
    const Real bent = bent_squared(history);
    BondStrains<Real, Dim> change = strain_change(history, now.line, now.motion, dt);
    add_strains(history, change);
    change.stretch[0] = change.stretch[0] + bond.rest_length * bond.chord * (bent_squared(history) - bent);
    return change;
  }

  template <int Dim>
  static double stored_energy(const BondParameters<double>& bond, const History<double, Dim>& history,
                              const BondConfiguration<double, Dim>& now) {
    const Vec<double, Dim> e = unit(now.line.vector);
    return dem::stored_energy(bond, out_of_frame(history, e), e);
  }

  static double bending_angle(const History<double, 3>& history, const BondConfiguration<double, 3>&) {
    return norm(history.bend);
  }

 private:
  template <class Real>
  static Vec<Real, 1> moment_of(const BondAxes<Real, 2>&, const Real&, const Vec<Real, 1>& bend) {
    return bend;
  }
  template <class Real>
  static Vec<Real, 3> moment_of(const BondAxes<Real, 3>& axes, const Real& twist, const Vec<Real, 2>& bend) {
    return axes.sum(twist, bend);
  }
};

}  // namespace fiberchain::dem
