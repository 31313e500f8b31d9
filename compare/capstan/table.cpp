#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "compare/capstan/capstan.hpp"
#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

dem::NamedRow capstan_row(const CapstanPoint& p) {
  const CapstanCase& c = p.asked;
  return {{"drum_surface", std::string(name(c.surface))},
          {"drum_friction", c.friction},
          {"turning", c.turning / std::numbers::pi},
          {"drum_radius", c.drum},
          {"drum_bending", c.bending},
          {"spacing", c.spacing},
          {"tension_ratio", dem::known(p.ratio)},
          {"tension_ratio_euler", dem::known(p.euler)},
          {"tension_ratio_rod", dem::known(p.expected)},
          {"tension_error_euler", dem::known(p.ratio / p.euler - 1)},
          {"tension_error_rod", dem::known(p.ratio / p.expected - 1)},
          {"tension_ripple", dem::known(p.spread)},
          {"contacts", std::int64_t{p.contacts}},
          {"run_time", p.run_time},
          {"status", p.status}};
}

}  // namespace

dem::Table capstan_table(const std::vector<CapstanPoint>& points) { return tabulate(points, capstan_row); }

Figure capstan_figure(const std::vector<CapstanPoint>& points) {
  Figure figure{"Tensions of a fiber that slides about a drum, over e^{μφ}",
                {"turning φ/π"},
                {"F/F_0 over e^{μφ}"},
                {}};
  const auto series_of = [&](const std::string& label, Mark mark) -> Series& {
    return series_like(figure, {label, {}, {}, mark, Dash::dashed});
  };
  for (const CapstanPoint& p : points) {
    const CapstanCase& c = p.asked;
    series_of(fmt::format("{}, μ = {:g}", name(c.surface), c.friction), Mark::points)
        .add(c.turning / std::numbers::pi, p.ratio / p.euler);
    const std::string size = fmt::format("rod of 1/{:g}, μ = {:g}", c.drum, c.friction);
    Series& rod = series_of(size, Mark::line);
    if (rod.x.empty() || rod.x.back() < c.turning / std::numbers::pi)
      rod.add(c.turning / std::numbers::pi, p.expected / p.euler);
  }
  return figure;
}

}  // namespace fiberchain::compare
