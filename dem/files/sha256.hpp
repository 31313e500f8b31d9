#pragma once

#include <string>
#include <string_view>

namespace fiberchain::dem {

/// SHA-256 of the bytes, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace fiberchain::dem
