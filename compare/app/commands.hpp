#pragma once

#include "compare/app/context.hpp"
#include "compare/app/options.hpp"

/// The commands of the program, one source file each. Each returns the exit status; errors are thrown.
namespace fiberchain::app {

/// `fiberchain columns`: the dictionary of the columns.
int run_columns(const ColumnsOptions& options, Context& context);

/// `fiberchain run SCENE`: one scene.
int run_scene(const RunOptions& options, Context& context);

/// `fiberchain tables static`: departure of the chain from the Elastica, its causes, Figs 3 and 4.
int run_tables_static(const TablesStaticOptions& options, Context& context);

/// `fiberchain tables damping`: damping of the fiber by that of the bonds, Figs 6 to 9.
int run_tables_damping(const TablesDampingOptions& options, Context& context);

/// `fiberchain validate`: the validation matrix.
int run_validate(const ValidateOptions& options, Context& context);

}  // namespace fiberchain::app
