#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dem/record/output.hpp"
#include "dem/record/provenance.hpp"

/// Figures of series over one pair of axes, drawn by gnuplot. Texts are UTF-8 in gnuplot's enhanced
/// notation: {/:Italic P} italic, L^2 superscript, r_f subscript.
namespace fiberchain::compare {

struct Axis {
  std::string label;
  bool logarithmic = false;
  std::optional<std::pair<double, double>> range = std::nullopt;  ///< from the data unless given
};

enum class Mark {
  line,
  points,
  line_and_points,
  band  ///< what lies between y_low and y, tinted
};
enum class Dash { solid, dashed, dotted };

/// A curve. Points whose x or y is not finite are left out and interrupt the line.
struct Series {
  std::string label;  ///< in the legend; "" leaves it out
  std::vector<double> x;
  std::vector<double> y;
  Mark mark = Mark::line_and_points;
  Dash dash = Dash::solid;
  std::optional<int> color = std::nullopt;  ///< place in the palette; the series' own place unless given
  std::vector<double> y_low = {};           ///< of a band: its lower edge

  void add(double at_x, double at_y) { x.push_back(at_x), y.push_back(at_y); }
};

/// A note at a place in the coordinates of the data.
struct Annotation {
  std::string text;
  double x;
  double y;
};

/// A value over a grid of two quantities, a colored cell with its number for each.
struct HeatMap {
  std::vector<double> x;                        ///< columns, in the order drawn; written below them
  std::vector<double> y;                        ///< rows, from the bottom
  std::vector<std::vector<double>> value = {};  ///< value[row][column], above 0; a NaN leaves its cell empty
  std::string label = {};                       ///< of the color scale, which is logarithmic
  double framed_below = 0;                      ///< cells below this have a frame
};

struct Figure {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  std::vector<Annotation> annotations = {};
  std::string legend_title = {};
  bool ordered = false;     ///< the series are steps of one quantity: colors run from dark to light
  bool equal_axes = false;  ///< one unit is as long on y as on x
  std::optional<HeatMap> map = std::nullopt;  ///< drawn instead of the series
};

/// The figure's series with this one's label; this one, added, if there is none.
Series& series_like(Figure& figure, const Series& series);

enum class FigureFormat { svg, png, pdf };

constexpr std::string_view name(FigureFormat format) {
  constexpr std::string_view names[] = {"svg", "png", "pdf"};
  return names[static_cast<int>(format)];
}

/// How figures are written.
struct FigureStyle {
  std::vector<FigureFormat> formats = {FigureFormat::svg, FigureFormat::png};
  bool title = true;  ///< above the axes: papers have captions
};

/// The figure as SVG with its provenance as <metadata>.
/// @throws FigureError if gnuplot is missing or refuses, if x and y differ in length or a heat map is no grid
std::string to_svg(const Figure& figure, const dem::Provenance& provenance);

/// The figure as PNG, 1280 x 800, with its provenance as tEXt chunks.
/// @throws FigureError as above
std::string to_png(const Figure& figure, const dem::Provenance& provenance);

/// The figure as PDF, 8 x 5 inches, with its provenance as entries of its information dictionary.
/// @throws FigureError as above
std::string to_pdf(const Figure& figure, const dem::Provenance& provenance);

/// NAME.svg, NAME.png, NAME.pdf: those that are asked for.
std::vector<dem::OutputFile> figure_files(const std::string& name, const Figure& figure,
                                          const dem::Provenance& provenance, const FigureStyle& style = {});

}  // namespace fiberchain::compare
