#pragma once

#include <pybind11/pybind11.h>

// The parts of the module.
namespace fiberchain::python {

void bind_fiber(pybind11::module_& module);       ///< fibers, materials, calibration
void bind_scenes(pybind11::module_& module);      ///< scenes run as the program does, tables
void bind_packing(pybind11::module_& module);     ///< packings step by step
void bind_rod(pybind11::module_& module);         ///< rods held and loaded in any way
void bind_trajectory(pybind11::module_& module);  ///< frames and files of them
void bind_identify(pybind11::module_& module);    ///< ring-downs

}  // namespace fiberchain::python
