#pragma once

#include "dem/record/columns.hpp"

// Materials, the damping that they have, and what to type into other codes.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column material[] = {
    {"material", text, "", "name of the material in data/materials, or its file"},
    {"material_loss_factor", number, "1", "tan delta of the material's Young's modulus"},
    {"relaxation_strength", number, "1", "Zener's relaxation strength Delta = E alpha^2 T/(rho c)"},
    {"peak_diameter_squared", number, "Hz m^2",
     "frequency of the thermoelastic peak of a round wire times the square of its diameter"},
    {"sources", text, "", "keys of data/materials/sources.yaml"},
    {"branches", text, "", "Maxwell branches beside each spring of a bond"},
    {"loss_ripple", number, "1", "largest relative error of a flat loss factor in its band"},
    {"relaxed_modulus", number, "Pa", "relaxed Young's modulus, that of slow loads"},
    {"relaxed_shear_modulus", number, "Pa", "relaxed shear modulus"},
    {"branch_memory", number, "B", "memory that the branches of one bond take in a march"},
    {"thermal_peak", number, "Hz", "frequency f_0 of the thermoelastic peak of this fiber"},
    {"band_low", number, "Hz", "lower end of the band in which the loss factor is flat"},
    {"band_high", number, "Hz", "its upper end"},
    {"peak_ratio", number, "1", "frequency of the mode over that of the thermoelastic peak"},
    {"mode_frequency", number, "Hz", "frequency |s|/(2 pi) of the chain's mode"},
    {"mode_damping_beam", number, "1",
     "zeta of the fiber as a uniform beam of its own mass, with the exact thermoelastic modulus"},
    {"mode_error", number, "1", "mode_damping over mode_damping_beam - 1"},
    {"mode_ripple", number, "1",
     "how far the flat loss factor's ripple may take mode_damping off; missing outside of the band"},
    {"mode_damping_dashpots", number, "1", "zeta of the mode with dashpots alone that meet that of mode 1"},
    {"flat_part", number, "1", "half of tan delta that the loss factor and branches as given have there"},
    {"thermoelastic_part", number, "1", "half of tan delta that thermoelasticity has there"},
    {"mechanism", text, "", "which of the two is larger: loss factor or thermoelastic"},
    {"spring", text, "", "stretch, shear, twist or bend"},
    {"branch_strength", number, "1", "stiffness of the branch's spring over the relaxed one beside it"},
    {"branch_time", number, "s", "relaxation time of the branch"},
    {"stiffness_stretch", number, "N/m", "K_n of a bond"},
    {"stiffness_shear", number, "N/m", "K_t of a bond"},
    {"stiffness_twist", number, "N m", "K_twist of a bond"},
    {"stiffness_bend", number, "N m", "K_bend of a bond"},
    {"dashpot_stretch", number, "N s/m", "dashpot beside K_n"},
    {"dashpot_shear", number, "N s/m", "dashpot beside K_t"},
    {"dashpot_twist", number, "N m s", "dashpot beside K_twist"},
    {"dashpot_bend", number, "N m s", "dashpot beside K_bend"},
    {"code", text, "", "program that the line is for"},
    {"line", text, "", "line of its input"},
};

}  // namespace fiberchain::dem::columns
