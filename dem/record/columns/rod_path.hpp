#pragma once

#include "dem/record/columns.hpp"

// Equilibria of a rod along a path (scene: rod). Lengths over L, the total length of the bonds.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column rod_path[] = {
    {"path_branch", integer, "1", "0 on the path from load factor 0, 1 on the branch that was left to"},
    {"path_point", integer, "1",
     "number of the point along its path, from 0; of a singular point the one before it"},
    {"path_event", text, "", "limit point or bifurcation, found between path points; empty of a path point"},
    {"load_factor", number, "1",
     "what the loads and prescribed motions that are not steady are multiplied by"},
    {"path_length", number, "1",
     "arc length of the path: root mean square over spheres of displacement / L and rotation, and the load "
     "factor"},
    {"probe_displacement", number, "1", "displacement of the probe along its direction, over L"},
    {"end_x", number, "1", "x of the last sphere, over L"},
    {"end_y", number, "1", "y of the last sphere, over L"},
    {"end_z", number, "1", "z of the last sphere, over L"},
    {"elastic_energy", number, "J", "energy of the bonds"},
    {"path_work", number, "J",
     "work of loads and prescribed motions since the path's first point, trapezoids between path points"},
    {"negative_eigenvalues", integer, "1",
     "negative eigenvalues of the tangent stiffness; of loads without a potential 1 where its determinant is "
     "negative"},
    {"crossing", integer, "1", "change of negative_eigenvalues over a singular point"},
    {"path_points", integer, "1", "points of the path and of the branch"},
    {"limit_points", integer, "1", "limit points found on the path, where the load factor turns"},
    {"bifurcations", integer, "1", "bifurcations found on the path, where another path crosses"},
    {"first_limit", number, "1", "load factor of the path's first limit point"},
    {"first_bifurcation", number, "1", "load factor of the path's first bifurcation"},
};

}  // namespace fiberchain::dem::columns
