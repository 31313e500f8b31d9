#pragma once

#include <sundials/sundials_nvector.h>

namespace fiberchain::dem {

/// Gives a serial vector, and all that are cloned from it, loops compiled here in place of those of SUNDIALS,
/// which Debian builds without optimization: half the time of a run is theirs otherwise.
void use_own_operations(N_Vector vector);

}  // namespace fiberchain::dem
