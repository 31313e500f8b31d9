#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Published values the program is held against: data/published/*.csv.
namespace fiberchain::compare {

struct PublishedValue {
  std::string id;              ///< unique over all files
  std::string feature;         ///< what it tests
  std::string quantity;        ///< what was published
  double value;                ///< in `unit`; NaN where the source makes a statement without a number
  std::string unit;            ///< "1" where dimensionless
  std::string source;          ///< where
  std::string page_or_figure;  ///< page, figure, table or equation
  std::string statement;       ///< the source's words, or what the number stands for
};

/// The data directory: `asked` if given, else the environment's FIBERCHAIN_DATA, else the one installed
/// beside the program, else the source tree's.
/// @throws InputError naming the places snapshot in if there is none
std::filesystem::path find_data_directory(const std::optional<std::filesystem::path>& asked);

/// The values in one file.
/// @throws InputError naming file, line and column of what is wrong, or an id that comes twice
std::vector<PublishedValue> read_published(const std::filesystem::path& file);

/// All values in DATA/published/*.csv, files in alphabetical order.
/// @throws InputError as above, or if there is no such file
std::vector<PublishedValue> read_all_published(const std::filesystem::path& data_directory);

/// The value of that id.
/// @throws InputError if there is none
const PublishedValue& find_published(const std::vector<PublishedValue>& values, std::string_view id);

}  // namespace fiberchain::compare
