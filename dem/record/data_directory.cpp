#include "dem/record/data_directory.hpp"

#include <cstdlib>
#include <vector>

#include "dem/record/build_info.hpp"

namespace fiberchain::dem {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> places(const std::optional<fs::path>& asked) {
  if (asked) return {*asked};
  const char* environment = std::getenv("FIBERCHAIN_DATA");
  if (environment && *environment) return {environment};
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return {program.parent_path() / kInstalledData, kInstallPrefixData, kSourceData};
}

}  // namespace

DataSearch find_data(const std::string& part, const std::optional<fs::path>& asked) {
  DataSearch search;
  std::error_code error;
  for (const fs::path& place : places(asked)) {
    search.tried += (search.tried.empty() ? "" : " or ") + place.lexically_normal().string();
    if (!search.found && fs::is_directory(place / part, error)) search.found = place;
  }
  return search;
}

}  // namespace fiberchain::dem
