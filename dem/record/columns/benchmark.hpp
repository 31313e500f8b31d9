#pragma once

#include "dem/record/columns.hpp"

// What a run costs and how it ends.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column benchmark[] = {
    // What it cost and how it ended.
    {"status", text, "", "converged or finished (and why as it was), or why not"},
    {"residual", number, "1",
     "largest moment out of balance over any cross section, over P L, when the run stopped"},
    {"stability", text, "",
     "of the equilibrium under its dead loads: stable, neutral, unstable, or undecided where the loads have "
     "no "
     "potential (moments in space)"},
    {"iterations", integer, "1", "Newton iterations, all load steps together"},
    {"steps", integer, "1", "time steps of the march"},
    {"run_time", number, "s", "wall-clock time of the run; of its last part where it was resumed"},

    // Run time against error.
    {"problem", text, "", "what is asked, with its load or aspect ratio"},
    {"setting", text, "",
     "what sets the accuracy of the method: time step, tolerance, residual or number of bonds"},
    {"lanes", integer, "1", "chains side by side in the lanes of a vector; times are those of one"},
    {"error", number, "1", "distance from the reference: over L, or relative for xi_f"},
    {"reference_error", number, "1", "error of the reference itself, estimated"},
    {"run_time_median", number, "s", "median of the runs; run_time is the least"},
    {"runs", integer, "1", "warm runs timed; a run of more than 2 s is timed once"},
    {"factorizations", integer, "1", "Newton matrices set up"},
    {"wanted_error", number, "1", "largest error allowed"},
    {"among", text, "", "methods chosen among: all, or those that follow the motion in time"},
    {"run_time_paper", number, "s",
     "run time of the paper's way at the cheapest setting that keeps the error"},
    {"speedup", number, "1", "run_time_paper over run_time"},

    {"period_time", number, "s", "run_time of one period of the first mode"},
    {"times_faster", number, "1",
     "time of the explicit leapfrog at the largest step that is listed, over that here"},
    {"bed", text, "",
     "how fibers lie: falling (none touch) or stack (parallel between tight walls, each sphere in four "
     "contacts)"},
    {"slice", number, "s", "simulated by the steps that were timed; expected_time is extrapolated from it"},

    // What is skipped, and the inner loops.
    {"skipped", text, "", "what a scene does without"},
    {"scene", text, "", "what is left"},
    {"scenes", integer, "1", "pairs of scenes that differ in this alone"},
    {"time_with", number, "s", "time of a bond-step, or of the whole answer, before it is skipped"},
    {"time_without", number, "s", "the same after"},
    {"saving", number, "1", "time_with over time_without; median where there are several scenes"},
    {"saving_least", number, "1", "least saving of these scenes"},
    {"saving_largest", number, "1", "largest saving of these scenes"},
    {"physics", text, "", "dimension, form of the bond law and features of an inner loop"},
    {"instruction_set", text, "", "scalar, avx2 or avx512"},
    {"bond_step_ns", number, "ns",
     "time of a step over bonds and lanes, all lanes full, chains of 11 spheres"},
    {"bond_step_target_ns", number, "ns", "largest bond_step_ns wanted"},
    {"lone_bond_step_ns", number, "ns", "time of a step over bonds, one chain of 11 spheres alone"},
    {"lone_target_ns", number, "ns", "largest lone_bond_step_ns wanted"},
    {"additions", number, "1", "additions and subtractions of a bond-step, counted from the loop"},
    {"multiplications", number, "1", "multiplications of a bond-step"},
    {"fusable", number, "1",
     "of its additions those of a product, one instruction with it where there are fused ones"},
    {"divisions", number, "1", "divisions of a bond-step"},
    {"square_roots", number, "1", "square roots of a bond-step"},
    {"sines", number, "1", "sines and cosines of a bond-step"},
    {"arc_tangents", number, "1", "arc tangents of a bond-step"},
    {"arithmetic_bound_ns", number, "ns",
     "least time of its additions, multiplications and circular functions at the core's measured peak"},
    {"divider_bound_ns", number, "ns",
     "least time of its divisions and square roots, which run beside the others"},
    {"bound_fraction", number, "1", "larger of both bounds over bond_step_ns"},
    {"multiply_add_ns", number, "ns",
     "time of an addition or multiplication, or of both fused, on one double at the core's peak"},
    {"divide_ns", number, "ns", "the same of a division"},
    {"square_root_ns", number, "ns", "the same of a square root"},
    {"sine_ns", number, "ns", "the same of a sine or cosine"},
    {"arc_tangent_ns", number, "ns", "the same of an arc tangent"},
};

}  // namespace fiberchain::dem::columns
