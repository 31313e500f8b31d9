// Packings of short stiff rods: contacts that bear, the same of few nodes, excluded volumes.
#include "compare/rod_packing/rod_packing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(rod_packing_test)

using namespace fiberchain::compare;

/// Two spheres: 8 volumes; long rods at random: v_ex = pi/2 L^2 d.
BOOST_AUTO_TEST_CASE(excluded_volumes_are_onsagers) {
  using std::numbers::pi;
  BOOST_TEST(std::abs(excluded_volume_ratio(1e-9, pi / 4) - 8) < 1e-6);
  BOOST_TEST(std::abs(excluded_volume_ratio(1e6, pi / 4) / 2e6 - 1) < 1e-5);
  BOOST_TEST(std::abs(excluded_volume_ratio(13, 1) - (4 * 169 / pi / 2 + 26 + 4.0 / 3) / (3.25 + 1.0 / 6)) <
             1e-9);
}

/// 2 x 5 contacts where nothing bears more than it must.
BOOST_AUTO_TEST_CASE(rods_of_few_nodes_pack_as_those_of_many) {
  RodPackingCase asked{.aspect_ratio = 6, .spacing = 2, .fibers = 60, .pressure = 3e-4, .looks = 20};
  const RodPacking few = pack_rods(asked);
  asked.spacing = 1;
  const RodPacking many = pack_rods(asked);
  BOOST_TEST_MESSAGE("solid fraction " << few.solid_fraction << ", " << many.solid_fraction << "; contacts "
                                       << few.coordination << ", " << many.coordination << "; sine "
                                       << few.sine << ", " << few.run_time << " s, " << many.run_time
                                       << " s");
  for (const RodPacking& p : {few, many}) {
    BOOST_TEST(p.status == "finished");
    BOOST_TEST(std::abs(p.solid_fraction - 0.6) < 0.07);
    BOOST_TEST(std::abs(p.coordination - 10) < 2);
    BOOST_TEST(std::abs(p.sine - std::numbers::pi / 4) < 0.03);
    // 3 p = contacts a volume x force x distance of the axes: 0.042 were all forces alike and all rods
    // crossed, 0.9 of that with forces spread exponentially, less where rods are near parallel
    BOOST_TEST(std::abs(p.overlap - 0.034) < 0.006);
  }
  BOOST_TEST(few.nodes == 60 * 4);
  BOOST_TEST(std::abs(few.solid_fraction / many.solid_fraction - 1) < 0.05);
  BOOST_TEST(rod_packing_kind_table({few, many}).rows().size() == 2u);
  BOOST_TEST(rod_packing_table({few, many}).rows().size() == 2u);
  BOOST_TEST(to_svg(rod_packing_figure({few, many}), {}).find("φ") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(bonds_are_whole_and_spheres_touch) {
  BOOST_CHECK_THROW(loose_rods({.aspect_ratio = 7, .spacing = 2}), InputError);
  BOOST_CHECK_THROW(loose_rods({.smooth = false, .spacing = 4}), InputError);
  BOOST_TEST(long_bonds(7) == 1);
  BOOST_TEST(long_bonds(24) == 6);
  BOOST_TEST(rod_packing_cases({4, 8}, true, 0, 60, 3).size() == 3u * (2 + 4));
}

BOOST_AUTO_TEST_SUITE_END()
