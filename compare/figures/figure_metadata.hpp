#pragma once

#include <string>

#include "dem/record/provenance.hpp"

namespace fiberchain::compare {

/// The SVG with <metadata> of "key: value" lines as the first child of its root.
/// @throws FigureError if it is no SVG
std::string with_svg_metadata(std::string svg, const dem::Provenance& provenance);

/// The PNG with a tEXt chunk "fiberchain:KEY" per entry after its header; what is not ASCII becomes '?'.
/// @throws FigureError if it is no PNG
std::string with_png_metadata(std::string png, const dem::Provenance& provenance);

/// The PDF with an entry "fiberchain:KEY" each in its information dictionary, by an incremental update at its
/// end; what is not ASCII becomes '?'.
/// @throws FigureError if it is no PDF with a trailer, as cairo writes up to version 1.16
std::string with_pdf_metadata(std::string pdf, const dem::Provenance& provenance);

}  // namespace fiberchain::compare
