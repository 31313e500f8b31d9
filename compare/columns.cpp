#include "compare/columns.hpp"

#include <algorithm>
#include <string>

#include "compare/errors.hpp"

namespace fiberchain::compare {
namespace {

using enum CellKind;

// All lengths are relative to L, the total length of the bonds; angles in radians. "Elastica" is the
// inextensible, unshearable rod; "Reissner" the rod with shear and stretch, the chain's continuum limit.
constexpr Column kColumns[] = {
    // What was asked.
    {"aspect_ratio", integer, "1", "r_f = L/d: number of bonds; the chain has one sphere more"},
    {"poisson_ratio", number, "1", "Poisson's ratio nu; the shear modulus is E/(2(1 + nu))"},
    {"load", number, "1", "dead load at the free end, P L^2/(E I)"},
    {"bond", text, "",
     "bond law: paper, or corrected (K_t = 3/4 K_n and a rest length that shortens with bending)"},
    {"form", text, "",
     "form of the bond law: total (from an energy, no history) or incremental (as the paper)"},
    {"method", text, "", "way to the equilibrium: solve (Newton) or march (time steps)"},
    {"dimension", text, "", "planar or spatial"},
    {"bond_damping", number, "1", "xi_b, damping coefficient of a bond"},
    {"step_ratio", number, "1", "time step over t_b = sqrt(m/K_n)"},

    // Free end: chain and references.
    {"tip_y", number, "1", "deflection of the free end along the load, y/L"},
    {"tip_x", number, "1", "shortening of the free end toward the clamp, 1 - x/L"},
    {"tip_angle", number, "rad", "rotation of the free end"},
    {"tip_z", number, "1", "displacement of the free end out of the plane of fiber and load, z/L"},
    {"elastica_tip_y", number, "1", "tip_y of the Elastica"},
    {"elastica_tip_x", number, "1", "tip_x of the Elastica"},
    {"elastica_tip_angle", number, "rad", "tip_angle of the Elastica"},
    {"reissner_tip_y", number, "1", "tip_y of the rod with shear and stretch"},
    {"reissner_tip_x", number, "1", "tip_x of the rod with shear and stretch"},
    {"reissner_tip_angle", number, "rad", "tip_angle of the rod with shear and stretch"},

    // Departure from the Elastica and its budget; the parts add up to the whole.
    {"departure_y", number, "1", "(tip_y - elastica_tip_y)/elastica_tip_y"},
    {"departure_x", number, "1", "(tip_x - elastica_tip_x)/elastica_tip_x"},
    {"departure_angle", number, "1", "(tip_angle - elastica_tip_angle)/elastica_tip_angle"},
    {"departure_distance", number, "1", "distance of the free end from the Elastica's, |dr|/L"},
    {"departure_distance_unstretched", number, "1",
     "the same distance after the part of stretch is taken off"},
    {"order", number, "1", "order in 1/r_f at which departure_distance falls from the row before"},
    {"order_unstretched", number, "1",
     "order in 1/r_f at which departure_distance_unstretched falls from the row before"},
    {"discretization_y", number, "1",
     "part of departure_y from the finite bonds: chain - rod with shear and stretch"},
    {"discretization_x", number, "1", "part of departure_x from the finite bonds"},
    {"discretization_angle", number, "1", "part of departure_angle from the finite bonds"},
    {"shear_y", number, "1", "part of departure_y from shear: rod with shear - Elastica"},
    {"shear_x", number, "1", "part of departure_x from shear"},
    {"shear_angle", number, "1", "part of departure_angle from shear"},
    {"stretch_y", number, "1",
     "part of departure_y from stretch: rod with shear and stretch - rod with shear"},
    {"stretch_x", number, "1", "part of departure_x from stretch"},
    {"stretch_angle", number, "1", "part of departure_angle from stretch"},
    {"history_y", number, "1",
     "part of departure_y from the incremental form: its equilibrium - the total form's"},
    {"history_x", number, "1", "part of departure_x from the incremental form"},
    {"history_angle", number, "1", "part of departure_angle from the incremental form"},
    {"time_step_y", number, "1", "part of departure_y from the time step of the march"},
    {"time_step_x", number, "1", "part of departure_x from the time step of the march"},
    {"time_step_angle", number, "1", "part of departure_angle from the time step of the march"},
    {"leftover_motion_y", number, "1", "part of departure_y from the motion left when the march stopped"},
    {"leftover_motion_x", number, "1", "part of departure_x from the motion left when the march stopped"},
    {"leftover_motion_angle", number, "1",
     "part of departure_angle from the motion left when the march stopped"},

    // Shape of a fiber at rest.
    {"sphere", integer, "1", "number of the sphere, 0 at the clamp"},
    {"position_x", number, "1", "position along the straight fiber, over L"},
    {"position_y", number, "1", "position along the part of the load across the fiber, over L"},
    {"position_z", number, "1", "position across fiber and load, over L"},
    {"angle", number, "rad", "angle of the fiber's axis at the sphere, from x toward y"},

    // What it cost and how it ended.
    {"status", text, "", "converged, or why not"},
    {"residual", number, "1",
     "largest moment out of balance over any cross section, over P L, when the run stopped"},
    {"iterations", integer, "1", "Newton iterations, all load steps together"},
    {"steps", integer, "1", "time steps of the march"},
    {"run_time", number, "s", "wall-clock time of the run"},

    // Validation matrix.
    {"id", text, "", "identifier of the claim or published value, unique"},
    {"feature", text, "", "what is tested"},
    {"reference_kind", text, "", "exact, published, independent method or regression"},
    {"expected", number, "", "value of the reference, in the unit of the row"},
    {"measured", number, "", "value found here, in the unit of the row"},
    {"difference", number, "", "measured - expected"},
    {"tolerance", number, "", "largest |difference| at which the row holds"},
    {"verdict", text, "", "holds, disputed (published, found wrong; see evidence) or fails"},
    {"evidence", text, "", "how the row was measured, and why if it is disputed"},

    // Published values, data/published/*.csv.
    {"quantity", text, "", "the quantity published"},
    {"value", number, "", "its value, in the unit of the row"},
    {"unit", text, "", "unit of the row"},
    {"source", text, "", "where it is published"},
    {"page_or_figure", text, "", "page, figure, table or equation in the source"},
    {"statement", text, "", "the source's words, or what the number stands for"},

    // The dictionary as a table.
    {"column", text, "", "name of a column"},
    {"kind", text, "", "type of the column's cells: number, integer or text"},
    {"meaning", text, "", "meaning of the column"},
};

}  // namespace

std::span<const Column> all_columns() { return kColumns; }

const Column& find_column(std::string_view name) {
  const auto* found = std::ranges::find(kColumns, name, &Column::name);
  if (found == std::end(kColumns)) throw TableError("no column is called '" + std::string(name) + "'");
  return *found;
}

std::string_view to_string(CellKind kind) {
  switch (kind) {
    case number:
      return "number";
    case integer:
      return "integer";
    case text:
      return "text";
  }
  throw TableError("no such kind of cell");
}

}  // namespace fiberchain::compare
