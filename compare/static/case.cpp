#include "compare/static/case.hpp"

#include <algorithm>
#include <cmath>

#include "compare/measure/strain.hpp"
#include "compare/static/tip.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "reference/elastica.hpp"
#include "reference/errors.hpp"
#include "reference/reissner.hpp"

namespace fiberchain::compare {
namespace {

using reference::TipState;

TipState over(const TipState& a, const TipState& b) { return {a.y / b.y, a.x / b.x, a.angle / b.angle}; }

StaticPoint compared(const StaticCase& asked, const dem::Fiber& fiber, const ChainTip& chain) {
  const double to_load = std::pow(dem::fiber_length(fiber), 2) / dem::bending_stiffness(fiber);
  const double axial = dem::axial_stiffness(fiber) * to_load, shear = dem::shear_stiffness(fiber) * to_load;
  const TipState elastica = reference::elastica_shooting(asked.load);
  const TipState sheared =
      reference::reissner_tip(asked.load, std::numeric_limits<double>::infinity(), shear);
  const TipState both = reference::reissner_tip(asked.load, axial, shear);
  const double strain = strain_bound(fiber, asked.load);
  const std::string warning = strain_warning(strain);
  const TipState stretch = both - sheared, off = chain.tip - elastica, unstretched = off - stretch;
  return {asked,
          chain.tip,
          elastica,
          both,
          over(off, elastica),
          {over(sheared - elastica, elastica), over(stretch, elastica), over(chain.solved - both, elastica),
           over(chain.history, elastica), over(chain.time_step, elastica), over(chain.leftover, elastica)},
          std::hypot(off.y, off.x),
          std::hypot(unstretched.y, unstretched.x),
          chain.residual,
          chain.stability,
          chain.iterations,
          chain.steps,
          chain.run_time,
          strain,
          warning.empty() ? "converged" : "converged, but " + warning};
}

StaticPoint failed(const StaticCase& asked, const std::string& why) {
  const TipState none{nan, nan, nan};
  return {asked, none,
          none,  none,
          none,  {none, none, none, none, none, none},
          nan,   nan,
          nan,   dem::Stability::undecided,
          0,     0,
          nan,   nan,
          why};
}

void check(const StaticCase& asked) {
  dem::check(nominal_fiber(asked.aspect_ratio, asked.poisson_ratio, asked.bond));
  reference::require_between("load", asked.load, 1e-9, reference::max_reissner_load);
  if (asked.method == StaticMethod::solve && asked.form == dem::BondForm::incremental) {
    throw InputError(
        "--form incremental is not allowed with --method solve: the incremental form has no energy and "
        "depends on the "
        "path; use --method march");
  }
}

/// Cases that march together: the same but for their load.
bool same_block(const StaticCase& a, const StaticCase& b) {
  return a.method == StaticMethod::march && b.method == StaticMethod::march &&
         a.aspect_ratio == b.aspect_ratio && a.poisson_ratio == b.poisson_ratio && a.bond == b.bond &&
         a.form == b.form && a.dimension == b.dimension;
}

struct Block {
  std::size_t first, end;
};

std::vector<Block> blocks_of(const std::vector<StaticCase>& cases, std::size_t width) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool joins = !blocks.empty() && same_block(cases[i], cases[blocks.back().first]) &&
                       i - blocks.back().first < width;
    if (joins) {
      blocks.back().end = i + 1;
    } else {
      blocks.push_back({i, i + 1});
    }
  }
  return blocks;
}

void run_block(const std::vector<StaticCase>& cases, const Block& block, const StaticOptions& options,
               std::vector<StaticPoint>& points) {
  const StaticCase& asked = cases[block.first];
  const dem::Fiber fiber = nominal_fiber(asked.aspect_ratio, asked.poisson_ratio, asked.bond);
  std::vector<double> loads;
  for (std::size_t i = block.first; i < block.end; ++i) loads.push_back(cases[i].load);
  try {
    dem::RelaxOptions march = options.march;
    march.form = asked.form;
    const std::vector<ChainTip> tips = asked.method == StaticMethod::march
                                           ? march_tips(asked.dimension, fiber, loads, march)
                                           : std::vector{solve_tip(asked.dimension, fiber, asked.load)};
    for (std::size_t i = block.first; i < block.end; ++i)
      points[i] = compared(cases[i], fiber, tips[i - block.first]);
  } catch (const dem::NoConvergence& error) {
    for (std::size_t i = block.first; i < block.end; ++i) points[i] = failed(cases[i], error.what());
  } catch (const dem::Diverged& error) {
    for (std::size_t i = block.first; i < block.end; ++i) points[i] = failed(cases[i], error.what());
  } catch (const reference::NoConvergence& error) {
    for (std::size_t i = block.first; i < block.end; ++i) points[i] = failed(cases[i], error.what());
  }
  for (std::size_t i = block.first; i < block.end; ++i) options.advance();
}

}  // namespace

std::string_view name(StaticMethod method) { return method == StaticMethod::solve ? "solve" : "march"; }

dem::Fiber nominal_fiber(int aspect_ratio, double poisson_ratio, dem::BondModel bond) {
  return {dem::isotropic_material(2.6e6, poisson_ratio, 1000), 2e-3, aspect_ratio, bond};
}

bool has_converged(const StaticPoint& point) { return point.status.starts_with("converged"); }

std::vector<StaticPoint> static_points(const std::vector<StaticCase>& cases, const StaticOptions& options) {
  for (const StaticCase& asked : cases) check(asked);
  std::vector<StaticPoint> points;
  for (const StaticCase& asked : cases) points.push_back(failed(asked, std::string(not_begun)));
  const std::size_t width = dem::chain_kernel(dem::built_physics[0], options.march.instruction_set).width;
  const std::vector<Block> blocks = blocks_of(cases, width);
  options.jobs.run(blocks.size(), [&](std::size_t i) {
    if (!options.stopped()) run_block(cases, blocks[i], options, points);
  });
  return points;
}

}  // namespace fiberchain::compare
