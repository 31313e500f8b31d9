#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr NamedFlow kShear{"shear", &simple_shear};
constexpr NamedFlow kFlows[] = {kShear,
                                {"planar_extension", &planar_extension},
                                {"uniaxial_extension", &uniaxial_extension},
                                {"rotation", &solid_rotation}};

KeyTable<CourseKeys> course_keys() {
  KeyTable<CourseKeys> table;
  table.quantity("start_up", "s", &CourseKeys::start_up, kPositive, "time T of a start-up 1 - exp(-t / T)");
  table.quantity("oscillation", "s", &CourseKeys::oscillation, kPositive,
                 "period T of cos(2π t / T + phase)");
  table.quantity("phase", "rad", &CourseKeys::phase, kFinite, "phase at the start")
      .only_with("oscillation", [](const CourseKeys& keys) { return keys.oscillation.has_value(); });
  table.one_of({"start_up", "oscillation"});
  return table;
}

Gradient matrix_of(const std::array<std::array<double, 3>, 3>& rows) {
  Gradient gradient{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) gradient[i][j] = rows[i][j];
  }
  return gradient;
}

/// Size of all entries together: the Frobenius norm.
double size_of(const Gradient& gradient) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum += gradient[i][j] * gradient[i][j];
  }
  return std::sqrt(sum);
}

void set_flow(const StrictMapping& mapping, const FluidKeys& keys, FluidInFlow& in) {
  if (keys.flow) {
    if (keys.rate == 0) mapping.fail("rate", "must not be zero: there would be nothing to follow");
    in.fluid.flow.gradient = keys.flow->gradient(keys.rate);
    in.rate = std::abs(keys.rate);
    in.shear = *keys.flow == kShear;
  } else if (keys.gradient) {
    in.fluid.flow.gradient = matrix_of(*keys.gradient);
    in.rate = size_of(in.fluid.flow.gradient);
    if (!std::isnormal(in.rate)) {
      mapping.fail("gradient", "must not be zero, nor too large or small for a computer");
    }
  }
}

void set_course(const CourseKeys& course, FluidInFlow& in) {
  const Gradient gradient = in.fluid.flow.gradient;
  in.fluid.flow = course.start_up ? start_up(gradient, *course.start_up)
                                  : oscillation(gradient, course.oscillation.value(), course.phase);
  in.shear = false;
}

}  // namespace

KeyTable<FluidKeys> fluid_keys(std::initializer_list<Hydrodynamics> hydrodynamics, bool may_rest) {
  KeyTable<FluidKeys> table;
  Words<NamedFlow> flows;
  for (const NamedFlow& flow : kFlows) flows.emplace_back(flow.name, flow);
  const auto flows_at_all = [](const FluidKeys& keys) { return keys.flows(); };
  table.quantity("viscosity", "Pa s", &FluidKeys::viscosity, kPositive, "viscosity µ").required();
  table.choice("flow", &FluidKeys::flow, flows,
               "undisturbed flow at rate g: u = (g y, 0, 0), g (x, -y, 0), g (x, -y/2, -z/2), g (-y, x, 0)");
  table.matrix("gradient", "1/s", &FluidKeys::gradient, "velocity gradient A[i][j] = ∂u_i/∂x_j of u = A x");
  table.one_of({"flow", "gradient"}, may_rest ? "the fluid is at rest" : "");
  table.quantity("rate", "1/s", &FluidKeys::rate, kFinite, "rate g of the flow, not 0")
      .required()
      .only_with("flow (a gradient has its own)",
                 [](const FluidKeys& keys) { return keys.flow.has_value(); });
  const auto store_course = [](const StrictMapping&, const CourseKeys& course, FluidKeys& keys) {
    keys.course = course;
  };
  table.mapping("course", course_keys(), store_course, "course of the flow in time")
      .otherwise("steady")
      .only_with("flow or gradient", flows_at_all);
  table.choice("hydrodynamics", &FluidKeys::hydrodynamics, words_of(hydrodynamics),
               "what spheres do to each other through the fluid");
  table.flag("compressible", &FluidKeys::compressible, "allow a gradient with a trace")
      .only_with("flow or gradient", flows_at_all);
  return table;
}

FluidInFlow fluid_of(const StrictMapping& mapping, const FluidKeys& keys, Dimension dimension) {
  FluidInFlow in{.fluid = {.viscosity = keys.viscosity,
                           .flow = {},
                           .hydrodynamics = keys.hydrodynamics,
                           .compressible = keys.compressible}};
  set_flow(mapping, keys, in);
  if (keys.course) set_course(*keys.course, in);
  try {
    dimension == Dimension::planar ? check<2>(in.fluid) : check<3>(in.fluid);
  } catch (const InvalidInput& error) {
    mapping.fail("", error.what());
  }
  return in;
}

}  // namespace fiberchain::dem
