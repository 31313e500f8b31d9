#pragma once

#include "dem/record/columns.hpp"

// Runs of many fibers, what a scene will take, packings (Figs 11 and 12).
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column packing[] = {
    // How a run of many fibers goes.
    {"step", integer, "1", "time steps done since the start of the scene"},
    {"simulated_time", number, "s", "time since the start of the scene"},
    {"contacts", integer, "1", "pairs that touch: spheres of fibers with each other and with walls"},
    {"kinetic_energy", number, "J", "of all spheres, spin included"},
    {"height", number, "m", "of the packing, as the run defines it"},
    {"step_rate", number, "1/s", "steps over the wall-clock time since the run was begun or resumed"},
    {"time_left", number, "s", "wall-clock time until the last step at that rate"},

    // What a scene will take.
    {"scene_kind", text, "", "kind of the scene"},
    {"bonds", integer, "1", "number of bonds"},
    {"step_from", text, "", "scene, limit of the stable step, or control of the error"},
    {"impact_speed", number, "m/s", "of bodies towards each other, that fibers and walls may come to"},
    {"impact_overlap", number, "1",
     "of single spheres that meet head on at impact_speed without damping, over the smaller radius: the most "
     "of all kinds"},
    {"steps_most", integer, "1", "most time steps of a march that ends when it is at rest"},
    {"step_cost", number, "s", "wall-clock time of a step over the spheres"},
    {"step_cost_from", text, "", "origin of step_cost: a short measurement, or a stated constant"},
    {"expected_time", number, "s", "expected wall-clock time of the run, without output"},
    {"memory", number, "B", "expected memory, at its peak"},
    {"memory_free", number, "B", "memory that the system has available now"},
    {"frames", integer, "1", "frames of the trajectory"},
    {"trajectory_size", number, "B", "expected size of the trajectory before compression"},
    {"checkpoint_size", number, "B", "expected size of both checkpoints"},
    {"log_size", number, "B", "expected size of the log"},
    {"vtk_size", number, "B", "expected size of all VTK files"},

    // Packings, Figs 11 and 12.
    {"stiffness", number, "1", "Young's modulus of fibers and walls over that of the scene"},
    {"contact_modulus", number, "1", "Young's modulus of the fibers in contacts over that of their bonds"},
    {"fibers", integer, "1", "number of fibers"},
    {"side", number, "m", "of the square floor"},
    {"sides", text, "", "of the room: walls or periodic"},
    {"seed", integer, "1", "seed of the random filling"},
    {"step_factor", number, "1",
     "time step over the usual one: the least of 0.8 of the bonds' limit and 0.45 of the contacts'"},
    {"step_set_by", text, "", "which limit is least: bonds, bond damping or contacts"},
    {"bending_mean", number, "rad", "bending angle, mean over all bonds"},
    {"bending_peak", number, "rad", "largest bending_mean"},
    {"bending_peak_time", number, "s", "simulated_time of bending_peak"},
    {"bending_trough", number, "rad", "smallest bending_mean after the peak"},
    {"bending_trough_time", number, "s", "simulated_time of bending_trough"},
    {"bending_plateau", number, "rad", "bending_mean, mean over the last fifth of the time"},
    {"bending_unrest", number, "1",
     "half the distance of the largest bending_mean from the smallest in that fifth, over bending_plateau"},
    {"stage", text, "",
     "of Fig 11: reaching the bottom (lowest mean vertical velocity), densest (first lowest mean height "
     "after that), "
     "expanded (first highest after that) or at rest (last sample)"},
    {"mean_height", number, "m", "of the sphere centers over the floor"},
    {"vertical_speed", number, "m/s", "mean vertical velocity of the spheres, up is positive"},
    {"speed", number, "m/s", "of the spheres, root of the mean square"},
    {"solid_fraction", number, "1",
     "volume of the spheres over that of the room, from the floor to height or of a slab"},
    {"coordination", number, "1", "contacts of a sphere with spheres that it is not bonded to"},
    {"solid_fraction_deviation", number, "1", "standard deviation of one run over the seeds"},
    {"coordination_deviation", number, "1", "likewise"},
    {"bending_deviation", number, "rad", "likewise of bending_plateau"},
    {"contacts_per_fiber", number, "1", "contacts of a fiber with other fibers"},
    {"neighbors_per_fiber", number, "1", "fibers that a fiber touches"},
    {"wall_contacts_per_fiber", number, "1", "contacts of a fiber with walls"},
    {"overlap_largest", number, "1", "largest overlap of a contact over the sphere's radius"},
    {"overlap_mean", number, "1", "overlap of a contact over its smaller radius, mean of those that touch"},
    {"overlap_peak", number, "1", "the deepest overlap since the start, over the smaller radius"},
    {"order_parameter", number, "1",
     "(3 lambda - 1)/2, lambda the largest eigenvalue of <u u> of the bonds: 0 isotropic"},
    {"order_along_up", number, "1",
     "(3 <cos^2> - 1)/2 of the bonds against the vertical: -1/2 level, 1 upright"},
    {"slab_low", number, "m", "height of the lower face of a slab over the floor"},
    {"slab_high", number, "m", "height of its upper face"},
    {"polar_low", number, "rad", "least angle of a bond against the vertical in a class"},
    {"polar_high", number, "rad", "largest angle in it"},
    {"over_isotropic_start", number, "1",
     "share of the bonds in the class over that of an isotropic packing, at the start"},
    {"over_isotropic", number, "1", "the same at rest"},
    {"energy_bonds", number, "J", "elastic, in the bonds"},
    {"energy_contacts", number, "J", "elastic, in the contacts"},
    {"energy_gravity", number, "J", "of height"},
    {"taken_bond_damping", number, "J", "taken by the dashpots of the bonds since the start"},
    {"taken_bond_friction", number, "J", "taken by the rolling friction of the bonds"},
    {"taken_contact_normal", number, "J", "taken by contacts along their normal"},
    {"taken_contact_tangential", number, "J", "taken by contacts along the surface"},
    {"taken_contact_rolling", number, "J", "taken by the rolling friction of contacts"},
    {"taken_fluid", number, "J", "taken by the fluid"},
    {"given_walls", number, "J", "given by walls that move"},
    {"given_inserted", number, "J", "brought by fibers put in later"},
    {"energy_total", number, "J", "stored and taken less given: constant but for errors of the step"},
    {"part", text, "", "of Fig 12: peak, trough or plateau of bending_mean [rad]"},
    {"seeds", integer, "1", "runs that differ in the seed alone"},
    {"mean", number, "", "over the seeds"},
    {"half_width", number, "", "of the two-sided 95 % interval of the mean, Student's t"},
    {"standard_deviation", number, "", "of one run"},
    {"least", number, "", "of the seeds"},
    {"most", number, "", "of the seeds"},
};

}  // namespace fiberchain::dem::columns
