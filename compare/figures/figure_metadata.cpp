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

std::string in_ascii(std::string value) {
  std::ranges::replace_if(
      value, [](unsigned char c) { return c >= 0x80; }, '?');
  return value;
}

/// PNG chunk: length, type, data, CRC of type and data (PNG specification, 5.3).
std::string text_chunk(const std::string& keyword, const std::string& value) {
  const std::string body = "tEXt" + keyword + '\0' + in_ascii(value);
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  return big_endian(static_cast<std::uint32_t>(body.size() - 4)) + body + big_endian(crc.checksum());
}

/// A string of a PDF (PDF reference, 3.2.3).
std::string pdf_string(const std::string& value) {
  std::string text = "(";
  for (const char c : in_ascii(value)) {
    if (c == '(' || c == ')' || c == '\\') text += '\\';
    text += c == '\n' ? ' ' : c;
  }
  return text + ")";
}

/// What stands behind a key of a PDF's trailer, up to the next key or its end.
std::string trailer_value(const std::string& trailer, std::string_view key) {
  const auto at = trailer.find(key);
  if (at == std::string::npos)
    throw FigureError("the PDF that gnuplot wrote has no trailer that is known here");
  const auto begin = at + key.size(), end = trailer.find_first_of("/>", begin);
  return trailer.substr(begin, end - begin);
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

std::string with_pdf_metadata(std::string pdf, const dem::Provenance& provenance) {
  const auto trailer_at = pdf.rfind("trailer"), start_at = pdf.rfind("startxref");
  if (!pdf.starts_with("%PDF-") || trailer_at == std::string::npos || start_at == std::string::npos ||
      start_at < trailer_at) {
    throw FigureError("gnuplot wrote no PDF with a trailer");
  }
  const std::string trailer = pdf.substr(trailer_at, start_at - trailer_at);
  const int number = std::stoi(trailer_value(trailer, "/Size"));
  const auto before = std::stoul(pdf.substr(start_at + std::string_view("startxref").size()));
  const std::size_t object_at = pdf.size();
  pdf += fmt::format("{} 0 obj\n<< /Producer (gnuplot, cairo)\n", number);
  for (const auto& [key, value] : dem::entries(provenance))
    pdf += fmt::format("   /fiberchain:{} {}\n", key, pdf_string(value));
  pdf += ">>\nendobj\n";
  const std::size_t table_at = pdf.size();
  pdf += fmt::format("xref\n{} 1\n{:010} 00000 n \n", number, object_at);
  pdf += fmt::format("trailer\n<< /Size {} /Root{} /Info {} 0 R /Prev {} >>\nstartxref\n{}\n%%EOF\n",
                     number + 1, trailer_value(trailer, "/Root"), number, before, table_at);
  return pdf;
}

}  // namespace fiberchain::compare
