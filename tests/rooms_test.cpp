// Within dem/ and within compare/ a room includes only rooms below it: nobody has to know the upper ones to
// read a lower one. No source is longer than a reader keeps in mind.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(rooms_test)

namespace fs = std::filesystem;

namespace {

/// From the lowest room to the highest.
const std::vector<std::string> kDem{"math",      "files",       "model",     "mesh",  "material", "simd",
                                    "parallel",  "record",      "bond",      "chain", "motion",   "contact",
                                    "insertion", "equilibrium", "vibration", "flow",  "assembly", "analysis",
                                    "scene",     "trajectory",  "run",       "lammps"};
const std::vector<std::string> kCompare{
    "study",   "figures", "measure",     "static",  "calibration", "identify", "fit",
    "render",  "flow",    "packing",     "press",   "capstan",     "breaking", "stability",
    "spacing", "rods",    "rod_packing", "damping", "friction",    "contact",  "material",
    "bench",   "scenes",  "report",      "python",  "app"};

/// The room of `root` that a line includes; nothing if it includes none.
std::optional<std::string> included_room(const std::string& line, const std::string& root) {
  const std::string start = "#include \"" + root + "/";
  if (!line.starts_with(start)) return std::nullopt;
  return line.substr(start.size(), line.find('/', start.size()) - start.size());
}

bool points_up(const std::vector<std::string>& rooms, const std::string& from, const std::string& to) {
  return std::ranges::find(rooms, to) > std::ranges::find(rooms, from);
}

std::vector<fs::path> sources_of(const fs::path& folder) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".hpp" || extension == ".cpp") sources.push_back(entry.path());
  }
  return sources;
}

/// Sources with more lines: "file: lines".
std::vector<std::string> longer_than(std::ptrdiff_t most, const std::string& root) {
  std::vector<std::string> found;
  for (const fs::path& path : sources_of(fs::path(FIBERCHAIN_SOURCE_DIR) / root)) {
    std::ifstream file(path);
    std::ptrdiff_t lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    if (lines > most) found.push_back(path.string() + ": " + std::to_string(lines));
  }
  return found;
}

/// Arrows up, and rooms that the order does not know: "file: line".
std::vector<std::string> faults(const std::string& root, const std::vector<std::string>& rooms) {
  std::vector<std::string> found;
  const fs::path folder = fs::path(FIBERCHAIN_SOURCE_DIR) / root;
  for (const fs::path& path : sources_of(folder)) {
    const std::string room = fs::relative(path, folder).begin()->string();
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      const auto to = included_room(line, root);
      if (!to) continue;
      const bool known =
          std::ranges::find(rooms, room) != rooms.end() && std::ranges::find(rooms, *to) != rooms.end();
      if (!known || points_up(rooms, room, *to)) found.push_back(path.string() + ": " + line);
    }
  }
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(planted_arrows_are_found) {
  BOOST_TEST(included_room("#include \"dem/contact/contacts.hpp\"", "dem").value() == "contact");
  BOOST_TEST(!included_room("#include \"compare/study/errors.hpp\"", "dem").has_value());
  BOOST_TEST(points_up(kDem, "contact", "assembly"));
  BOOST_TEST(!points_up(kDem, "assembly", "contact"));
  BOOST_TEST(faults("dem", {"math"}).size() > 100);
}

BOOST_AUTO_TEST_CASE(no_room_of_dem_includes_one_above_it) {
  for (const std::string& fault : faults("dem", kDem)) BOOST_ERROR(fault);
}

BOOST_AUTO_TEST_CASE(no_room_of_compare_includes_one_above_it) {
  for (const std::string& fault : faults("compare", kCompare)) BOOST_ERROR(fault);
}

BOOST_AUTO_TEST_CASE(no_source_is_longer_than_350_lines) {
  BOOST_TEST(longer_than(100, "dem").size() > 50);  // it counts
  for (const std::string root : {"dem", "reference", "compare", "tests"}) {
    for (const std::string& source : longer_than(350, root)) BOOST_ERROR(source);
  }
}

BOOST_AUTO_TEST_SUITE_END()
