#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "compare/identify/identify.hpp"
#include "compare/identify/record_csv.hpp"
#include "compare/identify/table.hpp"
#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "dem/model/errors.hpp"

// Ring-downs.
namespace fiberchain::python {
namespace {

using Samples = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> vector_of(const Samples& samples, const char* name) {
  if (samples.ndim() != 1) throw dem::InvalidInput(std::string(name) + " must have one dimension");
  return {samples.data(), samples.data() + samples.size()};
}

py::object estimate(const std::optional<compare::Estimate>& e) {
  return e ? py::object(py::make_tuple(e->value, e->low, e->high)) : py::none();
}

py::dict identify(const Samples& time, const Samples& displacement, const std::optional<dem::Fiber>& fiber,
                  const std::string& of, double confidence) {
  if (of != "beam" && of != "chain")
    throw dem::InvalidInput("of = " + of + " is not allowed; allowed: beam, chain");
  const compare::IdentifyCase asked{
      .record = {vector_of(time, "time"), vector_of(displacement, "displacement")},
      .fiber = fiber,
      .of = of == "beam" ? compare::RecordOf::beam : compare::RecordOf::chain,
      .confidence = confidence};
  compare::Identification found = [&] {
    const py::gil_scoped_release release;
    return compare::identify(asked);
  }();
  py::dict all;
  for (const auto& [name, value] : {std::pair{"frequency", found.frequency},
                                    {"damping_ratio", found.damping_ratio},
                                    {"log_decrement", found.log_decrement},
                                    {"loss_factor", found.loss_factor}})
    all[name] = estimate(value);
  all["youngs_modulus"] = estimate(found.youngs_modulus);
  all["bond_damping"] = estimate(found.bond_damping);
  all["table"] = dict_of(compare::identification_table(found));
  all["noise"] = found.noise;
  all["amplitude"] = found.amplitude;
  all["periods"] = found.periods;
  all["modes"] = found.fit.modes.size();
  all["doubts"] = found.doubts;
  all["warnings"] = found.warnings;
  all["residuals"] = array_of(std::move(found.fit.residuals));
  return all;
}

py::tuple read_record(const std::string& path, const std::string& time, const std::string& displacement,
                      double time_unit) {
  compare::RingDownRecord record = compare::read_record(
      std::filesystem::path(path), {.time = time, .displacement = displacement, .time_unit = time_unit});
  return py::make_tuple(array_of(std::move(record.time)), array_of(std::move(record.displacement)));
}

}  // namespace

void bind_identify(py::module_& module) {
  module.def("identify", &identify, py::arg("time"), py::arg("displacement"), py::arg("fiber"), py::arg("of"),
             py::arg("confidence"));
  module.def("read_record", &read_record, py::arg("path"), py::arg("time"), py::arg("displacement"),
             py::arg("time_unit"));
}

}  // namespace fiberchain::python
