#include "compare/bench/history_reference.hpp"

#include "dem/bond/dashpot.hpp"
#include "reference/gsl_ode.hpp"

namespace fiberchain::compare {
namespace {

using dem::Vec;

/// State: per free sphere x/L, y/L, angle, and the rates of these by t_b.
class ChainEquations {
 public:
  explicit ChainEquations(const dem::Release<2>& release)
      : release_(release),
        bonds_(release.chain.fiber.aspect_ratio),
        length_(dem::fiber_length(release.chain.fiber)),
        time_(dem::bond_time_step(release.chain.fiber)),
        mass_(dem::sphere_mass(release.chain.fiber)),
        inertia_(dem::sphere_inertia(release.chain.fiber)),
        law_(dem::bond_parameters(release.chain.fiber)) {}

  std::size_t size() const { return 6 * static_cast<std::size_t>(bonds_); }

  std::vector<double> start() const {
    std::vector<double> state(size());
    for (int i = 1; i <= bonds_; ++i) {
      double* at = &state[6 * static_cast<std::size_t>(i - 1)];
      const dem::Pose<double, 2>& pose = release_.start[i];
      const Vec<double, 2> v = release_.velocity.empty() ? Vec<double, 2>{} : release_.velocity[i];
      const double w = release_.spin.empty() ? 0 : release_.spin[i][0];
      const double values[] = {pose.position[0] / length_, pose.position[1] / length_, pose.orientation,
                               v[0] * time_ / length_,     v[1] * time_ / length_,     w * time_};
      std::copy(std::begin(values), std::end(values), at);
    }
    return state;
  }

  void derivative(const double* state, double* rate) const {
    std::vector<Sphere> spheres(static_cast<std::size_t>(bonds_) + 1);
    spheres[0].pose = release_.start[0];
    for (int i = 1; i <= bonds_; ++i) spheres[i] = sphere_at(state + 6 * (i - 1));
    for (int i = 0; i < bonds_; ++i) add_bond(spheres[i], spheres[i + 1]);
    for (int i = 1; i <= bonds_; ++i) {
      const Sphere& s = spheres[i];
      const double* at = state + 6 * (i - 1);
      double* out = rate + 6 * (i - 1);
      for (int c = 0; c < 3; ++c) out[c] = at[3 + c];
      out[3] = s.force[0] / mass_ * time_ * time_ / length_;
      out[4] = s.force[1] / mass_ * time_ * time_ / length_;
      out[5] = s.moment / inertia_ * time_ * time_;
    }
  }

  double time_unit() const { return time_; }

 private:
  struct Sphere {
    dem::Pose<double, 2> pose{};
    Vec<double, 2> velocity{};
    Vec<double, 1> spin{};
    Vec<double, 2> force{};
    double moment = 0;
  };

  Sphere sphere_at(const double* at) const {
    return {{{length_ * at[0], length_ * at[1]}, at[2]},
            {length_ / time_ * at[3], length_ / time_ * at[4]},
            {at[5] / time_}};
  }

  void add_bond(Sphere& a, Sphere& b) const {
    const auto k = dem::bond_kinematics(a.pose, b.pose);
    const auto springs = dem::bond_loads(k, dem::bond_stress(law_, k.separation, k.rotation));
    const Vec<double, 2> separation = b.pose.position - a.pose.position;
    const Vec<double, 2> axis = (1 / dem::norm(separation)) * separation;
    const dem::RelativeMotion<double, 2> motion{b.velocity - a.velocity, 0.5 * (a.spin + b.spin),
                                                b.spin - a.spin};
    const auto loads =
        springs + dem::act_at_middle(separation, dem::dashpot_action(law_, separation, axis, motion));
    a.force = a.force + loads.force_on_first;
    a.moment += loads.moment_on_first[0];
    b.force = b.force - loads.force_on_first;
    b.moment += loads.moment_on_second[0];
  }

  const dem::Release<2>& release_;
  int bonds_;
  double length_, time_, mass_, inertia_;
  dem::BondParameters<double> law_;
};

}  // namespace

std::vector<Vec<double, 2>> tip_path_by_runge_kutta(const dem::Release<2>& release,
                                                    const std::vector<double>& times, double tolerance) {
  const ChainEquations equations(release);
  std::vector<double> state = equations.start();
  reference::detail::OdeIntegrator integrator(
      state.size(), [&](double, const double* now, double* rate) { equations.derivative(now, rate); },
      {tolerance, tolerance, 10000000}, "motion of the released chain");
  std::vector<Vec<double, 2>> path;
  double t = 0;
  for (const double time : times) {
    integrator.advance(t, time / equations.time_unit(), state);
    path.push_back({state[state.size() - 6], state[state.size() - 5]});
  }
  return path;
}

}  // namespace fiberchain::compare
