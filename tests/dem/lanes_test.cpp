// The closed list of inner loops: every combination, every instruction set of this machine, every lane,
// against the scalar loop.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/model/errors.hpp"
#include "tests/dem/marching_chains.hpp"

BOOST_AUTO_TEST_SUITE(lanes_test)

namespace dem = fiberchain::dem;

namespace {

std::string text(const dem::Physics& p) {
  return std::to_string(p.dimension) + "D " + std::string(dem::name(p.form)) + (p.damped ? " damped" : "") +
         (p.settling_damping ? " drag" : "") + (p.curved ? " curved" : "") +
         (p.solved == dem::Solved::nothing ? "" : " solved " + std::string(name(p.solved))) +
         (p.fluid ? " fluid" : "") +
         (p.rolling == dem::Rolling::none ? "" : " rolling " + std::string(dem::name(p.rolling)));
}

template <int Dim>
void pull_tips(dem::ChainBatch<Dim>& block, const std::vector<dem::Chain<Dim>>& chains) {
  for (int lane = 0; lane < block.lanes(); ++lane) {
    dem::Load<Dim> tip{13, {}, {}};
    tip.force[1] = dem::load_force(chains[lane].fiber, 1.0 + lane);
    block.set_ramp(lane, {}, {{0}, {tip}}, 150);
  }
}

/// All chains one by one in scalar lanes.
template <int Dim>
std::vector<dem::Poses<Dim>> scalar_poses(const std::vector<dem::Chain<Dim>>& chains,
                                          const dem::Physics& physics, dem::Clamps clamps, int steps) {
  std::vector<dem::Poses<Dim>> poses;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    auto block = marching::block_of<Dim>({chains[i]}, clamps, physics, dem::InstructionSet::scalar);
    dem::Load<Dim> tip{13, {}, {}};
    tip.force[1] = dem::load_force(chains[i].fiber, 1.0 + static_cast<double>(i));
    block.set_ramp(0, {}, {{0}, {tip}}, 150);
    marching::stir(block, {chains[i]}, 5 + 97 * static_cast<unsigned>(i), 0.02);
    block.march(steps);
    poses.push_back(block.poses(0));
  }
  return poses;
}

template <int Dim>
void lanes_equal_scalar(const dem::Physics& physics, dem::InstructionSet set) {
  const int width = dem::chain_kernel(physics, set).width;
  std::vector<dem::Chain<Dim>> chains;
  for (int lane = 0; lane < (width > 2 ? width - 1 : width); ++lane) {  // where it can be, one lane unused
    chains.push_back(marching::odd_chain<Dim>(11 + lane, physics.damped ? 0.3 : 0.0, physics.curved));
    if (physics.rolling != dem::Rolling::none) chains.back().fiber.rolling_friction = 0.7;
  }
  const dem::Clamps clamps{true, false};
  auto block = marching::block_of(chains, clamps, physics, set);
  pull_tips(block, chains);
  marching::stir(block, chains, 5, 0.02);
  block.march(80);
  block.march(120);
  const auto expected = scalar_poses(chains, physics, clamps, 200);
  for (std::size_t lane = 0; lane < chains.size(); ++lane) {
    const auto poses = block.poses(static_cast<int>(lane));
    const double L = dem::fiber_length(chains[lane].fiber);
    double worst = 0, moved = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      worst = std::max(worst, dem::norm(poses[i].position - expected[lane][i].position) / L);
      moved = std::max(moved, dem::norm(poses[i].position - chains[lane].poses[i].position) / L);
    }
    // round-off decides a step at which an explicit sign turns where the spin just passes zero: that step
    // shows
    BOOST_TEST(worst < (physics.rolling == dem::Rolling::explicit_sign ? 1e-11 : 1e-12));
    BOOST_TEST(moved > 1e-3);
  }
}

template <int Dim>
void along_equals_scalar(const dem::Physics& physics, dem::InstructionSet set) {
  std::vector<dem::Chain<Dim>> chains{marching::odd_chain<Dim>(17, physics.damped ? 0.3 : 0.0, false)};
  chains[0].fiber.rolling_friction = physics.rolling == dem::Rolling::none ? 0.0 : 0.7;
  const dem::Clamps clamps{false, true};
  auto along = marching::block_of(chains, clamps, physics, set);
  auto scalar = marching::block_of(chains, clamps, physics, dem::InstructionSet::scalar);
  for (auto* block : {&along, &scalar}) {
    dem::Load<Dim> pull{0, {}, {}};
    pull.force[1] = dem::load_force(chains[0].fiber, 1.0);
    block->set_ramp(0, {}, {{13}, {pull}}, 150);
    marching::stir(*block, chains, 5, 0.02);
    block->synchronize();
    block->march(200);
  }
  const double L = dem::fiber_length(chains[0].fiber), P = dem::load_force(chains[0].fiber, 1.0);
  for (int i = 0; i <= 13; ++i) {
    const auto a = along.sphere(0, i), b = scalar.sphere(0, i);
    BOOST_TEST(dem::norm(a.pose.position - b.pose.position) < 1e-12 * L);
    if (i < 13) BOOST_TEST(dem::norm(a.force - b.force) < 1e-7 * P * 13 * 13);
  }
  BOOST_TEST(dem::norm(along.sphere(0, 0).pose.position - chains[0].poses[0].position) > 1e-3 * L);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_combination_is_built_once) {
  for (std::size_t i = 0; i < dem::built_physics.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) BOOST_TEST(!(dem::built_physics[i] == dem::built_physics[j]));
  }
}

BOOST_AUTO_TEST_CASE(every_combination_in_every_width_equals_the_scalar_loop) {
  for (const auto set : dem::available_instruction_sets()) {
    for (const dem::Physics& physics : dem::built_physics) {
      BOOST_TEST_CONTEXT(text(physics) << " " << dem::name(set)) {
        physics.dimension == 2 ? lanes_equal_scalar<2>(physics, set) : lanes_equal_scalar<3>(physics, set);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_chain_along_the_lanes_equals_the_scalar_loop) {
  for (const dem::Physics& physics : dem::built_physics) {
    const auto set = dem::best_instruction_set();
    if (dem::chain_kernel(physics, set).march_single_chain == nullptr) continue;
    BOOST_TEST_CONTEXT(text(physics)) {
      physics.dimension == 2 ? along_equals_scalar<2>(physics, set) : along_equals_scalar<3>(physics, set);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_lane_does_not_depend_on_its_neighbors) {
  const dem::Physics physics{3, dem::BondForm::incremental, true, true, false};
  const auto set = dem::best_instruction_set();
  const int width = dem::chain_kernel(physics, set).width;
  std::vector<dem::Chain<3>> chains;
  for (int lane = 0; lane < width; ++lane) chains.push_back(marching::odd_chain<3>(31 + lane, 0.3, false));
  auto full = marching::block_of(chains, {true, false}, physics, set);
  auto alone = marching::block_of<3>({chains[0]}, {true, false}, physics, set);
  marching::stir(full, chains, 3, 0.02);
  marching::stir(alone, {chains[0]}, 3, 0.02);
  full.march(300);
  alone.march(300);
  for (int i = 0; i <= 13; ++i) {
    for (int c = 0; c < 3; ++c)
      BOOST_TEST(full.sphere(0, i).pose.position[c] == alone.sphere(0, i).pose.position[c]);
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_built) {
  BOOST_CHECK_THROW(
      dem::chain_kernel({3, dem::BondForm::incremental, true, true, true}, dem::InstructionSet::scalar),
      dem::InvalidInput);
  const std::vector<dem::Chain<2>> different{
      marching::odd_chain<2>(1, 0, false),
      dem::straight_chain<2>({marching::odd_fiber(1, 0).material, 0.01, 7})};
  BOOST_CHECK_THROW(
      marching::block_of(different, {true, false}, {2, dem::BondForm::total, false, false, false},
                         dem::best_instruction_set()),
      dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
