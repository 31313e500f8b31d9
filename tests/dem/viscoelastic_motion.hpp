#pragma once

#include <complex>
#include <vector>

#include "dem/bond/branch_steps.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/physics_of.hpp"
#include "reference/complex_modes.hpp"

// Chains of fibers with Maxwell branches, started in one mode of their linearization: poses, velocities and
// the strains of the branches.
namespace viscoelastic {

namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;
using Complex = std::complex<double>;

inline reference::PronySeries spectrum(const dem::PronySeries& series) {
  reference::PronySeries same;
  for (const auto& [g, tau] : series) same.push_back({g, tau});
  return same;
}

inline reference::BondSpectra spectra(const dem::MaxwellBranches& own) {
  return {spectrum(own.stretch), spectrum(own.shear), spectrum(own.twist), spectrum(own.bend)};
}

inline reference::LinearChain linear_chain(const dem::Fiber& fiber) {
  const dem::BondStiffness K = dem::bond_stiffness(fiber);
  const dem::BondDashpot c = dem::bond_dashpot(fiber);
  return {.bonds = fiber.aspect_ratio,
          .spacing = dem::bond_length(fiber),
          .mass = dem::sphere_mass(fiber),
          .inertia = dem::sphere_inertia(fiber),
          .stiffness = {K.stretch, K.shear, K.twist, K.bend},
          .dashpot = {c.stretch, c.shear, c.twist, c.bend},
          .end_share = dem::end_mass_share(fiber)};
}

/// A mode of small amplitude in a direction across the fiber (bending), along or about it.
template <int Dim>
class ModeStart {
 public:
  ModeStart(const dem::Fiber& fiber, dem::BondForm form, reference::ChainMotion motion,
            const reference::ComplexChainMode& mode, double amplitude)
      : fiber_(fiber), form_(form), motion_(motion), mode_(mode), amplitude_(amplitude) {}

  void put(dem::ChainBatch<Dim>& block, int lane, const dem::Chain<Dim>& chain) const {
    dem::ChainState<Dim> state = dem::at_rest<Dim>(chain.poses);
    for (int i = 0; i <= fiber_.aspect_ratio; ++i) {
      const Complex s = mode_.decay.eigenvalue;
      state.poses[i].position = state.poses[i].position + displacement(i, 1);
      turn(state.poses[i], rotation(i, 1));
      state.velocity[i] = displacement(i, s), state.spin[i] = rotation(i, s);
    }
    dem::put_state(block, lane, chain, state);
    for (int i = 0; i < fiber_.aspect_ratio; ++i) put_branches(block, lane, i);
  }

  /// Of the free end, as far as it moves in this mode.
  double tip(const dem::ChainBatch<Dim>& block, int lane, const dem::Chain<Dim>& chain) const {
    const auto sphere = block.sphere(lane, fiber_.aspect_ratio);
    const auto moved = sphere.pose.position - chain.poses.back().position;
    switch (motion_) {
      case reference::ChainMotion::axial:
        return moved[0];
      case reference::ChainMotion::twist:
        return angle_about_x(sphere.pose);
      default:
        return dem::dot(moved, across());
    }
  }

 private:
  using Vector = dem::Vec<double, Dim>;
  using Spin = dem::Spin<double, Dim>;

  static Vector across() {
    Vector u{};
    u[1] = Dim == 2 ? 1 : 0.6;
    if constexpr (Dim == 3) u[2] = 0.8;
    return u;
  }
  /// Axis about which a fiber along x turns towards across().
  static Spin axis() {
    if constexpr (Dim == 2) {
      return {1};
    } else {
      return {0, -0.8, 0.6};
    }
  }
  static void turn(dem::Pose<double, 2>& pose, const dem::Vec<double, 1>& angle) {
    pose.orientation += angle[0];
  }
  static void turn(dem::Pose<double, 3>& pose, const dem::Vec<double, 3>& angle) {
    pose.orientation = dem::cayley_turn(0.5 * angle, pose.orientation);
  }
  static double angle_about_x(const dem::Pose<double, 2>&) { return 0; }
  static double angle_about_x(const dem::Pose<double, 3>& pose) { return 2 * pose.orientation.v[0]; }

  double real(Complex shape, Complex factor) const { return amplitude_ * (shape * factor).real(); }
  Vector displacement(int i, Complex factor) const {
    if (motion_ == reference::ChainMotion::twist) return {};
    Vector along{};
    along[0] = 1;
    return real(mode_.displacement[i], factor) *
           (motion_ == reference::ChainMotion::axial ? along : across());
  }
  Spin rotation(int i, Complex factor) const {
    if (motion_ == reference::ChainMotion::axial) return {};
    Spin about{};
    about[0] = 1;
    return real(mode_.rotation[i], factor) * (motion_ == reference::ChainMotion::twist ? about : axis());
  }

  /// Components of the strain of a branch of time tau, factor s tau / (1 + s tau); the bond's own with
  /// factor 1.
  std::vector<double> components(Complex strain, Complex factor, const Vector& vector,
                                 const std::vector<Vector>& directors) const {
    std::vector<double> all;
    for (const Vector& d : directors) all.push_back(real(strain, factor) * dem::dot(vector, d));
    return all;
  }

  void add(std::vector<double>& memory, const dem::PronySeries& series, Complex strain, const Vector& vector,
           const std::vector<Vector>& directors) const {
    if (series.empty()) return;
    const auto put = [&](Complex factor) {
      for (const double z : components(strain, factor, vector, directors)) memory.push_back(z);
    };
    if (form_ == dem::BondForm::total) put(1);
    const Complex s = mode_.decay.eigenvalue;
    for (const auto& [g, tau] : series) put(s * tau / (1.0 + s * tau));
  }

  void put_branches(dem::ChainBatch<Dim>& block, int lane, int i) const {
    std::vector<double> numbers = block.bond_numbers(lane, i), memory;
    const bool bends = motion_ == reference::ChainMotion::bending;
    const Complex zero = 0,
                  du = bends || motion_ == reference::ChainMotion::axial
                           ? mode_.displacement[i + 1] - mode_.displacement[i]
                           : zero,
                  dr = motion_ == reference::ChainMotion::axial ? zero
                                                                : mode_.rotation[i + 1] - mode_.rotation[i];
    const Complex sliding =
        bends ? du - dem::bond_length(fiber_) / 2 * (mode_.rotation[i + 1] + mode_.rotation[i]) : zero;
    // directors across the bond, and the axis of bending as a vector
    std::vector<Vector> directors(Dim - 1);
    directors[0][1] = 1;
    Vector bend_axis{};
    bend_axis[1] = 1;
    if constexpr (Dim == 3) {
      directors[1][2] = 1;
      bend_axis = {0, -0.8, 0.6};
      if (form_ == dem::BondForm::incremental)
        directors = {{numbers[6], numbers[7], numbers[8]}, {-numbers[6], -numbers[8], numbers[7]}};
    }
    const Vector unit_x = [] {
      Vector u{};
      u[0] = 1;
      return u;
    }();
    const dem::MaxwellBranches& own = fiber_.branches;
    add(memory, own.stretch, bends ? zero : du, unit_x, {unit_x});
    add(memory, own.shear, sliding, across(), directors);
    if (Dim == 3) add(memory, own.twist, bends ? zero : dr, unit_x, {unit_x});
    add(memory, own.bend, bends ? dr : zero, bend_axis, directors);
    BOOST_TEST_REQUIRE(memory.size() <= numbers.size());
    std::copy(memory.begin(), memory.end(), numbers.end() - static_cast<std::ptrdiff_t>(memory.size()));
    block.set_bond_numbers(lane, i, numbers);
  }

  dem::Fiber fiber_;
  dem::BondForm form_;
  reference::ChainMotion motion_;
  reference::ComplexChainMode mode_;
  double amplitude_;
};

/// s of x_n = Re(A exp(s n interval)), by least squares of x_{n+2} + p x_{n+1} + q x_n = 0.
inline Complex decay_of(const std::vector<double>& x, double interval) {
  double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
  for (std::size_t n = 0; n + 2 < x.size(); ++n) {
    a11 += x[n + 1] * x[n + 1], a12 += x[n + 1] * x[n], a22 += x[n] * x[n];
    b1 -= x[n + 1] * x[n + 2], b2 -= x[n] * x[n + 2];
  }
  const double determinant = a11 * a22 - a12 * a12;
  const double p = (b1 * a22 - b2 * a12) / determinant, q = (a11 * b2 - a12 * b1) / determinant;
  const Complex root = -p / 2 + std::sqrt(Complex(p * p / 4 - q));
  const Complex s = std::log(root) / interval;
  return {s.real(), std::abs(s.imag())};
}

/// What a march makes of a mode: its s over `periods`, `steps` of a period each.
template <int Dim>
Complex marched_mode(const dem::Fiber& fiber, dem::BondForm form, reference::ChainMotion motion,
                     const reference::ComplexChainMode& mode, dem::Solved solved, double step, double periods,
                     double amplitude) {
  const dem::Chain<Dim> chain = dem::straight_chain<Dim>(fiber);
  const dem::Physics physics = dem::physics_of(chain, {.form = form, .solved = solved});
  dem::ChainBatch<Dim> block({chain}, {true, false}, {step}, {0}, physics, dem::best_instruction_set());
  const ModeStart<Dim> start(fiber, form, motion, mode, amplitude);
  start.put(block, 0, chain);
  block.synchronize();
  const double period = 2 * 3.14159265358979 / mode.decay.eigenvalue.imag();
  const int stride = std::max(1, static_cast<int>(period / 8 / step));
  std::vector<double> x;
  for (int n = 0; n < static_cast<int>(8 * periods); ++n) {
    x.push_back(start.tip(block, 0, chain));
    block.march(stride);
  }
  return decay_of(x, stride * step);
}

}  // namespace viscoelastic
