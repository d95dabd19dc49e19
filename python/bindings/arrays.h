// Internal to the module: arrays of numpy from and to our vectors, and failures as exceptions.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <vector>

#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh::python {

namespace py = pybind11;

/// Raises beadmesh.BeadmeshError with all fields of the diagnostic.
[[noreturn]] void raise(const Diagnostic& diagnostic);

template <class T>
T value_or_raise(Result<T>&& result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

py::dict dict_of(const Diagnostic& diagnostic);
py::list dicts_of(const std::vector<Diagnostic>& diagnostics);

/// (n, 3) and (n, 2), float64.
py::array_t<double> array_of(const std::vector<Vec3>& points);
py::array_t<double> array_of(const std::vector<Vec2>& points);
/// (n,), int32.
py::array_t<Index> array_of(const std::vector<Index>& items);
/// (n,), float64.
py::array_t<double> array_of(const std::vector<double>& items);

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using IndexArray = py::array_t<Index, py::array::c_style | py::array::forcecast>;

/// Points of an array of shape (n, columns). Fails with python.shape, which names the argument.
Result<std::vector<Vec2>> points2_of(const DoubleArray& array, const char* name);
Result<std::vector<Vec3>> points3_of(const DoubleArray& array, const char* name);

}  // namespace beadmesh::python
