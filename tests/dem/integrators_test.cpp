// Every integrator against the others in the limit, with its own order; what the implicit one conserves; what
// happens when a run blows up.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/implicit.hpp"
#include "dem/vibration/choose.hpp"
#include "dem/vibration/release.hpp"

BOOST_AUTO_TEST_SUITE(integrators_test)

namespace dem = fiberchain::dem;

namespace {

dem::Fiber odd_fiber(double bond_damping) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 13, dem::BondModel::corrected, bond_damping};
}

/// First period of a clamped straight beam with the chain's mass, close enough to count samples by.
double period_of(const dem::Fiber& fiber) {
  const double L = dem::fiber_length(fiber), m = dem::sphere_mass(fiber) / dem::bond_length(fiber);
  return 6.283 / (3.516 * std::sqrt(dem::bending_stiffness(fiber) / m) / (L * L));
}

/// Let go from under a dead load at the tip, in space one that bends and twists it out of the plane.
template <int Dim>
dem::Release<Dim> loaded_release(const dem::Fiber& fiber, double load, double periods) {
  dem::Release<Dim> release{dem::straight_chain<Dim>(fiber), {}, {}, {}, period_of(fiber), periods};
  dem::Load<Dim> end{fiber.aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  if constexpr (Dim == 3) {
    end.force[2] = -0.4 * end.force[1];
    end.moment[0] = 0.3 * end.force[1] * dem::fiber_length(fiber);
  }
  release.start = dem::solve_equilibrium(release.chain, dem::Boundary<Dim>{{0}, {end}}).poses;
  return release;
}

template <int Dim>
double distance(const dem::ReleaseRecord<Dim>& a, const dem::ReleaseRecord<Dim>& b, double length) {
  double worst = 0;
  BOOST_REQUIRE_EQUAL(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    worst = std::max(worst, dem::norm(a.samples[i].position - b.samples[i].position) / length);
  }
  return worst;
}

template <int Dim>
dem::ReleaseRecord<Dim> run(const dem::Release<Dim>& release, dem::Integrator integrator,
                            std::optional<double> step_ratio, double tolerance = 1e-6) {
  dem::ReleaseOptions options{.form = dem::BondForm::total,
                              .integrator = integrator,
                              .step_ratio = step_ratio,
                              .tolerance = tolerance};
  options.samples_per_period = 16;
  dem::ReleaseRecord<Dim> record = dem::ring_down<Dim>({release}, options)[0];
  BOOST_TEST(record.failure == "");
  BOOST_TEST(dem::name(record.integrator) == dem::name(integrator));
  return record;
}

/// Observed order in the step of the tip's path, against the implicit and CVODE runs that agree with each
/// other.
template <int Dim>
double order(const dem::Release<Dim>& release, dem::Integrator integrator, double step_ratio,
             const dem::ReleaseRecord<Dim>& exact) {
  const double L = dem::fiber_length(release.chain.fiber);
  const double coarse = distance(run(release, integrator, step_ratio), exact, L);
  const double fine = distance(run(release, integrator, step_ratio / 2), exact, L);
  BOOST_TEST_MESSAGE(Dim << "D " << dem::name(integrator) << " at " << step_ratio << " t_b: error " << coarse
                         << ", halved " << fine << ", order " << std::log2(coarse / fine));
  return std::log2(coarse / fine);
}

template <int Dim>
struct Wild {
  dem::Chain<Dim> chain;
  dem::ChainState<Dim> state;
};

template <int Dim>
Wild<Dim> wild_chain(double bond_damping) {
  const dem::Fiber fiber = odd_fiber(bond_damping);
  Wild<Dim> wild{dem::straight_chain<Dim>(fiber), {}};
  wild.state = dem::at_rest<Dim>(wild.chain.poses);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  const double speed = 0.02 * dem::bond_length(fiber) / dem::bond_time_step(fiber);
  for (auto& v : wild.state.velocity) {
    for (double& c : v.c) c = speed * normal(generator);
  }
  for (auto& w : wild.state.spin) {
    for (double& c : w.c) c = speed / dem::bond_length(fiber) * normal(generator);
  }
  return wild;
}

template <int Dim>
struct Momenta {
  dem::Vec<double, Dim> linear;
  dem::Spin<double, Dim> angular;
};

template <int Dim>
Momenta<Dim> momenta(const dem::Fiber& fiber, const dem::ChainState<Dim>& state) {
  Momenta<Dim> sum{};
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    const auto p = dem::sphere_mass(fiber) * state.velocity[i];
    sum.linear = sum.linear + p;
    sum.angular =
        sum.angular + dem::sphere_inertia(fiber) * state.spin[i] + dem::cross(state.poses[i].position, p);
  }
  return sum;
}

template <int Dim>
void implicit_conserves(double bond_damping, double step_ratio) {
  const Wild<Dim> wild = wild_chain<Dim>(bond_damping);
  const dem::Fiber& fiber = wild.chain.fiber;
  dem::ImplicitMotion<Dim> motion(wild.chain, {}, wild.state, {.tolerance = 1e-12});
  const double before = dem::total_energy(wild.chain, motion.state());
  const Momenta<Dim> start = momenta(fiber, motion.state());
  for (int n = 0; n < 300; ++n) motion.step(step_ratio * dem::bond_time_step(fiber));
  const double after = dem::total_energy(wild.chain, motion.state());
  const Momenta<Dim> end = momenta(fiber, motion.state());
  BOOST_TEST(std::abs(after + motion.dissipated() - before) < 2e-10 * before);
  BOOST_TEST((motion.dissipated() > 0.1 * before) == (bond_damping > 0));
  BOOST_TEST(dem::norm(end.linear - start.linear) < 1e-12 * dem::norm(start.linear));
  const double scale = dem::norm(start.linear) * dem::fiber_length(fiber);
  BOOST_TEST(dem::norm(end.angular - start.angular) < 1e-9 * scale);
}

}  // namespace

BOOST_AUTO_TEST_CASE(implicit_keeps_energy_and_momenta_whatever_the_step) {
  for (const double step_ratio : {0.3, 1.7}) {
    for (const double damping : {0.0, 0.4}) {
      BOOST_TEST_CONTEXT("dt / t_b " << step_ratio << " xi_b " << damping) {
        implicit_conserves<2>(damping, step_ratio);
        implicit_conserves<3>(damping, step_ratio);
      }
    }
  }
}

template <int Dim>
void leapfrog_keeps_energy(dem::BondForm form) {
  const auto release = loaded_release<Dim>(odd_fiber(0), 0.3, 0.5);
  const double bent = dem::elastic_energy(release.chain, release.start);
  const dem::ReleaseOptions options{.form = form, .step_ratio = 0.05, .energy = true};
  const auto record = dem::ring_down<Dim>({release}, options)[0];
  BOOST_TEST(record.failure == "");
  double off = 0;
  for (const auto& sample : record.samples) off = std::max(off, std::abs(sample.energy / bent - 1));
  BOOST_TEST(off < 1e-3);
}

/// What a release counts as energy, of either form, is what the bonds held before.
BOOST_AUTO_TEST_CASE(leapfrog_keeps_the_energy_of_the_bent_chain) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    BOOST_TEST_CONTEXT(dem::name(form)) {
      leapfrog_keeps_energy<2>(form);
      leapfrog_keeps_energy<3>(form);
    }
  }
}

BOOST_AUTO_TEST_CASE(tip_history_at_large_amplitude_has_each_schemes_order_in_the_plane) {
  const auto damped = loaded_release<2>(odd_fiber(0.7), 1.5, 0.8);
  const auto exact = run(damped, dem::Integrator::cvode, {}, 3e-10);
  const auto order_of = [&](dem::Integrator integrator, double step_ratio) {
    return order(damped, integrator, step_ratio, exact);
  };
  BOOST_TEST(std::abs(order_of(dem::Integrator::leapfrog_damped, 0.6) - 2) < 0.1);
  BOOST_TEST(std::abs(order_of(dem::Integrator::implicit, 1) - 2) < 0.1);
  BOOST_TEST(std::abs(order_of(dem::Integrator::leapfrog, 0.2) - 1) <
             0.1);  // dashpots at the lagged velocity
  // without damping all modes live on, which BDF would damp: three steps of the scheme itself
  const auto undamped = loaded_release<2>(odd_fiber(0), 1.5, 0.8);
  const auto coarse = run(undamped, dem::Integrator::leapfrog, 0.1),
             middle = run(undamped, dem::Integrator::leapfrog, 0.05);
  const auto fine = run(undamped, dem::Integrator::leapfrog, 0.025);
  BOOST_TEST(std::abs(std::log2(distance(coarse, middle, 1) / distance(middle, fine, 1)) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(tip_history_at_large_amplitude_has_each_schemes_order_in_space) {
  const auto damped = loaded_release<3>(odd_fiber(0.7), 1.2, 0.6);
  const auto exact = run(damped, dem::Integrator::cvode, {}, 1e-9);
  BOOST_TEST(std::abs(order(damped, dem::Integrator::leapfrog_damped, 0.6, exact) - 2) < 0.1);
  BOOST_TEST(std::abs(order(damped, dem::Integrator::implicit, 1, exact) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(cvode_error_falls_with_its_tolerance) {
  const auto release = loaded_release<2>(odd_fiber(0.7), 1.5, 0.8);
  const double L = dem::fiber_length(release.chain.fiber);
  const auto exact = run(release, dem::Integrator::cvode, {}, 1e-10);
  double last = 1;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const double error = distance(run(release, dem::Integrator::cvode, {}, tolerance), exact, L);
    BOOST_TEST_MESSAGE("CVODE at " << tolerance << ": " << error);
    BOOST_TEST(error < last / 10);
    BOOST_TEST(error > tolerance / 30);
    BOOST_TEST(error < tolerance * 100);
    last = error;
  }
}

BOOST_AUTO_TEST_CASE(automatic_picks_the_cheapest_and_says_why) {
  const auto pick = [](int aspect_ratio, double bond_damping, double error) {
    dem::Fiber fiber = odd_fiber(bond_damping);
    fiber.aspect_ratio = aspect_ratio;
    dem::Release<2> release{dem::straight_chain<2>(fiber), {}, {}, {}, period_of(fiber), 1};
    release.start = release.chain.poses;
    return dem::choose_integrator(release, dem::ReleaseOptions{.error = error});
  };
  BOOST_TEST(dem::name(pick(200, 1, 1e-3).integrator) == "leapfrog-stiff");
  BOOST_TEST(dem::name(pick(8, 0, 1e-4).integrator) == "leapfrog");
  BOOST_TEST(dem::name(pick(8, 5, 1e-5).integrator) == "leapfrog-damped");
  BOOST_TEST(pick(200, 1, 1e-3).reason.find("leapfrog-stiff with dt = ") == 0);
  BOOST_CHECK_THROW(pick(8, 1, 0), dem::InvalidInput);

  // swinging far, bonds that are solved for turn, which makes steps short
  dem::Fiber swinging = odd_fiber(1);
  swinging.aspect_ratio = 10;
  const dem::ReleaseOptions coarse{.error = 1e-2};
  const auto near = dem::choose_integrator(loaded_release<2>(swinging, 1e-3, 1), coarse),
             far = dem::choose_integrator(loaded_release<2>(swinging, 2, 1), coarse);
  BOOST_TEST(dem::name(near.integrator) == "leapfrog-stiff");
  BOOST_TEST(dem::name(far.integrator) == "leapfrog-stiff");
  BOOST_TEST(far.step_ratio < 0.5 * near.step_ratio);

  const auto release = loaded_release<2>(odd_fiber(0.7), 0.1, 1);
  const auto record = dem::ring_down<2>({release}, {.integrator = dem::Integrator::automatic})[0];
  BOOST_TEST(record.reason != "");
  BOOST_TEST(dem::name(record.integrator) != "auto");
}

BOOST_AUTO_TEST_CASE(a_run_that_blows_up_stops_alone_and_says_where) {
  const auto good = loaded_release<2>(odd_fiber(0.1), 0.5, 1);
  dem::Fiber stiff = odd_fiber(1.3);
  auto bad = loaded_release<2>(stiff, 0.5, 1);
  bad.period = good.period;
  dem::ReleaseOptions options{.form = dem::BondForm::total, .step_ratio = 0.5};
  BOOST_CHECK_EXCEPTION(dem::ring_down<2>({bad}, options), dem::InvalidInput,
                        [](const dem::InvalidInput& error) {
                          return std::string(error.what()).find("largest stable step of this chain is 0.1") !=
                                 std::string::npos;
                        });
  options.allow_unstable = true;
  const auto records = dem::ring_down<2>({good, bad}, options);
  BOOST_TEST(records[0].failure == "");
  BOOST_TEST(records[0].samples.size() == 201u);
  for (const char* part : {"fiber 1", "sphere ", "step ", "t = ", "beyond the stable one"}) {
    BOOST_TEST(records[1].failure.find(part) != std::string::npos);
  }
  BOOST_TEST(records[1].samples.size() < 201u);
  BOOST_REQUIRE_EQUAL(records[1].last.poses.size(), 14u);
  for (const auto& pose : records[1].last.poses) BOOST_TEST(std::isfinite(dem::norm(pose.position)));
  const auto alone = dem::ring_down<2>({good}, options)[0];
  for (std::size_t i = 0; i < alone.samples.size(); ++i) {
    BOOST_TEST(dem::norm(alone.samples[i].position - records[0].samples[i].position) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_an_integrator_does_not_know) {
  auto release = loaded_release<2>(odd_fiber(0.1), 0.5, 1);
  release.chain.fiber.rolling_friction = 0.3;
  BOOST_CHECK_THROW(dem::ring_down<2>({release}, {.integrator = dem::Integrator::implicit}),
                    dem::InvalidInput);
  BOOST_CHECK_THROW(dem::ring_down<2>({release}, {.form = dem::BondForm::total}), dem::InvalidInput);
  release.chain.fiber.rolling_friction = 0;
  BOOST_CHECK_THROW(dem::ring_down<2>({release}, {.integrator = dem::Integrator::cvode, .tolerance = 0}),
                    dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
