#pragma once

// The L frame, numbered from either end and loaded along two paths.
namespace fiberchain::compare {

/// Distance of the loaded end over L between the chain and the one numbered from its other end, both bonds.
double l_frame_numbering_difference();

/// The same between loads that grow together and a lateral force before the others.
double l_frame_path_difference();

}  // namespace fiberchain::compare
