#include "arrays.h"

#include <algorithm>
#include <string>

namespace beadmesh::python {
namespace {

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t k = 0; k < array.ndim(); ++k) text += (k ? ", " : "") + std::to_string(array.shape(k));
  return text + ")";
}

Result<void> check_shape(const py::array& array, py::ssize_t columns, const char* name) {
  if (array.ndim() == 2 && array.shape(1) == columns) return {};
  return fail("python.shape", std::string(name) + " has the shape " + shape_of(array),
              "it must be (n, " + std::to_string(columns) + ")");
}

}  // namespace

void raise(const Diagnostic& diagnostic) {
  const py::object type = py::module_::import("beadmesh._errors").attr("BeadmeshError");
  const py::object error = type(**dict_of(diagnostic));
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

py::dict dict_of(const Diagnostic& d) {
  py::dict out;
  out["code"] = d.code;
  out["severity"] = std::string(name_of(d.severity));
  out["face"] = d.face == no_index ? py::object(py::none()) : py::object(py::int_(d.face));
  out["entity"] = d.entity;
  out["message"] = d.message;
  out["hint"] = d.hint;
  return out;
}

py::list dicts_of(const std::vector<Diagnostic>& diagnostics) {
  py::list out;
  for (const Diagnostic& one : diagnostics) out.append(dict_of(one));
  return out;
}

py::array_t<double> array_of(const std::vector<Vec3>& points) {
  py::array_t<double> out({py::ssize_t(points.size()), py::ssize_t(3)});
  double* at = out.mutable_data();
  for (const Vec3& p : points) *at++ = p.x, *at++ = p.y, *at++ = p.z;
  return out;
}

py::array_t<double> array_of(const std::vector<Vec2>& points) {
  py::array_t<double> out({py::ssize_t(points.size()), py::ssize_t(2)});
  double* at = out.mutable_data();
  for (const Vec2& p : points) *at++ = p.x, *at++ = p.y;
  return out;
}

py::array_t<Index> array_of(const std::vector<Index>& items) {
  return py::array_t<Index>(py::ssize_t(items.size()), items.data());
}

py::array_t<double> array_of(const std::vector<double>& items) {
  return py::array_t<double>(py::ssize_t(items.size()), items.data());
}

Result<std::vector<Vec2>> points2_of(const DoubleArray& array, const char* name) {
  if (auto good = check_shape(array, 2, name); !good) return tl::unexpected(good.error());
  std::vector<Vec2> points(array.shape(0));
  const double* at = array.data();
  for (Vec2& p : points) p = {at[0], at[1]}, at += 2;
  return points;
}

Result<std::vector<Vec3>> points3_of(const DoubleArray& array, const char* name) {
  if (auto good = check_shape(array, 3, name); !good) return tl::unexpected(good.error());
  std::vector<Vec3> points(array.shape(0));
  const double* at = array.data();
  for (Vec3& p : points) p = {at[0], at[1], at[2]}, at += 3;
  return points;
}

}  // namespace beadmesh::python
