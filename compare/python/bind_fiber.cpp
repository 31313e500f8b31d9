#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "compare/calibration/material.hpp"
#include "compare/calibration/material_table.hpp"
#include "compare/calibration/table.hpp"
#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "compare/python/scene_of.hpp"
#include "dem/motion/time_step.hpp"
#include "dem/scene/read_material.hpp"

// Fibers, materials, calibration.
namespace fiberchain::python {
namespace {

using dem::Fiber;

py::object number_or_none(const std::optional<dem::MaterialValue>& value) {
  if (!value) return py::none();
  py::dict all;
  all["value"] = value->value;
  all["range"] =
      value->range ? py::object(py::make_tuple((*value->range)[0], (*value->range)[1])) : py::none();
  all["source"] = value->source;
  all["note"] = value->note;
  return all;
}

py::dict material(const std::string& name) {
  const dem::MaterialData data = dem::find_material(name);
  py::dict all;
  all["name"] = data.name;
  all["description"] = data.description;
  all["temperature"] = data.temperature;
  all["youngs_modulus"] = number_or_none(data.youngs_modulus);
  all["shear_modulus"] = number_or_none(data.shear_modulus);
  all["transverse_modulus"] = number_or_none(data.transverse_modulus);
  all["poisson_ratio"] = number_or_none(data.poisson_ratio);
  all["density"] = number_or_none(data.density);
  all["loss_factor"] = number_or_none(data.loss_factor);
  all["shear_loss_factor"] = number_or_none(data.shear_loss_factor);
  all["thermal_expansion"] = number_or_none(data.thermal_expansion);
  all["heat_capacity"] = number_or_none(data.heat_capacity);
  all["conductivity"] = number_or_none(data.conductivity);
  return all;
}

double target_of(const std::string& measure, double value) {
  using compare::DampingMeasure;
  for (const auto one : {DampingMeasure::damping_ratio, DampingMeasure::log_decrement,
                         DampingMeasure::quality_factor, DampingMeasure::loss_factor}) {
    if (compare::name(one) == measure) return compare::to_damping_ratio(one, value);
  }
  throw dem::InvalidInput("measure = " + measure + " is not allowed");
}

py::dict answer_of(const compare::CalibrationAnswer& answer) {
  py::dict all;
  all["fiber"] = answer.found.fiber;
  all["table"] = dict_of(compare::calibration_table({answer}));
  return all;
}

py::dict calibrate(const Fiber& fiber, const std::string& measure, double value, double amplitude,
                   std::optional<double> step_ratio, dem::DashpotLaw dashpots) {
  compare::CalibrationCase asked{.fiber = fiber, .amplitude = amplitude, .step_ratio = step_ratio};
  asked.fiber.dashpots = dashpots;
  asked.fiber.bond_damping = asked.fiber.retardation_time = 0;
  const double target = target_of(measure, value);
  return answer_of({asked, target, compare::calibrate(asked, target)});
}

py::dict calibration_of(const Fiber& fiber, double amplitude, std::optional<double> step_ratio) {
  const compare::CalibrationCase asked{.fiber = fiber, .amplitude = amplitude, .step_ratio = step_ratio};
  return answer_of({asked, std::nullopt, compare::calibration_of(asked)});
}

/// A fiber by its material's own damping, or by a flat loss factor in its place.
py::dict damp_by_material(const Fiber& fiber, const std::optional<std::string>& name,
                          std::optional<double> loss_factor, std::optional<std::array<double, 2>> band) {
  dem::MaterialDamping damping;
  if (name) damping = dem::damping_of(dem::find_material(*name));
  if (loss_factor) damping.loss_factor = loss_factor;
  if (band) damping.band = dem::FrequencyBand{(*band)[0], (*band)[1]};
  const compare::MaterialAnswer answer = compare::answer_material({fiber, damping});
  py::dict all;
  all["fiber"] = answer.damped.fiber;
  const std::optional<dem::FrequencyBand>& taken = answer.asked.damping.band;
  all["band"] = taken ? py::object(py::make_tuple(taken->low, taken->high)) : py::none();
  all["dashpots"] = answer.dashpots ? py::cast(answer.dashpots->fiber) : py::none();
  all["table"] = dict_of(compare::material_answer_table(answer, name.value_or("")));
  all["modes"] =
      answer.modes.empty() ? py::object(py::dict()) : dict_of(compare::material_modes_table(answer));
  all["branches"] = dict_of(compare::branches_table(answer.damped.fiber.branches));
  return all;
}

Fiber fiber_of_text(const std::string& text) {
  return scene_of<dem::ReleaseScene>(scene_text(text, "fiber", {})).fiber;
}

template <auto value>
auto of_fiber() {
  return [](const Fiber& fiber) { return value(fiber); };
}

void bind_values(py::class_<Fiber>& fiber) {
  fiber
      .def_property_readonly(
          "youngs_modulus", [](const Fiber& f) { return f.material.youngs_modulus; },
          "E [Pa]; the relaxed one where the material has a memory.")
      .def_property_readonly(
          "shear_modulus", [](const Fiber& f) { return f.material.shear_modulus; }, "G [Pa].")
      .def_property_readonly(
          "density", [](const Fiber& f) { return f.material.density; }, "rho [kg/m^3].")
      .def_property_readonly(
          "poisson_ratio", [](const Fiber& f) { return dem::poisson_ratio(f.material); },
          "E/(2 G) - 1; NaN where the material is not isotropic.")
      .def_readonly("diameter", &Fiber::diameter, "d = 2 R [m].")
      .def_property_readonly(
          "aspect_ratio", [](const Fiber& f) { return std::lround(dem::slenderness(f)); },
          "r_f = L/d, the number of bonds where spacing is 1.")
      .def_readonly("spacing", &Fiber::spacing, "s = l/d, length of a bond over the diameter.")
      .def_readonly("bonds", &Fiber::aspect_ratio, "Number of bonds.")
      .def_readonly("bond_damping", &Fiber::bond_damping, "xi_b of Eqs 7 to 10.")
      .def_readonly("retardation_time", &Fiber::retardation_time,
                    "tau of dashpots c = tau K [s]; 0 of others.")
      .def_readonly("rolling_friction", &Fiber::rolling_friction, "xi_r of Eq 21.")
      .def_property_readonly(
          "bond_model", [](const Fiber& f) { return std::string(dem::name(f.bond_model)); },
          "'paper' or 'corrected'.")
      .def_property_readonly(
          "dashpots", [](const Fiber& f) { return std::string(dem::name(f.dashpots)); },
          "'bond_damping', 'retardation_time' or 'bending_only'.")
      .def_property_readonly(
          "mass_model", [](const Fiber& f) { return std::string(dem::name(f.mass)); },
          "'spheres' or 'cylinder'.")
      .def_property_readonly(
          "branch_count",
          [](const Fiber& f) {
            return f.branches.stretch.size() + f.branches.shear.size() + f.branches.twist.size() +
                   f.branches.bend.size();
          },
          "Maxwell branches beside the springs of a bond.");
}

}  // namespace

void bind_fiber(py::module_& module) {
  py::enum_<dem::DashpotLaw>(module, "Dashpots", "How dashpots are set.")
      .value("bond_damping", dem::DashpotLaw::bond_damping)
      .value("retardation_time", dem::DashpotLaw::retardation_time)
      .value("bending_only", dem::DashpotLaw::bending_only);
  py::class_<Fiber> fiber(module, "Fiber", "A fiber as the engine has it: bonds join its spheres.");
  fiber.def(py::init(&fiber_of_text), py::arg("text"), "The fiber of a scene's text.")
      .def(py::init<const Fiber&>(), py::arg("other"));
  bind_values(fiber);
  fiber.def_property_readonly("length", of_fiber<dem::fiber_length>(), "L = r_f d [m].")
      .def_property_readonly("mass", of_fiber<dem::fiber_mass>(), "Of all spheres [kg].")
      .def_property_readonly("bending_stiffness", of_fiber<dem::bending_stiffness>(), "E I [N m^2].")
      .def_property_readonly("axial_stiffness", of_fiber<dem::axial_stiffness>(), "E A [N].")
      .def_property_readonly("bond_time", of_fiber<dem::bond_time_step>(), "t_b = sqrt(m/K_n) [s], Eq 11.")
      .def_property_readonly(
          "stable_step", [](const Fiber& f) { return dem::stable_time_step(f); },
          "Largest stable step of the leapfrog, unloaded [s].");
  module.def("material_names", &dem::material_names);
  module.def("material", &material, py::arg("name"));
  module.def("calibrate", &calibrate, py::arg("fiber"), py::arg("measure"), py::arg("value"),
             py::arg("amplitude"), py::arg("step_ratio"), py::arg("dashpots"));
  module.def("calibration_of", &calibration_of, py::arg("fiber"), py::arg("amplitude"),
             py::arg("step_ratio"));
  module.def("damp_by_material", &damp_by_material, py::arg("fiber"), py::arg("material"),
             py::arg("loss_factor"), py::arg("band"));
}

}  // namespace fiberchain::python
