#pragma once

#include <string>
#include <vector>

#include "compare/report/sources.hpp"

/// Which figures a report shows, under which heading.
namespace fiberchain::compare {

/// A figure as it stands in the page.
struct ReportFigure {
  std::string caption;
  std::string data_uri;  ///< the file, whole
  Origin origin;
};

/// Figures on one thing.
struct ReportSection {
  std::string id;  ///< anchor in the page
  std::string heading;
  std::string text;
  std::vector<ReportFigure> figures;
  std::vector<std::string> missing = {};  ///< captions of figures that no source has
};

/// A figure of the paper, from 3: the first two are drawings of the model.
struct PaperFigure {
  int number;
  std::string heading;
  std::vector<ReportFigure> figures;
  std::vector<std::string> missing = {};
};

/// Content as a data: URI: of SVG if it begins as XML, else of PNG.
std::string data_uri(const std::string& content);

/// Figures 3 to 12 of the paper as they are made here.
/// @throws InputError where a file cannot be read
std::vector<PaperFigure> paper_figures(const Sources& sources);

/// Budgets of error, stability, cost, and what the paper does not have.
/// @throws InputError likewise
std::vector<ReportSection> report_sections(const Sources& sources);

}  // namespace fiberchain::compare
