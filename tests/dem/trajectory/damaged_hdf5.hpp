#pragma once

// For one source of a program that reads damaged trajectories.

/// HDF5 1.10 loses the header of a dataset whose checksum is wrong (400 bytes): its leak, not ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
