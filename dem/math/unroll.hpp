#pragma once

/// Before a loop of few, fixed passes: unrolls it whole, so that what it walks through stays in registers.
/// GCC 12 gives up on nested loops of small matrices by itself, and the elimination along a chain takes twice
/// as long.
#define FIBERCHAIN_UNROLL _Pragma("GCC unroll 8")
