#pragma once

#include <functional>
#include <vector>

#include "reference/cvode.hpp"

namespace fiberchain::reference {

// A straight, thin, inextensible elastic filament on the axis along which a linear flow compresses it at the
// rate e, with the free-draining isotropic drag zeta = 3 pi mu per length (a chain of touching spheres, 6 pi
// mu R each 2R). The drag puts it under the tension T(s) = -(zeta e/2)(L^2/4 - s^2), -L/2 <= s <= L/2, and a
// small deflection y obeys
//   zeta (dy/dt - q e y) = -E I y'''' + (T y')',  y'' = y''' = 0 at both ends,
// with q e the rate at which the flow stretches across the filament: q = 1 planar extension, q = 1/2 uniaxial
// compression (biaxial extension), q = 0 planar extension seen in the direction that does not flow. In shear
// at 45 degrees e = rate/2 and q = 1 for the deflection in the plane.
//
// Everything depends on the number zeta e L^4/(E I). In Legendre polynomials the compression is diagonal,
//   sigma/e = q + n (n + 1)/2 - (bending)/number,
// so translation (n = 0) grows at q e and rotation (n = 1) at (q + 1) e, whatever the filament is made of,
// and the bending modes (n >= 2) contain neither. Mode 1, 3, 5 ... are even in s, mode 2, 4, 6 ... odd.

/// Number of Legendre polynomials above rotation that the shapes are expanded in.
inline constexpr int filament_polynomials = 90;
/// Highest bending mode asked for and largest number, for which the expansion is good to 1e-9.
inline constexpr int max_filament_mode = 12;
inline constexpr double max_filament_number = 1e5;

/// Number at which bending mode `mode` neither grows nor decays in amplitude (sigma = 0): below it decays.
/// In extension 123.504, 510.14, 1167.7 for the first three; in shear at 45 degrees, where the number is
/// formed with the shear rate, twice as much. Throws InvalidArgument unless 1 <= mode <= 12 and 0 <=
/// transverse_rate <= 10.
double buckling_threshold(int mode, double transverse_rate = 1);

/// A shape y(s)/L = sum_n coefficients[n] sqrt(2n + 1) P_n(2 s/L) that grows as exp(growth e t); int y^2 ds =
/// 1 (over L^3) and y(L/2) > 0. coefficients[0] and [1], translation and rotation, are zero.
struct FilamentMode {
  double growth;  ///< sigma/e
  std::vector<double> coefficients;
};

/// Bending mode `mode` at the number. Modes of one parity are counted by falling growth. Throws
/// InvalidArgument unless 1 <= mode <= 12, 0 < number <= 100000 and 0 <= transverse_rate <= 10;
/// NoConvergence.
FilamentMode filament_mode(double number, int mode, double transverse_rate = 1);

/// sigma/e of the first `modes` bending modes at the number. Throws as filament_mode.
std::vector<double> growth_rates(double number, int modes, double transverse_rate = 1);

/// y/L at each position s/L of the sum above. Throws InvalidArgument unless the positions are within -1/2 ...
/// 1/2.
std::vector<double> filament_deflection(const std::vector<double>& coefficients,
                                        const std::vector<double>& positions);

/// Small deflection over time under a compression that changes with time, as of a filament that turns through
/// shear.
struct FilamentHistory {
  std::vector<std::vector<double>> coefficients;  ///< at each time, as in FilamentMode
  CvodeStatistics statistics;
};

/// The compression rate e/rate of a thin filament in the shear u = (rate y, 0, 0) at the time t (in 1/rate)
/// after it lay at `angle` to the flow, as it turns with cot(angle(t)) = cot(angle) + t: -sin(2 angle(t))/2,
/// so that the filament is compressed at angles pi/2 ... pi. Throws InvalidArgument unless 0 < angle < pi.
std::function<double(double)> shear_compression(double angle);

/// In the frame that turns with the straight filament (no torque of its own: Lambda = 1), by CVODE:
///   d a_n/dt = (e(t)/rate) (1 + n (n + 1)/2) a_n - (bending a)_n/number,
/// times in 1/rate, number = zeta rate L^4/(E I), `compression` = e(t)/rate, in the plane (q = 1). `start`
/// are the coefficients at time 0, 2 to 92 of them: as many are followed (24 give six digits up to number
/// 1000). The tension's change with the deflection is of second order. Throws InvalidArgument, NoConvergence.
FilamentHistory deflection_history(double number, const std::function<double(double)>& compression,
                                   const std::vector<double>& start, const std::vector<double>& times,
                                   const CvodeTolerances& tolerances = {});

}  // namespace fiberchain::reference
