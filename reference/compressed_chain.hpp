#pragma once

#include <vector>

namespace fiberchain::reference {

// The same stability question for the discrete chain itself: N touching spheres on the axis along which
// planar extension (or another flow without vorticity in the plane) compresses them at the rate e, free
// draining: each sphere feels the drag 6 pi mu R and the torque 8 pi mu R^3 of the undisturbed flow. The
// bonds have the energy
//   U = 1/2 K_n (l - l_0)^2 + 1/2 K_t l_0^2 gamma^2 + 1/2 K_bend theta_b^2,  l_0 = 2R,
// K_n = pi R E/2, K_t = pi R G/2, K_bend = pi R^3 E/8. Lengths below are over R, forces over E I/R^2 with
// I = pi R^4/4, times over 1/e; number = 3 pi mu e L^4/(E I), L = 2 R N.
//
// About the compressed state (spacings l_i, axial forces F_i, negative) the second variation of a bond's
// energy for displacements w across and rotations theta is
//   1/2 (F/l) (w_2 - w_1)^2 + 1/2 K_t l_0^2 ((w_2 - w_1)/l - (theta_1 + theta_2)/2)^2
//   + 1/2 K_bend (theta_2 - theta_1)^2,
// the first term from the second-order change of the bond's length.

struct CompressedChain {
  int spheres;           ///< N, 3 to 300
  double poisson_ratio;  ///< nu, above -1 and up to 0.5: sets K_t
  /// The springs of stretch have this times K_n; infinity: the bonds keep their lengths and F is a
  /// constraint.
  double stretch_factor = 1;
  double transverse_rate = 1;  ///< rate of stretching across the chain, over e; 1/2: uniaxial compression
};

/// Straight chain at rest in the flow.
struct CompressedState {
  std::vector<double> positions;  ///< of the spheres along the axis, from the center, over R
  std::vector<double> forces;     ///< of the bonds, negative in compression, over E I/R^2
};

/// Axial balance 6 pi mu R e x_i = F_i - F_{i-1} at finite strain (linear in the positions, as U is quadratic
/// in l). Throws InvalidArgument for a chain that makes no sense or unless 0 < number <= 100000.
CompressedState compressed_state(const CompressedChain& chain, double number);

/// Motion u exp(growth e t) of the spheres about the compressed state.
struct ChainGrowthMode {
  double growth;                     ///< sigma/e
  std::vector<double> displacement;  ///< across the chain per sphere, the last is 1
  std::vector<double> rotation;      ///< angle times R
};

/// Bending mode `mode`: 1, 3 ... symmetric about the middle of the chain, 2, 4 ... antisymmetric, each kind
/// by falling growth. Translation, which grows at transverse_rate exactly, is no mode here; rotation is mode
/// 0. (Rotation and the antisymmetric bending modes mix a little, since torques turn the spheres; far beyond
/// the second threshold, where mode 2 outgrows rotation, they change places.) Throws InvalidArgument unless 0
/// <= mode <= spheres - 2 and as above; NoConvergence.
ChainGrowthMode chain_growth_mode(const CompressedChain& chain, double number, int mode);

/// Number at which bending mode `mode` (1 or more) has growth 0, the compressed state changing with the
/// number. Searched for from 1/4 to 8 times that of the filament. Throws InvalidArgument, NoConvergence.
double chain_buckling_threshold(const CompressedChain& chain, int mode);

}  // namespace fiberchain::reference
