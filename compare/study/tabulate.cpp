#include "compare/study/tabulate.hpp"

#include <cmath>

namespace fiberchain::compare {

dem::Cell known(double value) { return std::isfinite(value) ? dem::Cell(value) : dem::Cell(dem::Missing{}); }

}  // namespace fiberchain::compare
