#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/math/vec.hpp"
#include "dem/record/table.hpp"

// Arrays of numpy that share memory with values of C++.
namespace fiberchain::python {

namespace py = pybind11;
using V = dem::Vec<double, 3>;
static_assert(sizeof(V) == 3 * sizeof(double));

/// Takes a vector over: the array owns it, nothing is copied.
template <class Number>
py::array_t<Number> array_of(std::vector<Number> values) {
  auto owned = std::make_unique<std::vector<Number>>(std::move(values));
  const Number* data = owned->data();
  const auto size = static_cast<py::ssize_t>(owned->size());
  const py::capsule owner(owned.release(), [](void* v) { delete static_cast<std::vector<Number>*>(v); });
  return py::array_t<Number>(size, data, owner);
}

/// The same of vectors in space: shape (n, 3).
inline py::array_t<double> array_of(std::vector<V> values) {
  auto owned = std::make_unique<std::vector<V>>(std::move(values));
  const auto* data = reinterpret_cast<const double*>(owned->data());
  const auto size = static_cast<py::ssize_t>(owned->size());
  const py::capsule owner(owned.release(), [](void* v) { delete static_cast<std::vector<V>*>(v); });
  return py::array_t<double>({size, py::ssize_t{3}}, data, owner);
}

/// Of a chain's spheres, shape (n, 3).
inline py::array_t<double> positions_of(const dem::Poses<3>& poses) {
  std::vector<V> all;
  for (const auto& pose : poses) all.push_back(pose.position);
  return array_of(std::move(all));
}

/// A view of what `owner` holds, which it keeps alive.
inline py::array view_of(const std::vector<V>& values, py::handle owner) {
  return py::array(py::dtype::of<double>(), {static_cast<py::ssize_t>(values.size()), py::ssize_t{3}}, {},
                   values.data(), owner);
}
template <class Number>
py::array view_of(const std::vector<Number>& values, py::handle owner) {
  return py::array(py::dtype::of<Number>(), {static_cast<py::ssize_t>(values.size())}, {}, values.data(),
                   owner);
}
/// The same of records, as a structured dtype has them.
template <class Record>
py::array records_of(const std::vector<Record>& values, const py::dtype& type, py::handle owner) {
  return py::array(type, {static_cast<py::ssize_t>(values.size())}, {}, values.data(), owner);
}

/// A field of a structured dtype.
struct Field {
  const char* name;
  const char* format;
  std::size_t offset;
};
py::dtype record_type(const std::vector<Field>& fields, std::size_t size);

/// Columns by name: float64 (NaN where missing), int64, or str.
py::dict dict_of(const dem::Table& table);

inline py::tuple tuple_of(const V& v) { return py::make_tuple(v[0], v[1], v[2]); }

}  // namespace fiberchain::python
