#include "reference/gsl_status.hpp"

#include <gsl/gsl_errno.h>

#include "reference/errors.hpp"

namespace fiberchain::reference {

void report_gsl_errors_by_status() { gsl_set_error_handler_off(); }

void check_gsl(int status, const std::string& what) {
  if (status != GSL_SUCCESS) throw NoConvergence(what + " (" + gsl_strerror(status) + ")");
}

}  // namespace fiberchain::reference
