#pragma once

#include <hdf5.h>

#include <cstdint>

#include "dem/trajectory/frame.hpp"

// Contacts of frames in a trajectory, as many as there are: rows of all frames one behind the other.
//
//   /connectivity/contacts/count             in time: rows of each frame; -1 where they were not written
//   /connectivity/contacts/pair              row: sphere, and sphere or number of the wall (from 1)
//   /connectivity/contacts/kind              row: 0 of two fibers, 1 of a fiber and a wall, 2 of one fiber
//   /connectivity/contacts/{point,normal,force}   row: [m], from the first body to the second, on the first
//   [N]
namespace fiberchain::dem::h5md {

inline constexpr const char* kContacts = "connectivity/contacts";
inline constexpr const char* kContactCount = "connectivity/contacts/count";

bool has_contacts(hid_t file);
/// An empty one, for a file of so many frames without any.
void make_contacts(hid_t file, hsize_t frames);
/// Those of frame `n`, the last, behind all others; whether they are known or not.
void append_contacts(hid_t file, hsize_t n, const TrajectoryFrame& frame);
/// Leaves those of the first frames.
void keep_contacts(hid_t file, hsize_t frames);
/// Where they are known.
void read_contacts(hid_t file, hsize_t n, TrajectoryFrame& frame);

}  // namespace fiberchain::dem::h5md
