#pragma once

#include <stdexcept>

#include "dem/files/file_error.hpp"

// What can go wrong with files of results. Every message is one line, names the thing at fault and what is
// allowed.
namespace fiberchain::dem {

/// The user asked for something impossible: an option out of range, a file that cannot be read.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A result could not be written: unwritable directory, full disk.
using OutputError = WriteError;

/// A table breaks the rules of the column dictionary: a mistake in the program, not of the user.
struct TableError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace fiberchain::dem
