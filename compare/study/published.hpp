#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/study/claimed_range.hpp"

/// Claims the program is held against, published and of its own: data/published/*.csv, a file a subject. What
/// each column is for: data/published/README.md.
namespace fiberchain::compare {

enum class ReferenceKind { exact, published, independent_method, regression };

/// Quantity that the tolerance of a claim is a multiple of.
enum class ToleranceScale {
  unit,   ///< the row's unit
  value,  ///< magnitude of the expected value
  spread  ///< spread of the runs, measured with the value
};

/// What is expected here of the same quantity where the claim's condition does not hold.
struct Otherwise {
  double value, tolerance;  ///< in the unit of the row
};

struct Claim {
  std::string id;       ///< unique over all files
  std::string subject;  ///< file the claim stands in, without its extension
  std::string feature;  ///< what it tests
  ReferenceKind kind;
  std::string quantity;  ///< what is measured
  double value;          ///< expected here, in `unit`; NaN where the measure computes its reference
  double tolerance;      ///< above 0, in units of `scale`
  ToleranceScale scale;
  std::string basis;                  ///< where `value` is from, if it is not from `source`; else "-"
  std::optional<ClaimedRange> range;  ///< for which `statement` is true; none: it is true of `value`
  std::string reading;                ///< how the words became that range; "-" without one
  std::string condition;              ///< under which `value` is measured and the source does not name; "-"
  std::optional<Otherwise> otherwise;
  std::string unit;            ///< "1" where dimensionless
  std::string source;          ///< publication, or derivation
  std::string page_or_figure;  ///< page, figure, table or equation; "-" where there is none
  std::string statement;       ///< the source's words, or what the number stands for; "-" likewise
  std::string evidence;        ///< how it is measured, with {fmt} fields for measured numbers
};

/// The data directory: `asked` if given, else the environment's FIBERCHAIN_DATA, else the one installed
/// beside the program, else the source tree's.
/// @throws InputError naming the looked in if there is none
std::filesystem::path find_data_directory(const std::optional<std::filesystem::path>& asked);

/// All claims in DATA/published/*.csv, files in alphabetical order.
/// @throws InputError naming file, line and column of what is wrong, or an id that comes twice; also if there
/// is no such file
std::vector<Claim> read_all_published(const std::filesystem::path& data_directory);

/// The claim of that id.
/// @throws InputError if there is none
const Claim& find_claim(const std::vector<Claim>& claims, std::string_view id);

/// As the file and the report have it: "independent method".
std::string to_string(ReferenceKind kind);

}  // namespace fiberchain::compare
