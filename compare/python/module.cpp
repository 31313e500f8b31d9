#include <pybind11/pybind11.h>

#include "compare/python/bindings.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/record/build_info.hpp"
#include "dem/record/errors.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/trajectory/h5md.hpp"
#include "reference/errors.hpp"

namespace {

namespace dem = fiberchain::dem;

/// What the program says, as the exceptions that Python has for it; all others are RuntimeError.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const dem::SceneError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const dem::InputError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const dem::InvalidInput& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const fiberchain::reference::InvalidArgument& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const dem::ReadError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const dem::WriteError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "Compiled part of fiberchain. Use the names of the package.";
  module.attr("version") = dem::kVersion;
  module.attr("commit") = dem::kCommit;
  pybind11::register_exception_translator(&translate);
  dem::leave_hdf5_as_it_is_at_exit();
  fiberchain::python::bind_fiber(module);
  fiberchain::python::bind_scenes(module);
  fiberchain::python::bind_rod(module);
  fiberchain::python::bind_trajectory(module);
  fiberchain::python::bind_packing(module);
  fiberchain::python::bind_identify(module);
}
