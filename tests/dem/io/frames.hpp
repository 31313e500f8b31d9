#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "dem/io/frame.hpp"

namespace fiberchain::test {

/// An empty directory that goes when the test ends.
struct Scratch {
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "fiberchain-io-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path = name;
  }
  ~Scratch() { std::filesystem::remove_all(path); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::filesystem::path path;
};

/// No file may grow beyond this while it lives, as on a full disk.
struct SizeLimit {
  explicit SizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit{bytes, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before); }
  rlimit before{};
};

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::size_t files_in(const std::filesystem::path& path) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
}

/// Bent fibers that turn and sink: no number in it is round, and each differs from every other.
inline dem::io::Frame bent_fibers(int fibers, int spheres, std::int64_t step) {
  dem::io::Frame frame{};
  frame.time = 1.7e-4 * static_cast<double>(step);
  frame.step = step;
  frame.low = {-0.011, 0.002, -0.03};
  frame.high = {0.093, 0.107, 0.11 - 1e-5 * static_cast<double>(step)};
  frame.periodic[0] = frame.periodic[2] = true;
  for (int f = 0; f < fibers; ++f) {
    const double radius = 1.1e-3 * (1 + 0.3 * std::sin(f)), spin = 0.4 * f + 3 * frame.time;
    for (int i = 0; i < spheres; ++i) {
      const double s = 2 * radius * i, bend = 20 * s * s * (1 + 0.1 * f);
      frame.position.push_back({0.01 + s * std::cos(spin) - bend * std::sin(spin),
                                0.02 + s * std::sin(spin) + bend * std::cos(spin), 0.004 * f - 0.3 * frame.time});
      frame.velocity.push_back({-3 * s * std::sin(spin), 3 * s * std::cos(spin), -0.3 - 0.01 * i + 0.02 * f});
      frame.radius.push_back(radius);
      frame.fiber.push_back(f);
      if (i == 0) continue;
      const auto first = static_cast<std::int64_t>(frame.position.size()) - 2;
      frame.bonds.push_back({first, {1e-3 * i, -2e-4 * f, 1e-5 * static_cast<double>(step)}, 0.01 * i + 1e-4 * f + frame.time});
    }
  }
  return frame;
}

}  // namespace fiberchain::test
