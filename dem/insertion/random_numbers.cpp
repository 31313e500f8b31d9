#include "dem/insertion/random_numbers.hpp"

#include <Random123/philox.h>
#include <Random123/uniform.hpp>

namespace fiberchain::dem {

std::array<double, 4> uniform_numbers(std::uint64_t seed, const Draw& draw) {
  const r123::Philox4x64::ctr_type counter = {{draw.number, draw.attempt, draw.block, 0}};
  const r123::Philox4x64::key_type key = {{seed, 0}};
  return r123::u01all<double>(r123::Philox4x64()(counter, key));
}

}  // namespace fiberchain::dem
