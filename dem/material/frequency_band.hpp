#pragma once

namespace fiberchain::dem {

struct FrequencyBand {
  double low, high;  ///< [Hz]
};

}  // namespace fiberchain::dem
