#pragma once

#include <vector>

#include "dem/material/frequency_band.hpp"

namespace fiberchain::dem {

/// factor x prod_{even i} (root_i^2 + x^2) / prod_{odd i} (root_i^2 + x^2), i = 1 .. 2n - 1: of all x r(x^2),
/// r a quotient of polynomials of degrees n - 1 and n, the one nearest to 1 over a band. Its error is -ripple
/// at even and +ripple at odd extremes.
struct FlatFunction {
  std::vector<double> roots;     ///< ascending [1/s]; those with even i are at odd places
  std::vector<double> extremes;  ///< 2n + 1, ascending, the ends of the band included [1/s]
  double factor;                 ///< [1/s]
  double ripple;                 ///< largest error in the band [-]
};

/// Zolotarev's best approximation of the sign over angular frequencies of the band, by Jacobi's elliptic
/// functions of modulus low / high (e.g. Akhiezer, Elements of the Theory of Elliptic Functions, 1990).
FlatFunction flat_function(FrequencyBand band, int branches);

}  // namespace fiberchain::dem
