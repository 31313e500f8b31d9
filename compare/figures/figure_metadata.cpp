#include "compare/figures/figure_metadata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <string_view>

#include "compare/study/errors.hpp"
#include "dem/files/xml.hpp"

namespace fiberchain::compare {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes(4, '\0');
  boost::endian::store_big_u32(reinterpret_cast<unsigned char*>(bytes.data()), value);
  return bytes;
}

/// PNG chunk: length, type, data, CRC of type and data (PNG specification, 5.3).
std::string text_chunk(const std::string& keyword, std::string value) {
  std::ranges::replace_if(
      value, [](unsigned char c) { return c >= 0x80; }, '?');
  const std::string body = "tEXt" + keyword + '\0' + value;
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  return big_endian(static_cast<std::uint32_t>(body.size() - 4)) + body + big_endian(crc.checksum());
}

}  // namespace

std::string with_svg_metadata(std::string svg, const dem::Provenance& provenance) {
  const auto root = svg.find("<svg");
  const auto end = root == std::string::npos ? root : svg.find('>', root);
  if (end == std::string::npos || svg.find("</svg>") == std::string::npos) {
    throw FigureError("gnuplot wrote no whole SVG");
  }
  std::string metadata = "\n<metadata>\n";
  for (const auto& [key, value] : dem::entries(provenance))
    metadata += fmt::format("{}: {}\n", key, dem::xml_escaped(value));
  svg.insert(end + 1, metadata + "</metadata>");
  return svg.insert(root + std::string_view("<svg").size(),
                    " xml:space=\"preserve\"");  // spaces at changes of font
}

std::string with_png_metadata(std::string png, const dem::Provenance& provenance) {
  using namespace std::string_view_literals;
  constexpr std::size_t kHeaderEnd = 8 + 25;  // signature and IHDR chunk
  const bool whole = png.starts_with("\x89PNG\r\n\x1a\n"sv) && png.find("IEND") != std::string::npos;
  if (!whole || png.size() < kHeaderEnd) throw FigureError("gnuplot wrote no whole PNG");
  std::string chunks;
  for (const auto& [key, value] : dem::entries(provenance)) chunks += text_chunk("fiberchain:" + key, value);
  return png.insert(kHeaderEnd, chunks);
}

}  // namespace fiberchain::compare
