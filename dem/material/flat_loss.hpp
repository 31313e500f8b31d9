#pragma once

#include "dem/material/frequency_band.hpp"
#include "dem/model/prony_series.hpp"

// Loss factors that are the same over a band, as most solids nearly have them. dem/material/README.md.
namespace fiberchain::dem {

/// Maxwell branches with a flat loss factor tan delta = K'' / K'.
struct FlatLoss {
  PronySeries series;  ///< longest time first
  double ripple;       ///< largest relative error of tan delta in the band [-]
  double rise;         ///< K' at the band's end over K' at its beginning [-]
};

/// Largest ripple that the number of branches is chosen for.
inline constexpr double good_ripple = 0.015;

/// What may be asked for.
inline constexpr double largest_flat_loss = 10;
inline constexpr double widest_flat_band = 1e12;  ///< high / low
inline constexpr int most_flat_branches = 32;

/// Of all with as many branches those whose largest relative error of tan delta = `value` over the band is
/// least. The ripple depends on the number of branches and high / low alone, not on the value. Throws
/// InvalidInput unless 0 < value <= 10, 0 < low < high <= 1e12 low, all finite, 1 <= branches <= 32.
FlatLoss flat_loss(double value, FrequencyBand band, int branches);

/// The same with the fewest branches whose ripple is at most `good_ripple`. Throws InvalidInput as above.
FlatLoss flat_loss(double value, FrequencyBand band);

/// K_inf over the storage modulus at a frequency [Hz]: a modulus E measured there is that times E when
/// relaxed. Throws InvalidInput unless the frequency is finite and 0 or greater, or as check() does.
double relaxed_part(const PronySeries& series, double frequency);

}  // namespace fiberchain::dem
