#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fiberchain::dem::hdf5 {

/// Fills the chunks of compressed series as HDF5's filters would (shuffle, deflate, Fletcher-32), which read
/// them back, at a fifth of the cost: bytes of the same place in successive numbers are stored as they are
/// where they are as good as random, and only runs of equal ones are looked for elsewhere. Keeps its memory.
class ChunkWriter {
 public:
  /// The entry of a series of make_series(compressed), of floats or doubles. As many numbers as it has.
  /// @throws Failure
  void write(hid_t series, hsize_t entry, const std::vector<double>& numbers);

 private:
  template <class Number>
  void write_all(hid_t series, hsize_t entry, const std::vector<double>& numbers);

  std::vector<unsigned char> shuffled_, packed_;
};

/// The checksum of HDF5's filter.
std::uint32_t fletcher32(std::string_view bytes);

}  // namespace fiberchain::dem::hdf5
