#pragma once

#include "dem/record/columns.hpp"

// Validation, published claims, the dictionary itself.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column validation[] = {
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

    // Claims, data/published/*.csv.
    {"quantity", text, "", "the quantity published"},
    {"value", number, "", "its value, in the unit of the row"},
    {"tolerance_scale", text, "",
     "unit of the tolerance: unit (of the row), value (of the reference) or spread (of the runs)"},
    {"rule", text, "", "must hold, disputed, or either, which is disputed where it does not hold"},
    {"dispute", text, "", "reason given where a claim of rule either does not hold"},
    {"unit", text, "", "unit of the row"},
    {"source", text, "", "where it is published"},
    {"page_or_figure", text, "", "page, figure, table or equation in the source"},
    {"statement", text, "", "the source's words, or what the number stands for"},

    // The dictionary as a table.
    {"column", text, "", "name of a column"},
    {"kind", text, "", "type of the column's cells: number, integer or text"},
    {"meaning", text, "", "meaning of the column"},
};

}  // namespace fiberchain::dem::columns
