#pragma once

#include <string>

namespace fiberchain::reference {

/// Turns off GSL's default error handler, which aborts the process; GSL then only returns status codes,
/// and this library turns those into NoConvergence. It changes one setting of the whole process and is not
/// thread safe, so no function here calls it: the program's main calls it once, before any thread starts.
/// Without it valid arguments give the same results; it matters for failures inside GSL, such as memory
/// running out.
void report_gsl_errors_by_status();

/// Throws NoConvergence naming `what` and GSL's own text unless status is GSL_SUCCESS.
void check_gsl(int status, const std::string& what);

}  // namespace fiberchain::reference
