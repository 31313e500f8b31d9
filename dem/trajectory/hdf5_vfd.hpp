#pragma once

#include <hdf5.h>

#include "dem/files/journaled_file.hpp"

namespace fiberchain::dem {

/// Lets HDF5 work on an JournaledFile. HDF5 by itself changes its metadata in place as it goes, so that a
/// kill or a full disk in between leaves a file nobody can open; here it never meets the disk. No locks are
/// taken: neither does a reader stop a run, nor a killed run a reader.
/// @param access file access property list, to be used with H5Fcreate or H5Fopen while `file` lives
/// @returns whether HDF5 took it
bool use_journaled_file(hid_t access, JournaledFile& file);

}  // namespace fiberchain::dem
