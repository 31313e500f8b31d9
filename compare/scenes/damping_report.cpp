#include "compare/scenes/damping_report.hpp"

#include <fmt/format.h>

#include "dem/bond/branches.hpp"

namespace fiberchain::compare {
namespace {

template <int Dim>
std::size_t numbers_of(const dem::MaxwellBranches& all, bool keeps_strain) {
  const int stretch = static_cast<int>(all.stretch.size()), shear = static_cast<int>(all.shear.size()),
            twist = static_cast<int>(all.twist.size()), bend = static_cast<int>(all.bend.size());
  return keeps_strain ? dem::branch_memory<true, Dim>(stretch, shear, twist, bend)
                      : dem::branch_memory<false, Dim>(stretch, shear, twist, bend);
}

std::string line_of(const dem::Fiber& fiber, const dem::DampingSummary& damping, dem::BondForm form,
                    dem::Dimension dimension) {
  std::string ripple, peak;
  if (damping.ripple > 0)
    ripple = fmt::format("loss factor within ±{:.2g} % over its band, ", 100 * damping.ripple);
  if (damping.peak) peak = fmt::format("thermoelastic peak at {:.4g} Hz, ", *damping.peak);
  return fmt::format(
      "material damping by Maxwell branches ({}): {}{}E relaxed {:.5g} Pa, {:.4g} of E at {:.3g} Hz; {:.0f} "
      "bytes a bond",
      branches_in_words(fiber), ripple, peak, fiber.material.youngs_modulus, damping.relaxed_part,
      damping.modulus_frequency, branch_bytes(fiber, form, dimension));
}

}  // namespace

double branch_bytes(const dem::Fiber& fiber, dem::BondForm form, dem::Dimension dimension) {
  const bool keeps_strain = form == dem::BondForm::total;
  return sizeof(double) * static_cast<double>(dimension == dem::Dimension::planar
                                                  ? numbers_of<2>(fiber.branches, keeps_strain)
                                                  : numbers_of<3>(fiber.branches, keeps_strain));
}

std::string branches_in_words(const dem::Fiber& fiber) {
  const dem::MaxwellBranches& all = fiber.branches;
  return fmt::format("stretch {}, shear {}, twist {}, bend {}", all.stretch.size(), all.shear.size(),
                     all.twist.size(), all.bend.size());
}

dem::NamedRow damping_cells(const dem::Fiber& fiber, const dem::DampingSummary& damping, dem::BondForm form,
                            dem::Dimension dimension) {
  if (fiber.branches.empty()) return {};
  return {{"branches", branches_in_words(fiber)},
          {"loss_ripple", damping.ripple},
          {"relaxed_modulus", fiber.material.youngs_modulus},
          {"branch_memory", branch_bytes(fiber, form, dimension)}};
}

std::vector<std::string> damping_lines(const dem::Scene& scene) {
  std::vector<std::string> lines;
  const auto add = [&](const dem::Fiber& fiber, const dem::DampingSummary& damping, dem::BondForm form,
                       dem::Dimension dimension) {
    if (!fiber.branches.empty()) lines.push_back(line_of(fiber, damping, form, dimension));
  };
  if (const auto* release = std::get_if<dem::ReleaseScene>(&scene))
    add(release->fiber, release->damping, release->motion.form, release->dimension);
  if (const auto* packing = std::get_if<dem::PackingScene>(&scene)) {
    for (const dem::PackingFiberKind& kind : packing->kinds)
      add(kind.fiber, kind.damping, packing->form, dem::Dimension::spatial);
  }
  return lines;
}

}  // namespace fiberchain::compare
