#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/report/figure_list.hpp"
#include "compare/report/matrix.hpp"
#include "compare/report/packing_view.hpp"
#include "compare/report/sources.hpp"
#include "dem/record/provenance.hpp"

/// One page of HTML that shows what holds, with everything in it: it loads nothing.
namespace fiberchain::compare {

struct ReportPacking {
  PackingView view;
  std::string name;  ///< what is seen
  Origin origin;
};

struct Report {
  dem::Provenance provenance;  ///< of the run that wrote the page
  std::vector<MatrixEntry> matrix;
  std::vector<PaperFigure> paper;
  std::vector<ReportSection> sections;
  std::optional<ReportPacking> packing;
  std::vector<Origin> tables;      ///< of the matrix
  std::vector<std::string> notes;  ///< what a reader must know before all else: "nothing was measured"
};

/// The page from page.mustache, page.css and page.js of that directory.
/// @throws InputError where one cannot be read or the template is none
std::string to_html(const Report& report, const std::filesystem::path& templates);

}  // namespace fiberchain::compare
