#pragma once

#include <cstddef>
#include <string>

namespace fiberchain::dem {

/// The bytes in base64 with padding (RFC 4648, 4).
std::string base64(const void* bytes, std::size_t count);

}  // namespace fiberchain::dem
