// A flow that tears a fiber out: up to which rate its bonds hold it, and that a run beyond says so.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/flow/integrate_in_flow.hpp"
#include "dem/flow/stretch_limit.hpp"

BOOST_AUTO_TEST_SUITE(flow_stretch_test)

namespace dem = fiberchain::dem;

namespace {

dem::Fiber fiber() { return {dem::isotropic_material(0.13e6, 0.17, 870), 1.7e-3, 13}; }

/// Along an extensional flow, `part` of the rate that its bonds bear.
dem::FlowRecord followed(dem::FlowMethod method, double part) {
  dem::FlowCase<3> flow{dem::straight_chain<3>(fiber()), {}, {17, {}}, {}};
  const double rate = part * dem::bearable_stretching(flow.chain.fiber, flow.fluid);
  flow.fluid.flow.gradient = dem::uniaxial_extension(rate);
  flow.start = flow.chain.poses;
  const double half = dem::fiber_length(flow.chain.fiber) / 2;
  for (auto& pose : flow.start) pose.position[0] -= half;
  std::vector<double> times;
  for (int n = 0; n <= 60; ++n) times.push_back(n / (2 * rate));
  return dem::integrate_in_flow<3>(flow, times, {.method = method}, [](double, const dem::ChainState<3>&) {});
}

}  // namespace

BOOST_AUTO_TEST_CASE(bonds_hold_up_to_the_rate_that_is_said) {
  for (const auto method :
       {dem::FlowMethod::inertialess, dem::FlowMethod::cvode, dem::FlowMethod::leapfrog}) {
    BOOST_TEST_CONTEXT(dem::name(method)) {
      const auto held = followed(method, 0.7), torn = followed(method, 1.1);
      BOOST_TEST(held.failure == "");
      const bool leapfrog = method == dem::FlowMethod::leapfrog;  // looks between the samples, too
      BOOST_TEST(torn.failure.find(leapfrog ? "the run blew up: sphere" : "the fiber is torn out: bond") == 0,
                 torn.failure);
      BOOST_TEST(torn.failure.find("1/s along the fiber") != std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_rate_is_that_of_the_slowest_mode_of_beads_on_springs) {
  // the matrix of N beads on a line with springs K has the lowest eigenvalue 4 K sin^2(pi / 2N): by power
  // iteration of (4 - A / K) on sums without their mean
  const int n = 14;
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) x[i] = i - 6.5 + 0.01 * i * i;
  double lowest = 0;
  for (int pass = 0; pass < 20000; ++pass) {
    double mean = 0, size = 0, product = 0;
    for (const double v : x) mean += v / n;
    for (double& v : x) v -= mean, size += v * v;
    std::vector<double> next(n);
    for (int i = 0; i < n; ++i) {
      const double pulled = (i > 0 ? x[i] - x[i - 1] : 0) + (i + 1 < n ? x[i] - x[i + 1] : 0);
      product += x[i] * pulled / size;
      next[i] = (4 * x[i] - pulled) / std::sqrt(size);
    }
    x = next, lowest = product;
  }
  const dem::Fluid fluid{17, {}};
  const double expected =
      dem::bond_stiffness(fiber()).stretch * lowest / dem::stokes_drag(fluid, fiber()).translation;
  BOOST_CHECK_CLOSE_FRACTION(dem::bearable_stretching(fiber(), fluid), expected, 1e-9);
}

BOOST_AUTO_TEST_CASE(stretching_of_flows) {
  BOOST_CHECK_CLOSE_FRACTION(dem::largest_stretching(dem::simple_shear(3.1)), 1.55, 1e-14);
  BOOST_CHECK_CLOSE_FRACTION(dem::largest_stretching(dem::planar_extension(-2.3)), 2.3, 1e-14);
  BOOST_CHECK_SMALL(dem::largest_stretching(dem::solid_rotation(5)), 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
