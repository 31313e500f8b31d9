// Fibers followed by the leapfrog: one path in every instruction set and beside others, failures, what is
// refused.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/flow_cases.hpp"

BOOST_AUTO_TEST_SUITE(flow_leapfrog_test)

namespace dem = fiberchain::dem;
using flowing::end_state;
using flowing::equal_times;
using flowing::fiber_of;
using flowing::path;
using flowing::straight_case;
using flowing::viscosity_of;

namespace {

template <int Dim>
void one_chain_in_every_width(dem::BondForm form, double damping, const dem::Flow& undisturbed) {
  const dem::Fiber fiber = fiber_of(13, damping);
  const double t_b = dem::bond_time_step(fiber);
  auto flow = straight_case<Dim>(fiber, {viscosity_of(fiber, 0.2 / t_b), undisturbed}, 2.0, 0.4);
  flow.boundary.loads = {{5, {}, {}}};
  flow.boundary.loads[0].force[1] = dem::load_force(fiber, 1);
  dem::FlowOptions options;
  options.form = form;
  const auto wide = end_state(flow, {110 * t_b, 250 * t_b}, options);
  for (const auto set : dem::available_instruction_sets()) {
    options.instruction_set = set;
    const auto other = end_state(flow, {110 * t_b, 250 * t_b}, options);
    BOOST_TEST(flowing::distance(wide, other, fiber) < 1e-11);
    BOOST_TEST(dem::norm(wide.spin[3] - other.spin[3]) * t_b < 1e-11);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_instruction_set_gives_the_same_path) {
  const double t_b = dem::bond_time_step(fiber_of(13));
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const double damping : {0.0, 0.4}) {
      for (const auto& flow : {dem::Flow{dem::simple_shear(0.01 / t_b)},
                               dem::start_up(dem::simple_shear(0.01 / t_b), 40 * t_b)}) {
        one_chain_in_every_width<2>(form, damping, flow);
        one_chain_in_every_width<3>(form, damping, flow);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_chain_that_blows_up_says_where_and_keeps_what_came_before) {
  const dem::Fiber fiber = fiber_of(8);
  const double t_b = dem::bond_time_step(fiber);
  const auto flow =
      straight_case<2>(fiber, {viscosity_of(fiber, 0.1 / t_b), {dem::simple_shear(1e-3 / t_b)}}, 1.0);
  dem::FlowOptions options;
  options.step_ratio = 1.2 * dem::stable_time_step(fiber, flow.fluid) / t_b;
  BOOST_CHECK_EXCEPTION(path(flow, {500 * t_b}, options), dem::InvalidInput, [](const auto& e) {
    return std::string(e.what()).find("largest stable step") != std::string::npos;
  });
  options.allow_unstable = true;
  const auto way = path(flow, equal_times(3000 * t_b, 300), options);
  BOOST_TEST(way.record.failure.find("beyond the stable one") != std::string::npos);
  BOOST_TEST(way.record.failure.find("sphere") != std::string::npos);
  BOOST_REQUIRE(!way.states.empty());
  BOOST_TEST(way.states.size() < 300u);
  BOOST_TEST(way.record.reached >= way.times.back());
  BOOST_TEST(way.record.reached < way.times.back() + 10 * t_b);
  for (const auto& state : way.states) BOOST_TEST(std::isfinite(dem::norm(state.velocity[3])));
}

namespace {

template <int Dim>
std::vector<flowing::Path<Dim>> many_paths(const std::vector<dem::FlowJob<Dim>>& jobs,
                                           const dem::FlowOptions& options) {
  std::vector<flowing::Path<Dim>> paths(jobs.size());
  const auto records = dem::leapfrog_many_in_flow<Dim>(
      jobs, options, [&](std::size_t job, double time, const dem::ChainState<Dim>& state) {
        paths[job].times.push_back(time);
        paths[job].states.push_back(state);
      });
  for (std::size_t i = 0; i < jobs.size(); ++i) paths[i].record = records[i];
  return paths;
}

/// Fibers of two lengths in flows of their own; the one numbered 2 is beyond its stable step at t_b.
template <int Dim>
std::vector<dem::FlowJob<Dim>> odd_jobs() {
  std::vector<dem::FlowJob<Dim>> jobs;
  for (int i = 0; i < 7; ++i) {
    const dem::Fiber fiber = fiber_of(i == 4 ? 6 : 9);
    const double t_b = dem::bond_time_step(fiber), rate = i == 2 ? 1e-4 : 2.0 + 0.4 * i;
    const dem::Gradient A = dem::simple_shear(0.01 * (1 + i) / t_b);
    const dem::Flow flow = i % 2 ? dem::start_up(A, 30 * t_b) : dem::Flow{A};
    jobs.push_back({straight_case<Dim>(fiber, {viscosity_of(fiber, rate / t_b), flow}, 2.0 + 0.1 * i, 0.3),
                    {0, 13.3 * t_b, 300 * t_b, 500 * t_b}});
  }
  return jobs;
}

template <int Dim>
void side_by_side_as_alone() {
  const auto jobs = odd_jobs<Dim>();
  dem::FlowOptions options;
  options.step_ratio = 1;
  options.allow_unstable = true;
  const auto together = many_paths(jobs, options);
  const auto few = many_paths<Dim>({jobs[0], jobs[6]}, options);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto alone = path(jobs[i].flow, jobs[i].times, options);
    BOOST_TEST(together[i].record.failure.empty() == (i != 2));
    BOOST_TEST(alone.record.failure.empty() == (i != 2));
    if (i == 2) continue;  // what grows starts from round-off
    BOOST_TEST(together[i].record.work.steps == alone.record.work.steps);
    BOOST_REQUIRE(together[i].states.size() == alone.states.size());
    for (std::size_t n = 0; n < alone.states.size(); ++n) {
      BOOST_TEST(flowing::distance(together[i].states[n], alone.states[n], jobs[i].flow.chain.fiber) < 1e-11);
    }
  }
  BOOST_TEST(together[2].states.size() < 4u);
  BOOST_TEST(flowing::distance(together[0].states[3], few[0].states[3], jobs[0].flow.chain.fiber) == 0.0);
  BOOST_TEST(flowing::distance(together[6].states[3], few[1].states[3], jobs[6].flow.chain.fiber) == 0.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(fibers_side_by_side_go_as_each_alone) {
  side_by_side_as_alone<2>();
  side_by_side_as_alone<3>();
}

namespace {

/// How far the stiff leapfrog at `ratio` t_b ends from CVODE, over L and in turns.
template <int Dim>
double stiff_error(double ratio) {
  const dem::Fiber fiber = fiber_of(13, 0.4);
  const double t_b = dem::bond_time_step(fiber);
  const auto flow = straight_case<Dim>(
      fiber, {viscosity_of(fiber, 0.005 / t_b), {dem::simple_shear(4e-4 / t_b)}}, 1.0, Dim == 3 ? 0.4 : 0.0);
  const std::vector<double> times{2400 * t_b};
  dem::FlowOptions stiff, exact;
  stiff.method = dem::FlowMethod::leapfrog_stiff;
  stiff.step_ratio = ratio;
  exact.method = dem::FlowMethod::cvode;
  exact.tolerance = 1e-11;
  const auto a = path(flow, times, stiff);
  BOOST_TEST(a.record.failure == "");
  std::vector<dem::ChainState<Dim>> end;
  dem::integrate_in_flow<Dim>(flow, times, exact,
                              [&](double, const dem::ChainState<Dim>& s) { end.push_back(s); });
  return flowing::distance(a.states[0], end[0], fiber);
}

}  // namespace

/// With inertia, drag and bonds solved for together: second order by three steps, far beyond the bond's own.
BOOST_AUTO_TEST_CASE(bonds_that_are_solved_for_in_a_fluid_have_second_order) {
  const auto follows = [](double coarse, double middle, double fine) {
    const double order = std::log2((coarse - middle) / (middle - fine));
    BOOST_TEST_MESSAGE("errors " << coarse << ", " << middle << ", " << fine << ", order " << order);
    BOOST_TEST(coarse < 1e-4);
    BOOST_TEST(std::abs(order - 2) < 0.1);
  };
  follows(stiff_error<2>(18), stiff_error<2>(9), stiff_error<2>(4.5));
  follows(stiff_error<3>(18), stiff_error<3>(9), stiff_error<3>(4.5));
}

BOOST_AUTO_TEST_CASE(counts_its_work_and_takes_whole_steps_to_each_time) {
  const dem::Fiber fiber = fiber_of(8);
  const double t_b = dem::bond_time_step(fiber);
  const auto flow =
      straight_case<3>(fiber, {viscosity_of(fiber, 0.1 / t_b), {dem::simple_shear(1e-3 / t_b)}}, 1.0);
  dem::FlowOptions options;
  options.step_ratio = 0.5;
  const auto way = path(flow, {0, 10 * t_b, 11.7 * t_b, 2000 * t_b}, options);
  BOOST_TEST(way.states.size() == 4u);
  BOOST_TEST(way.record.failure == "");
  BOOST_TEST(way.record.work.steps == 20 + 4 + 3977.0);
  BOOST_TEST(way.record.work.bond_evaluations == 8 * way.record.work.steps);
  BOOST_TEST(std::abs(way.record.time_step - 0.5 * t_b) < 1e-9 * t_b);
  BOOST_TEST(way.record.reached == 2000 * t_b);
  BOOST_TEST(flowing::distance(way.states[0], {flow.start, {}, {}}, fiber) == 0.0);
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_built) {
  const dem::Fiber fiber = fiber_of(8);
  const auto good = straight_case<2>(fiber, {1e-3, {dem::simple_shear(1)}}, 1.0);
  const auto refuses = [](const dem::FlowCase<2>& flow, const std::string& what,
                          dem::FlowOptions options = {}) {
    BOOST_CHECK_EXCEPTION(path(flow, {1e-4}, options), dem::InvalidInput, [&](const auto& e) {
      return std::string(e.what()).find(what) != std::string::npos;
    });
  };
  auto bad = good;
  bad.fluid.hydrodynamics = dem::Hydrodynamics::interactions;
  refuses(bad, "hydrodynamics = interactions");
  bad = good, bad.chain.fiber.rolling_friction = 0.2;
  refuses(bad, "rolling_friction = 0.2");
  bad = good, bad.boundary.clamped = {3};
  refuses(bad, "clamped = 3");
  bad = good, bad.boundary.loads = {{9, {}, {}}};
  refuses(bad, "load at sphere 9");
  bad = good, bad.fluid.viscosity = 0;
  refuses(bad, "viscosity = 0");
  bad = good, bad.start.pop_back();
  refuses(bad, "start = 8 poses");
  bad = good, bad.chain = dem::cornered_chain<2>(fiber, 3);
  dem::FlowOptions incremental;
  incremental.form = dem::BondForm::incremental;
  refuses(bad, "form = incremental", incremental);
  dem::FlowOptions still;
  still.step_ratio = 0;
  refuses(good, "step_ratio = 0", still);
}

BOOST_AUTO_TEST_CASE(lanes_without_fluid_refuse_one) {
  const dem::Fiber fiber = fiber_of(3);
  const dem::Fluid fluid{1e-3, {dem::simple_shear(1)}};
  dem::ChainBatch<3> block({dem::straight_chain<3>(fiber)}, {false, false},
                           {0.5 * dem::bond_time_step(fiber)}, {0.0},
                           {3, dem::BondForm::total, false, false, false}, dem::InstructionSet::scalar);
  BOOST_CHECK_THROW(block.set_fluid(0, fluid), dem::InvalidInput);
  BOOST_CHECK_THROW(block.set_loads(0, {}), dem::InvalidInput);
  dem::Physics both{3, dem::BondForm::total, false, true, false};
  both.fluid = true;
  BOOST_CHECK_THROW(dem::chain_kernel(both, dem::InstructionSet::scalar), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
