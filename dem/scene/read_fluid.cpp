#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

struct NamedFlow {
  const char* name;
  Gradient (*gradient)(double rate);
};
constexpr NamedFlow kFlows[] = {{"shear", &simple_shear},
                                {"planar_extension", &planar_extension},
                                {"uniaxial_extension", &uniaxial_extension},
                                {"rotation", &solid_rotation}};

void read_named(const StrictMapping& fluid, FlowScene& scene) {
  std::vector<std::string> words;
  for (const NamedFlow& flow : kFlows) words.emplace_back(flow.name);
  const std::size_t which = fluid.choice("flow", words);
  const double rate = fluid.quantity("rate", "1/s", kFinite);
  if (rate == 0) fluid.fail("rate", "must not be zero: there would be nothing to follow");
  scene.fluid.flow.gradient = kFlows[which].gradient(rate);
  scene.rate = std::abs(rate);
  scene.shear = which == 0;
}

void read_gradient(const StrictMapping& fluid, FlowScene& scene) {
  if (fluid.has("rate")) fluid.fail("rate", "is of use only with flow; a gradient has its own");
  const auto rows = fluid.matrix("gradient");
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      scene.fluid.flow.gradient[i][j] = rows[i][j];
      sum += rows[i][j] * rows[i][j];
    }
  }
  scene.rate = std::sqrt(sum);
  if (!std::isnormal(scene.rate))
    fluid.fail("gradient", "must not be zero, nor too large or small for a computer");
}

void read_course(const StrictMapping& fluid, FlowScene& scene) {
  const StrictMapping course = fluid.section("course", {"start_up", "oscillation", "phase"});
  const Gradient& gradient = scene.fluid.flow.gradient;
  if (course.one_of({"start_up", "oscillation"}) == "start_up") {
    if (course.has("phase")) course.fail("phase", "is of use only with oscillation");
    scene.fluid.flow = start_up(gradient, course.quantity("start_up", "s", kPositive));
  } else {
    const double phase = course.has("phase") ? course.quantity("phase", "rad", kFinite) : 0.0;
    scene.fluid.flow = oscillation(gradient, course.quantity("oscillation", "s", kPositive), phase);
  }
  scene.shear = false;
}

Hydrodynamics read_hydrodynamics(const StrictMapping& fluid) {
  constexpr Hydrodynamics all[] = {Hydrodynamics::free_draining, Hydrodynamics::interactions,
                                   Hydrodynamics::stresslets};
  std::vector<std::string> words;
  for (const Hydrodynamics one : all) words.emplace_back(name(one));
  return all[fluid.choice("hydrodynamics", words)];
}

}  // namespace

void read_fluid(const StrictMapping& top, FlowScene& scene) {
  const StrictMapping fluid = top.section(
      "fluid", {"viscosity", "flow", "rate", "gradient", "course", "hydrodynamics", "compressible"});
  scene.fluid.viscosity = fluid.quantity("viscosity", "Pa s", kPositive);
  const bool named = fluid.one_of({"flow", "gradient"}) == "flow";
  named ? read_named(fluid, scene) : read_gradient(fluid, scene);
  if (fluid.has("course")) read_course(fluid, scene);
  if (fluid.has("hydrodynamics")) scene.fluid.hydrodynamics = read_hydrodynamics(fluid);
  if (fluid.has("compressible"))
    scene.fluid.compressible = fluid.choice("compressible", {"false", "true"}) == 1;
  try {
    scene.dimension == Dimension::planar ? check<2>(scene.fluid) : check<3>(scene.fluid);
  } catch (const InvalidInput& error) {
    fluid.fail("", error.what());
  }
}

}  // namespace fiberchain::dem
