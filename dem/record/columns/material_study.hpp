#pragma once

#include "dem/record/columns.hpp"

// What damps fibers of several materials, in time and by complex moduli.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column material_study[] = {
    {"damper", text, "",
     "what damps the fiber: viscous (dashpots by xi_b), flat (branches, one loss factor over the band) or "
     "thermoelastic (branches in bending); elastic: nothing"},
    {"root_frequency", number, "Hz", "|s|/(2 pi) of the mode's complex root"},
    {"damping_marched", number, "1", "zeta of the mode, chain marched in time at small amplitude"},
    {"damping_root", number, "1", "zeta of the mode by the complex root of the chain's linearization"},
    {"damping_difference", number, "1", "damping_marched over damping_root - 1"},
    {"damping_half_loss", number, "1", "tan delta/2 of the mode at the real frequency |s|"},
    {"damping_series", number, "1", "damping_root with the exact thermoelastic modulus in place of branches"},
    {"viscous_y", number, "1", "free end of the viscous fiber over mode 1's amplitude at the start"},
    {"flat_y", number, "1", "the same of the fiber with a flat loss factor"},
    {"drive_frequency", number, "Hz", "frequency at which one bond is bent to and fro"},
    {"cycle_loss", number, "1",
     "energy lost in a cycle over 2 pi times the largest that the storage modulus stores, by the bond law"},
    {"cycle_loss_formula", number, "1", "tan delta = K''/K' of the branches and the dashpot"},
    {"metal", text, "", "name of the metal in data/materials"},
    {"first_frequency", number, "Hz", "first bending frequency of the clamped elastic chain"},
    {"thermoelastic_peak", number, "Hz", "frequency of the peak of thermoelastic damping"},
    {"branch_count", integer, "1", "Maxwell branches in bending"},
    {"settle_time", number, "s",
     "when the root mean square speed was above a twentieth of its largest for the last time"},
};

}  // namespace fiberchain::dem::columns
