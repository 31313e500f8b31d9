#pragma once

#include "dem/record/columns.hpp"

// Validation, published claims, the dictionary itself.
namespace fiberchain::dem::columns {

using enum CellKind;

inline constexpr Column validation[] = {
    // Parts of a study.
    {"case", integer, "1",
     "number of the row's case in the whole, from 1, in tables of a part (--shard) of a study"},

    // Validation matrix.
    {"id", text, "", "identifier of the claim or published value, unique"},
    {"feature", text, "", "what is tested"},
    {"reference_kind", text, "", "exact, published, independent method or regression"},
    {"expected", number, "",
     "value expected here, in the unit of the row; where it is from: basis or source"},
    {"measured", number, "", "value found here, in the unit of the row"},
    {"difference", number, "", "measured - expected"},
    {"tolerance", number, "", "largest |difference| at which the row is as expected"},
    {"as_expected", text, "", "yes or no (the matrix fails); - for runs of which nothing is expected"},
    {"verdict", text, "",
     "holds, holds only if (the row's condition) or disputed: whether measured is within the claim; a row "
     "without a claim holds or fails by its tolerance"},
    {"otherwise", number, "", "value found here where the condition does not hold"},
    {"evidence", text, "", "how the row was measured, and what else was"},

    // Claims, data/published/*.csv.
    {"quantity", text, "", "what is measured"},
    {"value", number, "", "its expected value, in the unit of the row; nan: a reference computed with it"},
    {"tolerance_scale", text, "",
     "unit of the tolerance: unit (of the row), value (of the reference) or spread (of the runs)"},
    {"basis", text, "",
     "where the expected value is from: theory, another route, or our own runs; - the source"},
    {"claim", text, "",
     "values for which the published statement is true: LOW..HIGH, < X, <= X, > X, >= X, not LOW..HIGH; - "
     "the "
     "expected value itself"},
    {"reading", text, "", "how the statement's words became the claim, with every choice that is ours"},
    {"condition", text, "", "under which the value is measured and which the source does not name; - none"},
    {"otherwise_expected", number, "", "value expected here where the condition does not hold"},
    {"otherwise_tolerance", number, "", "its largest departure at which the row is as expected"},
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
