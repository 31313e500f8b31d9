#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace fiberchain::dem {

/// Where the project's data are (materials, published values, scenes).
struct DataSearch {
  std::optional<std::filesystem::path> found;
  std::string tried;  ///< the places looked at, in words
};

/// The first that holds `part`, "materials": the directory asked for, else that of $FIBERCHAIN_DATA, else
/// those of the program's installation, of the library's and of the source tree.
DataSearch find_data(const std::string& part,
                     const std::optional<std::filesystem::path>& asked = std::nullopt);

}  // namespace fiberchain::dem
