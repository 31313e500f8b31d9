#define BOOST_TEST_MODULE mpi_slow_test
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

#include "dem/record/csv.hpp"
#include "dem/run/run_packing.hpp"
#include "dem/scene/scene.hpp"
#include "tests/lammps/mpi_process.hpp"

// 2000 fibers that fall, meet and come to lie on each other, 20 000 steps: what round-off grows to.
BOOST_AUTO_TEST_SUITE(mpi_slow_test)

using namespace fiberchain::dem;
using namespace fiberchain::test::mpi;

namespace {

constexpr const char* kScene = FIBERCHAIN_SOURCE_DIR "/data/scenes/crossed-layers.yaml";

Table log_in(const fs::path& directory) { return read_csv(directory / "crossed-layers-log.csv").table; }

double mean_of(const Table& log, const std::string& column) {
  double sum = 0;
  for (std::size_t row = 0; row < log.rows().size(); ++row) sum += log.number(row, column);
  return sum / static_cast<double>(log.rows().size());
}

}  // namespace

BOOST_AUTO_TEST_CASE(crossed_layers_as_on_one_machine) {
  const Scratch scratch;
  SceneText text = read_scene_text(kScene);
  const PackingEndState end =
      run_scene(text, std::get<PackingScene>(parse_scene(text)), {.directory = scratch.path / "own"});
  BOOST_REQUIRE_MESSAGE(end.finished(), end.failure);
  const Table own = log_in(scratch.path / "own");
  BOOST_TEST(own.number(100, "contacts") > 10000);
  for (const int ranks : {1, 2}) {
    const std::string directory = fmt::format("of-{}", ranks);
    const Outcome outcome = go(scratch, ranks, fmt::format("run {} --out {}", kScene, directory));
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
    const Table log = log_in(scratch.path / directory);
    BOOST_REQUIRE_EQUAL(log.rows().size(), own.rows().size());
    for (const char* column :
         {"height", "kinetic_energy", "energy_bonds", "energy_contacts", "energy_gravity"}) {
      const double off = mean_of(log, column) / mean_of(own, column) - 1;
      BOOST_TEST(std::abs(off) < 1e-9, column << " on " << ranks << " ranks: off by " << off);
      BOOST_TEST_MESSAGE(column << " on " << ranks << " ranks: off by " << off);
    }
    BOOST_TEST(log.number(100, "contacts") == own.number(100, "contacts"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
