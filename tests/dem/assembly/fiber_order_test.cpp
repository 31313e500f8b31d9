// The order of fibers in memory: along a curve in space, sorted again as they mix, and nothing of it to be
// seen from outside.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/assembly/fiber_order.hpp"
#include "dem/math/hilbert_curve.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(fiber_order_test)

using namespace scenes;

namespace {

using Cell = std::array<std::uint32_t, 3>;

/// Two streams of fibers through each other, of two kinds that are each worth sorting, in a periodic room.
SmallPacking streams() {
  const V period{0.0713, 0.0657, 0};
  const double height = 0.06;
  dem::Domain around;
  around.period = period;
  around.walls = {side({0, 0, 0}, {0, 0, 1}), side({0, 0, height}, {0, 0, -1})};
  SmallPacking packing = small_packing(470, 300, {{0, 0, 0}, {period[0], period[1], height}}, around);
  for (dem::FiberGroup& group : packing.groups) {
    for (std::size_t f = 0; f < group.fibers.size(); ++f) {
      for (V& v : group.fibers[f].velocity) v = {f % 2 == 0 ? 2.5 : -2.5, 0.2, 0};
    }
  }
  return packing;
}

constexpr std::int64_t steps = 1200;

/// Some spheres are held and shaken, and one is loaded.
dem::AssemblyOptions options(bool sort, int threads = 1) {
  dem::Grip shaken, loaded;
  shaken.place = {true, true, true};
  shaken.body.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 2e-4, 200, 0.3, 0.001};
  shaken.spheres = {{0, 7, 2}, {1, 200, 13}, {0, 461, 8}};
  loaded.force = {1e-4, 0, 2e-4}, loaded.spheres = {{1, 33, 0}};
  return {.step = 6e-6,
          .threads = threads,
          .account_energy = true,
          .sort_in_space = sort,
          .grips = {shaken, loaded}};
}

dem::Assembly marched(const dem::AssemblyOptions& how, std::int64_t count) {
  dem::Assembly assembly = streams().assembly(how);
  assembly.march(count);
  return assembly;
}

/// The largest difference over the largest number.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size());
  double most = 0, scale = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    most = std::max(most, std::abs(a[n] - b[n])), scale = std::max(scale, std::abs(a[n]));
  return most / scale;
}

std::vector<double> energies(const dem::Assembly& assembly) {
  const dem::EnergyBalance energy = assembly.energy();
  std::vector<double> all;
  for (const dem::EnergyMechanism& mechanism : dem::energy_mechanisms) all.push_back(energy.*mechanism.value);
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_curve_goes_from_face_to_face_through_every_cell) {
  for (const Cell& corner : {Cell{0, 0, 0}, Cell{1024, 512, 40}, Cell{65528, 65528, 65528}}) {
    std::vector<std::pair<std::uint64_t, Cell>> cells;
    for (std::uint32_t x = 0; x < 8; ++x) {
      for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t z = 0; z < 8; ++z) {
          const Cell cell{corner[0] + x, corner[1] + y, corner[2] + z};
          cells.emplace_back(dem::hilbert_index(cell), cell);
        }
      }
    }
    std::ranges::sort(cells);
    for (std::size_t n = 1; n < cells.size(); ++n) {
      BOOST_TEST(cells[n].first == cells[n - 1].first + 1);
      int apart = 0;
      for (int c = 0; c < 3; ++c)
        apart += std::abs(static_cast<int>(cells[n].second[c]) - static_cast<int>(cells[n - 1].second[c]));
      BOOST_TEST(apart == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_order_has_every_fiber_once) {
  const dem::FiberOrder order({2, 0, 3, 1});
  for (int place = 0; place < 4; ++place) BOOST_TEST(order.place(order.fiber(place)) == place);
  BOOST_TEST(order.place(3) == 2);
  BOOST_CHECK_THROW(dem::FiberOrder({0, 2, 2}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::FiberOrder({0, 3, 1}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::FiberOrder({0, -1, 1}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(fibers_near_each_other_follow_each_other) {
  std::vector<V> corners;
  for (int n = 0; n < 40; ++n) corners.push_back({n % 2 * 3.0 + 0.01 * (n / 2), 0.003 * n, 0});
  const dem::FiberOrder order = dem::order_in_space(corners, {});
  for (int place = 0; place < 40; ++place)
    BOOST_TEST(order.fiber(place) % 2 == order.fiber(place < 20 ? 0 : 39) % 2);
  // whole periods do not count
  for (std::size_t n = 0; n < corners.size(); ++n) corners[n][0] += 3.7 * static_cast<double>(n % 3);
  BOOST_TEST((dem::order_in_space(corners, {3.7, 0, 0}).fibers() == order.fibers()));
}

/// Sums are formed in another order: the same to round-off, which collisions enlarge.
BOOST_AUTO_TEST_CASE(sorting_changes_nothing_but_round_off) {
  dem::Assembly sorted = marched(options(true), steps), as_numbered = marched(options(false), steps);
  BOOST_TEST(sorted.sort_count() >= 1);
  BOOST_TEST(as_numbered.sort_count() == 0);
  BOOST_TEST_REQUIRE(sorted.touching() > 50);
  BOOST_TEST(difference(numbers(sorted), numbers(as_numbered)) < 1e-7);
  BOOST_TEST(difference(energies(sorted), energies(as_numbered)) < 1e-9);
  const auto contacts = sorted.contacts(), others = as_numbered.contacts();
  BOOST_TEST_REQUIRE(contacts.size() == others.size());
  double largest = 0;
  for (const auto& contact : others) largest = std::max(largest, dem::norm(contact.force));
  std::vector<dem::ContactState> by_key = others;
  std::ranges::sort(by_key, {}, &dem::ContactState::key);
  for (std::size_t n = 0; n < contacts.size(); ++n) {
    BOOST_TEST((contacts[n].key == by_key[n].key));
    BOOST_TEST(dem::norm(contacts[n].force - by_key[n].force) < 1e-6 * largest);
  }
  const auto placed = sorted.placed(), other = as_numbered.placed();
  for (std::size_t i = 0; i < placed.radius.size(); ++i) {
    BOOST_TEST_REQUIRE(dem::norm(placed.position[i] - other.position[i]) < 1e-9);
    BOOST_TEST_REQUIRE(placed.radius[i] == other.radius[i]);
  }
}

namespace {

/// The streams with bonds that may break, some of which do.
dem::Assembly broken_streams(bool sorted) {
  SmallPacking packing = streams();
  for (dem::FiberGroup& group : packing.groups)
    group.chain.fiber.strength =
        dem::BondStrength{.tension = 1e3 * group.chain.fiber.material.youngs_modulus};
  dem::Assembly assembly = packing.assembly(options(sorted));
  for (int f = 0; f < 300; f += 60) assembly.break_bond(0, f, f % 8), assembly.break_bond(1, f, f % 13);
  assembly.march(steps);
  return assembly;
}

}  // namespace

/// Fibers and what is left of them go to their new places: pieces touch each other and nothing else changes.
BOOST_AUTO_TEST_CASE(sorting_keeps_what_is_broken) {
  dem::Assembly sorted = broken_streams(true), as_numbered = broken_streams(false);
  BOOST_TEST(sorted.sort_count() >= 1);
  BOOST_TEST(sorted.pieces() == 770 + 2 * 5);
  for (const int group : {0, 1}) {
    for (int f = 0; f < 300; ++f) {
      for (int i = 0; i < 8; ++i)
        BOOST_TEST(sorted.is_broken(group, f, i) == as_numbered.is_broken(group, f, i));
    }
  }
  const auto contacts = sorted.contacts(), others = as_numbered.contacts();
  BOOST_TEST(contacts.size() == others.size());
  const auto between_pieces = [](const dem::ContactState& contact) {
    return dem::is_sphere(contact.key.second) && contact.key.second.number == contact.key.first.number + 1;
  };
  BOOST_TEST_MESSAGE(std::ranges::count_if(contacts, between_pieces) << " contacts between pieces");
  BOOST_TEST(std::ranges::count_if(contacts, between_pieces) ==
             std::ranges::count_if(others, between_pieces));
  BOOST_TEST(difference(numbers(sorted), numbers(as_numbered)) < 1e-7);
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const dem::SavedState one = marched(options(true), steps).saved();
  for (const int threads : {2, 3}) BOOST_TEST((marched(options(true, threads), steps).saved() == one));
}

BOOST_AUTO_TEST_CASE(a_restored_run_is_sorted_as_the_whole_one) {
  dem::Assembly whole = streams().assembly(options(true));
  std::vector<dem::SavedState> on_the_way;
  for (int n = 0; n < 4; ++n) {
    on_the_way.push_back(whole.saved());
    whole.march(steps / 4);
  }
  for (int n = 0; n < 4; ++n) {
    dem::Assembly again = streams().assembly(options(true));
    again.restore(on_the_way[n]);
    again.march((4 - n) * steps / 4);
    BOOST_TEST((again.saved() == whole.saved()), "from piece " << n);
  }
}

BOOST_AUTO_TEST_CASE(an_order_that_is_none_is_refused) {
  dem::Assembly assembly = streams().assembly(options(true));
  dem::SavedState saved = assembly.saved();
  auto& fibers = std::get<std::vector<std::int64_t>>(saved["fiber_order"].values);
  fibers[3] = fibers[4];
  BOOST_CHECK_EXCEPTION(assembly.restore(saved), dem::InvalidInput, [](const dem::InvalidInput& error) {
    return std::string(error.what()).find("'fiber_order'") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
