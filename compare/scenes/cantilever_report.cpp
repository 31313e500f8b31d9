#include <fmt/format.h>

#include <cmath>

#include "compare/measure/strain.hpp"
#include "compare/scenes/cantilever.hpp"
#include "reference/elastica.hpp"

namespace fiberchain::compare {
namespace {

using dem::CantileverScene;

/// Whether the Elastica under a load across it is this scene's reference.
bool has_elastica(const CantileverScene& scene) {
  return std::abs(scene.direction[0]) < 1e-15 && scene.load > 0 && scene.load <= reference::max_elastica_load;
}

dem::NamedRow elastica_cells(double load, const Station& tip) {
  const reference::TipState elastica = reference::elastica_shooting(load);
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

dem::Table cantilever_table(const CantileverScene& scene, const CantileverRest& rest) {
  const Station& tip = rest.spheres.back();
  const bool marched = scene.method == dem::Method::march;
  dem::NamedRow row = {{"aspect_ratio", scene.fiber.aspect_ratio},
                       {"poisson_ratio", dem::poisson_ratio(scene.fiber.material)},
                       {"load", scene.load},
                       {"bond", std::string(name(scene.fiber.bond_model))},
                       {"form", std::string(name(scene.march.form))},
                       {"method", std::string(name(scene.method))},
                       {"dimension", std::string(name(scene.dimension))},
                       {"bond_damping", marched ? scene.march.bond_damping : scene.fiber.bond_damping},
                       {"tip_y", tip.y},
                       {"tip_x", 1 - tip.x},
                       {"tip_z", tip.z},
                       {"tip_angle", tip.angle},
                       {"largest_strain", strain_bound(scene.fiber, scene.load)},
                       {"residual", rest.residual},
                       {"stability", std::string(name(rest.stability))},
                       {"iterations", cell_of(rest.iterations)},
                       {"steps", cell_of(rest.steps)},
                       {"run_time", rest.run_time}};
  if (has_elastica(scene)) {
    for (auto& cell : elastica_cells(scene.load, tip)) row.push_back(std::move(cell));
  }
  dem::Table table({"aspect_ratio",
                    "poisson_ratio",
                    "load",
                    "bond",
                    "form",
                    "method",
                    "dimension",
                    "bond_damping",
                    "tip_y",
                    "tip_x",
                    "tip_z",
                    "tip_angle",
                    "elastica_tip_y",
                    "elastica_tip_x",
                    "elastica_tip_angle",
                    "departure_y",
                    "departure_x",
                    "departure_angle",
                    "departure_distance",
                    "largest_strain",
                    "residual",
                    "stability",
                    "iterations",
                    "steps",
                    "run_time"});
  table.append(row);
  return table;
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
  for (const Station& at : rest.spheres) {
    chain.x.push_back(at.x);
    chain.y.push_back(at.y);
  }
  Figure figure{
      .title = fmt::format("Cantilever, {{/:Italic r_f}} = {}, {{/:Italic PL}}^2/({{/:Italic EI}}) = {:.4g}",
                           scene.fiber.aspect_ratio, scene.load),
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
