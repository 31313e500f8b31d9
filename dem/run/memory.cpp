#include "dem/run/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "dem/model/errors.hpp"
#include "dem/run/packing_estimate.hpp"

namespace fiberchain::dem {
namespace {

namespace fs = std::filesystem;

/// The value of "KEY: NUMBER kB" in a file of the system [bytes].
std::optional<double> kibibytes_of(const char* file, const std::string& wanted) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(wanted)) continue;
    try {
      return 1024 * std::stod(line.substr(wanted.size()));
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<double> number_in(const fs::path& path) {
  std::ifstream file(path);
  double number = 0;
  if (file >> number) return number;
  return std::nullopt;  // "max", or no such file
}

void take_least(std::optional<AvailableMemory>& least, double bytes, const char* set_by) {
  bytes = std::max(bytes, 0.0);
  if (!least || bytes < least->bytes) least = {bytes, set_by};
}

/// A control group and those above it, each with its limit.
void take_groups(std::optional<AvailableMemory>& least, const fs::path& root, const fs::path& group,
                 const char* limit, const char* used) {
  constexpr double no_limit = 1e18;  // version 1 writes a huge number
  fs::path at = group.relative_path();
  while (true) {
    const auto most = number_in(root / at / limit), now = number_in(root / at / used);
    if (most && now && *most < no_limit) take_least(least, *most - *now, "limit of the control group");
    if (at.empty()) return;
    at = at.parent_path();
  }
}

void take_control_groups(std::optional<AvailableMemory>& least) {
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      path = line.substr(second + 1);
    if (controllers.empty()) take_groups(least, "/sys/fs/cgroup", path, "memory.max", "memory.current");
    if (controllers.find("memory") != std::string::npos)
      take_groups(least, "/sys/fs/cgroup/memory", path, "memory.limit_in_bytes", "memory.usage_in_bytes");
  }
}

void take_limit(std::optional<AvailableMemory>& least, __rlimit_resource_t resource, const char* used,
                const char* set_by) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  take_least(least, static_cast<double>(limit.rlim_cur) - kibibytes_of("/proc/self/status", used).value_or(0),
             set_by);
}

}  // namespace

std::optional<AvailableMemory> available_memory() {
  std::optional<AvailableMemory> least;
  if (const auto free = kibibytes_of("/proc/meminfo", "MemAvailable:"))
    take_least(least, *free + kibibytes_of("/proc/meminfo", "SwapFree:").value_or(0), "free on this machine");
  take_control_groups(least);
  take_limit(least, RLIMIT_AS, "VmSize:", "limit of the process's address space");
  take_limit(least, RLIMIT_DATA, "VmData:", "limit of the process's data");
  return least;
}

void require_memory(const PackingScene& scene) {
  const double needed = peak(memory_of(scene));
  const auto free = available_memory();
  if (!free || needed <= free->bytes) return;
  throw InvalidInput(
      fmt::format("{} spheres need {:.3g} bytes of memory ({}), {:.3g} bytes ({}) are available ({}): take "
                  "fewer or shorter fibers",
                  spheres_in(scene), needed, bytes_in_words(needed), free->bytes, bytes_in_words(free->bytes),
                  free->set_by));
}

std::string memory_in_words() {
  const auto free = available_memory();
  return free ? fmt::format(": {} are available ({})", bytes_in_words(free->bytes), free->set_by) : "";
}

std::string bytes_in_words(double bytes) {
  const char* units[] = {"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  int unit = 0;
  while (bytes >= 1000 && unit < 6) bytes /= 1000, ++unit;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

}  // namespace fiberchain::dem
