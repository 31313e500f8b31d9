#include "dem/trajectory/hdf5_chunks.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "dem/trajectory/hdf5.hpp"

namespace fiberchain::dem::hdf5 {
namespace {

/// A compressor of zlib, whose level changes from plane to plane.
class Deflater {
 public:
  Deflater() {
    if (deflateInit2(&stream_, 1, Z_DEFLATED, 15, 8, Z_RLE) != Z_OK) throw Failure("zlib has no memory");
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream_); }

  std::size_t bound(std::size_t bytes) { return deflateBound(&stream_, bytes); }

  void write_to(std::vector<unsigned char>& to) {
    stream_.next_out = to.data();
    stream_.avail_out = static_cast<uInt>(to.size());
  }

  void add(const unsigned char* bytes, std::size_t count, bool as_they_are, bool last) {
    // a change of the level ends the block before
    check(deflateParams(&stream_, as_they_are ? 0 : 1, Z_RLE));
    stream_.next_in = const_cast<unsigned char*>(bytes);
    stream_.avail_in = static_cast<uInt>(count);
    check(deflate(&stream_, last ? Z_FINISH : Z_BLOCK));
    if (stream_.avail_in > 0) throw Failure("zlib wants more room than it said");
  }

  std::size_t written() const { return stream_.total_out; }

 private:
  /// Z_BUF_ERROR: there was nothing to end.
  static void check(int status) {
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      throw Failure("zlib cannot compress");
  }

  z_stream stream_{};
};

/// Whether bytes are as good as random: how often two of them are equal, over 1 in 256.
bool seem_random(const unsigned char* bytes, std::size_t count) {
  constexpr std::size_t stride = 7, fewest = 1024;
  constexpr double most = 1.6;
  std::array<std::uint32_t, 256> times{};
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < count; i += stride, ++looked_at) ++times[bytes[i]];
  if (looked_at < fewest) return false;
  double squares = 0;
  for (const std::uint32_t n : times) squares += static_cast<double>(n) * static_cast<double>(n);
  return squares / static_cast<double>(looked_at) / static_cast<double>(looked_at) * 256 < most;
}

/// The first byte of every number, then the second of every one, and so on; zeros behind them.
template <class Number>
void shuffle(const double* numbers, std::size_t count, std::size_t room, unsigned char* to) {
  constexpr std::size_t block = 256;
  for (std::size_t from = 0; from < count; from += block) {
    std::array<Number, block> own{};
    const std::size_t here = std::min(block, count - from);
    for (std::size_t i = 0; i < here; ++i) own[i] = static_cast<Number>(numbers[from + i]);
    std::array<unsigned char, block * sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), own.data(), bytes.size());
    for (std::size_t b = 0; b < sizeof(Number); ++b) {
      for (std::size_t i = 0; i < here; ++i) to[b * room + from + i] = bytes[i * sizeof(Number) + b];
    }
  }
  for (std::size_t b = 0; b < sizeof(Number); ++b) std::fill(to + b * room + count, to + (b + 1) * room, 0);
}

/// Size of the chunks, one entry thick.
std::vector<hsize_t> chunk_of(hid_t series, std::size_t dimensions) {
  const Handle properties(H5Dget_create_plist(series), &H5Pclose, "find how a dataset is stored");
  std::vector<hsize_t> chunk(dimensions);
  if (H5Pget_chunk(properties, static_cast<int>(dimensions), chunk.data()) != static_cast<int>(dimensions) ||
      chunk[0] != 1 || H5Pget_nfilters(properties) != 3)
    throw Failure("a dataset is not stored in chunks as ours are");
  return chunk;
}

}  // namespace

std::uint32_t fletcher32(std::string_view bytes) {
  constexpr std::size_t no_overflow = 360;
  const auto at = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
  };
  std::uint32_t first = 0, second = 0;
  const auto fold = [&] {
    first = (first & 0xffff) + (first >> 16);
    second = (second & 0xffff) + (second >> 16);
  };
  const std::size_t pairs = bytes.size() / 2;
  for (std::size_t begin = 0; begin < pairs; begin += no_overflow) {
    const std::size_t end = std::min(pairs, begin + no_overflow);
    for (std::size_t n = begin; n < end; ++n) second += first += at(2 * n) << 8 | at(2 * n + 1);
    fold();
  }
  if (bytes.size() % 2 == 1) {
    second += first += at(bytes.size() - 1) << 8;
    fold();
  }
  fold();
  return second << 16 | first;
}

void ChunkWriter::write(hid_t series, hsize_t entry, const std::vector<double>& numbers) {
  const Handle type(H5Dget_type(series), &H5Tclose, "find a dataset's type");
  H5Tget_size(type) == sizeof(float) ? write_all<float>(series, entry, numbers)
                                     : write_all<double>(series, entry, numbers);
}

template <class Number>
void ChunkWriter::write_all(hid_t series, hsize_t entry, const std::vector<double>& numbers) {
  const std::vector<hsize_t> size = size_of(series), chunk = chunk_of(series, size.size());
  hsize_t width = 1;
  for (std::size_t i = 2; i < size.size(); ++i) width *= size[i];
  if (size.size() < 2 || size[1] * width != numbers.size())
    throw Failure("an entry has not as many numbers as its dataset");
  const std::size_t room = chunk[1] * width;
  shuffled_.resize(room * sizeof(Number));
  std::vector<hsize_t> place(size.size(), 0);
  place[0] = entry;
  for (; place[1] < size[1]; place[1] += chunk[1]) {
    const std::size_t from = place[1] * width, count = std::min(room, numbers.size() - from);
    shuffle<Number>(numbers.data() + from, count, room, shuffled_.data());
    Deflater deflater;
    packed_.resize(deflater.bound(shuffled_.size()) + 1024);
    deflater.write_to(packed_);
    for (std::size_t b = 0; b < sizeof(Number); ++b) {
      const unsigned char* plane = shuffled_.data() + b * room;
      deflater.add(plane, room, seem_random(plane, room), b + 1 == sizeof(Number));
    }
    std::size_t bytes = deflater.written();
    const std::uint32_t sum = fletcher32({reinterpret_cast<const char*>(packed_.data()), bytes});
    for (int n = 0; n < 4; ++n) packed_[bytes++] = static_cast<unsigned char>(sum >> (8 * n));
    check(H5Dwrite_chunk(series, H5P_DEFAULT, 0, place.data(), bytes, packed_.data()), "write a chunk");
  }
}

}  // namespace fiberchain::dem::hdf5
