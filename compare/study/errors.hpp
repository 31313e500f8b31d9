#pragma once

#include <stdexcept>

#include "dem/record/errors.hpp"

/// What can go wrong in compare/. Every message is one line, names the thing at fault and what is allowed.
namespace fiberchain::compare {

using dem::InputError;

/// gnuplot is missing or refused a figure.
struct FigureError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fiberchain::compare
