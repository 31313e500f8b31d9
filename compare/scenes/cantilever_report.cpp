#include <fmt/format.h>

#include <cmath>

#include "compare/measure/strain.hpp"
#include "compare/scenes/cantilever.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "reference/elastica.hpp"

namespace fiberchain::compare {
namespace {

using dem::CantileverScene;

/// Whether the Elastica under a load across it is this scene's reference.
bool has_elastica(const CantileverScene& scene) {
  return scene.gravity == std::array<double, 3>{} && std::abs(scene.direction[0]) < 1e-15 && scene.load > 0 &&
         scene.load <= reference::max_elastica_load;
}

/// Missing where the Elastica is no reference.
dem::NamedRow elastica_cells(const CantileverScene& scene, const Station& tip) {
  const reference::TipState elastica =
      has_elastica(scene) ? reference::elastica_shooting(scene.load) : reference::TipState{nan, nan, nan};
  const double x = 1 - tip.x;
  return {{"elastica_tip_y", elastica.y},
          {"elastica_tip_x", elastica.x},
          {"elastica_tip_angle", elastica.angle},
          {"departure_y", tip.y / elastica.y - 1},
          {"departure_x", x / elastica.x - 1},
          {"departure_angle", tip.angle / elastica.angle - 1},
          {"departure_distance", std::hypot(tip.y - elastica.y, x - elastica.x, tip.z)}};
}

dem::Cell cell_of(const std::optional<std::int64_t>& count) {
  return count ? dem::Cell(*count) : dem::Cell(dem::Missing{});
}

}  // namespace

double strain_bound(const CantileverScene& scene) {
  const auto& g = scene.gravity;
  return strain_bound(scene.fiber, scene.load, dem::fiber_mass(scene.fiber) * std::hypot(g[0], g[1], g[2]));
}

dem::Table cantilever_table(const CantileverScene& scene, const CantileverRest& rest) {
  const Station& tip = rest.spheres.back();
  const bool marched = scene.method == dem::Method::march;
  const dem::NamedRow asked = {
      {"aspect_ratio", std::llround(dem::slenderness(scene.fiber))},
      {"poisson_ratio", dem::known(dem::poisson_ratio(scene.fiber.material))},
      {"load", scene.load},
      {"bond", std::string(name(scene.fiber.bond_model))},
      {"form", std::string(name(scene.march.form))},
      {"method", std::string(name(scene.method))},
      {"dimension", std::string(name(scene.dimension))},
      {"bond_damping", marched ? scene.march.bond_damping : scene.fiber.bond_damping},
      {"tip_y", tip.y},
      {"tip_x", 1 - tip.x},
      {"tip_z", tip.z},
      {"tip_angle", tip.angle}};
  const dem::NamedRow end = {{"largest_strain", strain_bound(scene)},
                             {"residual", rest.residual},
                             {"stability", std::string(name(rest.stability))},
                             {"iterations", cell_of(rest.iterations)},
                             {"steps", cell_of(rest.steps)},
                             {"run_time", rest.run_time}};
  return table_of(joined(joined(asked, elastica_cells(scene, tip)), end));
}

dem::Table shape_table(const CantileverRest& rest) {
  dem::Table table({"sphere", "position_x", "position_y", "position_z", "angle"});
  for (std::size_t i = 0; i < rest.spheres.size(); ++i) {
    const Station& at = rest.spheres[i];
    table.append({{"sphere", static_cast<std::int64_t>(i)},
                  {"position_x", at.x},
                  {"position_y", at.y},
                  {"position_z", at.z},
                  {"angle", at.angle}});
  }
  return table;
}

Figure shape_figure(const CantileverScene& scene, const CantileverRest& rest) {
  Series chain{.label = "spheres of the chain", .x = {}, .y = {}};
  for (const Station& at : rest.spheres) chain.add(at.x, at.y);
  Figure figure{
      .title = fmt::format("Cantilever, {{/:Italic r_f}} = {}, {{/:Italic PL}}^2/({{/:Italic EI}}) = {:.4g}",
                           dem::slenderness(scene.fiber), scene.load),
      .x = {.label = "{/:Italic x}/{/:Italic L}"},
      .y = {.label = "{/:Italic y}/{/:Italic L}"},
      .series = {chain}};
  if (has_elastica(scene)) {
    const reference::BeamShape elastica = reference::elastica_shape(scene.load, 101);
    figure.series.front().mark = Mark::points;
    figure.series.insert(figure.series.begin(),
                         {.label = "Elastica", .x = elastica.x, .y = elastica.y, .mark = Mark::line});
  }
  figure.equal_axes = true;
  return figure;
}

}  // namespace fiberchain::compare
