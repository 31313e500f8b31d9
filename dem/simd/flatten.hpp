#pragma once

// Flattened: a call inside the loop would pass its vectors through memory. Not under the sanitizers, whose
// checks in every copy would take the compiler minutes a file.
#ifdef FIBERCHAIN_SANITIZED
#define FIBERCHAIN_FLATTEN
#else
#define FIBERCHAIN_FLATTEN __attribute__((flatten))
#endif
