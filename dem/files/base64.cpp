#include "dem/files/base64.hpp"

#include <string_view>

namespace fiberchain::dem {

std::string base64(const void* bytes, std::size_t count) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* from = static_cast<const unsigned char*>(bytes);
  std::string text;
  text.reserve((count + 2) / 3 * 4);
  for (std::size_t i = 0; i < count; i += 3) {
    const std::size_t rest = count - i;
    const unsigned three = from[i] << 16 | (rest > 1 ? from[i + 1] << 8 : 0) | (rest > 2 ? from[i + 2] : 0);
    text += kDigits[three >> 18];
    text += kDigits[three >> 12 & 63];
    text += rest > 1 ? kDigits[three >> 6 & 63] : '=';
    text += rest > 2 ? kDigits[three & 63] : '=';
  }
  return text;
}

}  // namespace fiberchain::dem
