#include "compare/scenes/flow_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/flow/setup.hpp"
#include "compare/flow/turn_detection.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/scene/build_fiber.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"
#include "reference/rigid_chain_mobility.hpp"

namespace fiberchain::compare {
namespace {

using dem::FlowScene;

template <int Dim>
FlowHistory run_in(const FlowScene& scene) {
  return integrate_in_flow_history<Dim>(dem::build_flow<Dim>(scene),
                                        even_times(scene.duration, scene.samples), scene.motion,
                                        std::max(1, scene.samples / scene.shapes));
}

/// C/(1 + C), 1 in the flow plane.
double orbit_constant(const FlowScene& scene, double aspect_ratio, const Triple& direction) {
  if (!scene.shear || !std::isfinite(aspect_ratio)) return nan;
  return reference::bounded_orbit_constant(reference::orbit_constant(aspect_ratio, direction));
}

template <class Value>
double least(const FlowHistory& history, Value value) {
  double found = std::numeric_limits<double>::infinity();
  for (const FlowMoment& m : history.moments) found = std::min(found, value(m));
  return found;
}

std::string status_of(const FlowHistory& history) {
  return history.record.failure.empty() ? "finished" : history.record.failure;
}

}  // namespace

FlowHistory run_flow(const FlowScene& scene) {
  return scene.dimension == dem::Dimension::planar ? run_in<2>(scene) : run_in<3>(scene);
}

double scene_aspect_ratio(const FlowScene& scene) {
  using enum reference::ChainCoupling;
  const int N = scene.fiber.aspect_ratio + 1;
  const auto hydrodynamics = scene.fluid.hydrodynamics;
  if (hydrodynamics == dem::Hydrodynamics::free_draining) return reference::free_draining_aspect_ratio(N);
  if (N > 500) return nan;
  const bool stresslets = hydrodynamics == dem::Hydrodynamics::stresslets;
  return reference::equivalent_aspect_ratio(
      reference::rigid_chain_bretherton({N, stresslets ? force_torque_stresslet : force_torque}));
}

dem::Table flow_table(const FlowScene& scene, const FlowHistory& history) {
  const double r_e = scene_aspect_ratio(scene);
  const auto& work = history.record.work;
  const auto constant = [&](const auto& moments, bool last) {
    return moments.empty() ? nan
                           : orbit_constant(scene, r_e, (last ? moments.back() : moments.front()).direction);
  };
  return table_of(
      {{"aspect_ratio", scene.fiber.aspect_ratio},
       {"spheres", scene.fiber.aspect_ratio + 1},
       {"poisson_ratio", dem::known(dem::poisson_ratio(scene.fiber.material))},
       {"bond", std::string(name(scene.fiber.bond_model))},
       {"form", std::string(name(scene.motion.form))},
       {"dimension", std::string(name(scene.dimension))},
       {"bond_damping", scene.fiber.bond_damping},
       {"hydrodynamics", std::string(name(scene.fluid.hydrodynamics))},
       {"flow_method", std::string(name(scene.motion.method))},
       {"elasto_viscous", elasto_viscous_number(scene.fiber, scene.fluid.viscosity, scene.rate)},
       {"strain", history.record.reached * scene.rate},
       {"period", dem::known(orbit_period(history.moments) * scene.rate)},
       {"orbit_constant", dem::known(constant(history.moments, false))},
       {"orbit_constant_last", dem::known(constant(history.moments, true))},
       {"end_to_end_least", dem::known(least(history, [](const FlowMoment& m) { return m.end_to_end; }))},
       {"bending_angle", dem::known(-least(history, [](const FlowMoment& m) { return -m.bending_angle; }))},
       {"time_step", history.record.time_step},
       {"steps", static_cast<std::int64_t>(work.steps)},
       {"bond_evaluations", static_cast<std::int64_t>(work.bond_evaluations)},
       {"linear_solves", static_cast<std::int64_t>(work.linear_solves)},
       {"factorizations", static_cast<std::int64_t>(work.factorizations)},
       {"run_time", history.run_time},
       {"status", status_of(history)}});
}

dem::Table flow_history_table(const FlowScene& scene, const FlowHistory& history) {
  dem::Table table({"strain", "direction_x", "direction_y", "direction_z", "orbit_constant", "end_to_end",
                    "bending_energy", "bending_angle", "center_x", "center_y", "center_z"});
  const double r_e = scene_aspect_ratio(scene);
  for (const FlowMoment& m : history.moments) {
    table.append({{"strain", m.time * scene.rate},
                  {"direction_x", m.direction[0]},
                  {"direction_y", m.direction[1]},
                  {"direction_z", m.direction[2]},
                  {"orbit_constant", dem::known(orbit_constant(scene, r_e, m.direction))},
                  {"end_to_end", m.end_to_end},
                  {"bending_energy", m.energy},
                  {"bending_angle", m.bending_angle},
                  {"center_x", m.center[0]},
                  {"center_y", m.center[1]},
                  {"center_z", m.center[2]}});
  }
  return table;
}

dem::Table flow_shapes_table(const FlowScene& scene, const FlowHistory& history) {
  dem::Table table({"strain", "sphere", "position_x", "position_y", "position_z"});
  for (const FlowShape& shape : history.shapes) {
    for (std::size_t i = 0; i < shape.spheres.size(); ++i) {
      table.append({{"strain", shape.time * scene.rate},
                    {"sphere", static_cast<std::int64_t>(i)},
                    {"position_x", shape.spheres[i][0]},
                    {"position_y", shape.spheres[i][1]},
                    {"position_z", shape.spheres[i][2]}});
    }
  }
  return table;
}

std::vector<std::pair<std::string, Figure>> flow_scene_figures(const FlowScene& scene,
                                                               const FlowHistory& history) {
  const std::string what = fmt::format(
      "r_f = {}, 3πμ|{{/:Italic A}}|{{/:Italic L}}^4/{{/:Italic EI}} = {:.4g}", scene.fiber.aspect_ratio,
      elasto_viscous_number(scene.fiber, scene.fluid.viscosity, scene.rate));
  Figure shapes{
      "Shapes of the fiber, " + what, {"{/:Italic x}/{/:Italic L}"}, {"{/:Italic y}/{/:Italic L}"}, {}};
  shapes.legend_title = "strain";
  shapes.ordered = shapes.equal_axes = true;
  const std::size_t labeled = std::max<std::size_t>(1, (history.shapes.size() + 11) / 12);
  for (std::size_t i = 0; i < history.shapes.size(); ++i) {
    const FlowShape& shape = history.shapes[i];
    Series s{i % labeled == 0 ? fmt::format("{:.4g}", shape.time * scene.rate) : "", {}, {}, Mark::line};
    for (const Triple& at : shape.spheres) s.add(at[0], at[1]);
    shapes.series.push_back(std::move(s));
  }
  Figure turning{"Direction and extent of the fiber, " + what, {"strain, rate times time"}, {""}, {}};
  const auto add = [&](const char* label, auto value) {
    Series s{label, {}, {}, Mark::line};
    for (const FlowMoment& m : history.moments) s.add(m.time * scene.rate, value(m));
    turning.series.push_back(std::move(s));
  };
  add("p_x", [](const FlowMoment& m) { return m.direction[0]; });
  add("p_y", [](const FlowMoment& m) { return m.direction[1]; });
  if (scene.dimension == dem::Dimension::spatial)
    add("p_z", [](const FlowMoment& m) { return m.direction[2]; });
  add("end to end/{/:Italic L}", [](const FlowMoment& m) { return m.end_to_end; });
  return {{"-shapes", std::move(shapes)}, {"-history", std::move(turning)}};
}

}  // namespace fiberchain::compare
