// The references stay independent of what is held against them: nothing in reference/ includes dem/ or
// compare/.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(reference_boundary_test)

namespace {

/// True for an #include directive of anything in a folder dem or compare.
bool includes_foreign(const std::string& line) {
  std::string text;
  for (const char c : line) {
    if (c != ' ' && c != '\t')
      text += c == '<' || c == '"' ? '/' : c;  // so that every folder starts with a slash
  }
  if (text.rfind("#include/", 0) != 0) return false;
  return text.find("/dem/") != std::string::npos || text.find("/compare/") != std::string::npos;
}

bool links_foreign(const std::string& line) {
  return line.find("fiberchain_dem") != std::string::npos ||
         line.find("fiberchain::dem") != std::string::npos;
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace

BOOST_AUTO_TEST_CASE(planted_includes_are_found) {
  for (const char* line : {"#include \"dem/model/fiber.hpp\"", "  #  include <dem/scene/scene.hpp>",
                           "#include \"../dem/bond.hpp\"", "#include \"dem/record/table.hpp\""}) {
    BOOST_TEST(includes_foreign(line), line);
  }
  for (const char* line : {"#include \"reference/elastica.hpp\"", "// #include is not in dem/",
                           "#include <gsl/gsl_errno.h>", "#include \"reference/pandemic.hpp\""}) {
    BOOST_TEST(!includes_foreign(line), line);
  }
}

BOOST_AUTO_TEST_CASE(reference_includes_and_links_nothing_of_dem_or_compare) {
  int files = 0;
  const std::filesystem::path folder = std::filesystem::path(FIBERCHAIN_SOURCE_DIR) / "reference";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const bool build_file = entry.path().filename() == "CMakeLists.txt";
    for (const std::string& line : lines_of(entry.path())) {
      BOOST_TEST(!includes_foreign(line), entry.path().string() << ": " << line);
      if (build_file) BOOST_TEST(!links_foreign(line), entry.path().string() << ": " << line);
    }
  }
  BOOST_TEST(files > 10);
}

BOOST_AUTO_TEST_SUITE_END()
