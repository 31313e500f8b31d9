#include <boost/test/unit_test.hpp>
#include <fstream>
#include <sstream>

#include "dem/scene/key_reference.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(key_reference_test)

namespace dem = fiberchain::dem;

namespace {

int count_of(const std::vector<dem::KeyDeclaration>& keys) {
  int count = 0;
  for (const dem::KeyDeclaration& key : keys) count += 1 + count_of(key.keys);
  return count;
}

/// A key and all below it have what the page says of them.
void check_documented(const std::vector<dem::KeyDeclaration>& keys, const std::string& path) {
  for (const dem::KeyDeclaration& key : keys) {
    BOOST_TEST(!key.meaning.empty(), path + key.name);
    BOOST_TEST(!key.allowed.empty(), path + key.name);
    BOOST_TEST((key.must || !key.otherwise.empty() || !key.keys.empty()),
               path + key.name + " has no default");
    BOOST_TEST(key.meaning.find('|') == std::string::npos, path + key.name);
    check_documented(key.keys, path + key.name + ".");
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_says_what_it_is) {
  for (const dem::SceneKind& kind : dem::scene_kinds())
    check_documented(kind.keys(), std::string(kind.name) + ": ");
}

BOOST_AUTO_TEST_CASE(every_key_has_a_row) {
  int keys = 0;
  for (const dem::SceneKind& kind : dem::scene_kinds()) keys += count_of(kind.keys());
  std::istringstream page(dem::key_reference());
  int rows = 0;
  for (std::string line; std::getline(page, line);) rows += line.starts_with("| `");
  BOOST_TEST(rows == keys);
}

BOOST_AUTO_TEST_CASE(the_page_of_the_data_directory_is_that_of_the_declarations) {
  std::ifstream file(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/README.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string page = text.str(), begin = "<!-- begin of `fiberchain check --keys` -->\n";
  const auto from = page.find(begin), to = page.find("<!-- end of `fiberchain check --keys` -->");
  BOOST_REQUIRE((from != page.npos && to != page.npos));
  BOOST_TEST(page.substr(from + begin.size(), to - from - begin.size()) == dem::key_reference());
}

BOOST_AUTO_TEST_SUITE_END()
