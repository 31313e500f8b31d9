#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <memory>
#include <string>

#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "compare/python/scene_of.hpp"
#include "dem/trajectory/h5md.hpp"

// Frames, whose arrays are views of them, and files of frames.
namespace fiberchain::python {
namespace {

using dem::TrajectoryFrame;

py::dtype bond_type() {
  using Bond = dem::FrameBond;
  return record_type({{"first", "i8", offsetof(Bond, first)},
                      {"force", "3f8", offsetof(Bond, force)},
                      {"bending_angle", "f8", offsetof(Bond, bending_angle)}},
                     sizeof(Bond));
}

py::dtype contact_type() {
  using Contact = dem::FrameContact;
  return record_type({{"first", "i8", offsetof(Contact, first)},
                      {"second", "i8", offsetof(Contact, second)},
                      {"kind", "u1", offsetof(Contact, kind)},
                      {"point", "3f8", offsetof(Contact, point)},
                      {"normal", "3f8", offsetof(Contact, normal)},
                      {"force", "3f8", offsetof(Contact, force)}},
                     sizeof(Contact));
}

template <auto member>
py::array view(const py::object& self) {
  return view_of(self.cast<TrajectoryFrame&>().*member, self);
}

py::object contacts(const py::object& self) {
  const auto& frame = self.cast<TrajectoryFrame&>();
  if (!frame.has_contacts) return py::none();
  return records_of(frame.contacts, contact_type(), self);
}

std::shared_ptr<TrajectoryFrame> frame_at(const dem::TrajectoryReader& reader, std::int64_t n) {
  const FilesInUse files;
  return std::make_shared<TrajectoryFrame>(reader.read(n));
}

py::dict scalars(const dem::TrajectoryReader& reader, std::int64_t n) {
  const FilesInUse files;
  py::dict all;
  for (const auto& [name, value] : reader.scalars(n)) all[py::str(name)] = value;
  return all;
}

py::dict provenance(const dem::TrajectoryReader& reader) {
  py::dict all;
  for (const auto& [key, value] : reader.provenance()) all[py::str(key)] = value;
  return all;
}

void bind_frame(py::module_& module) {
  py::class_<TrajectoryFrame, std::shared_ptr<TrajectoryFrame>>(
      module, "Frame", "All spheres at one moment, fiber after fiber. Arrays are views: they keep the frame.")
      .def_readonly("time", &TrajectoryFrame::time, "[s]")
      .def_readonly("step", &TrajectoryFrame::step, "Steps done.")
      .def_property_readonly(
          "low", [](const TrajectoryFrame& f) { return tuple_of(f.low); },
          "Low corner of the box that is shown, or of the periodic cell [m].")
      .def_property_readonly(
          "high", [](const TrajectoryFrame& f) { return tuple_of(f.high); }, "Its high corner [m].")
      .def_property_readonly(
          "periodic",
          [](const TrajectoryFrame& f) {
            return py::make_tuple(f.periodic[0], f.periodic[1], f.periodic[2]);
          },
          "Whether x, y, z are.")
      .def_property_readonly("positions", &view<&TrajectoryFrame::position>, "float64 (spheres, 3) [m].")
      .def_property_readonly("velocities", &view<&TrajectoryFrame::velocity>, "float64 (spheres, 3) [m/s].")
      .def_property_readonly("radii", &view<&TrajectoryFrame::radius>, "float64 (spheres,) [m].")
      .def_property_readonly("fibers", &view<&TrajectoryFrame::fiber>,
                             "int32 (spheres,): number of each sphere's fiber.")
      .def_property_readonly(
          "bonds",
          [](const py::object& self) {
            return records_of(self.cast<TrajectoryFrame&>().bonds, bond_type(), self);
          },
          "Records (bonds,): first (sphere; the other is first + 1), force on it [N], bending_angle [rad].")
      .def_property_readonly(
          "contacts", &contacts,
          "Records (contacts,): first, second (sphere; of a wall its number from 1), kind (0 of "
          "two fibers, 1 of a wall, 2 of one fiber), point [m], normal, force on the first [N]. "
          "None where the file has none.");
}

}  // namespace

void bind_trajectory(py::module_& module) {
  bind_frame(module);
  py::class_<dem::TrajectoryReader>(module, "TrajectoryReader", "A trajectory NAME.h5 as it is now.")
      .def(py::init([](const std::string& path) {
             const FilesInUse files;
             return std::make_unique<dem::TrajectoryReader>(path);
           }),
           py::arg("path"))
      .def("__len__", &dem::TrajectoryReader::frames)
      .def_property_readonly(
          "steps",
          [](const py::object& self) { return view_of(self.cast<dem::TrajectoryReader&>().steps(), self); })
      .def_property_readonly(
          "times",
          [](const py::object& self) { return view_of(self.cast<dem::TrajectoryReader&>().times(), self); })
      .def_property_readonly("provenance", &provenance)
      .def("read", &frame_at, py::arg("number"))
      .def("scalars", &scalars, py::arg("number"));
}

}  // namespace fiberchain::python
