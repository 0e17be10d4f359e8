// Arrays in and out: NumPy's memory is read in place, and results are handed over without a copy.
#pragma once
#include <pybind11/numpy.h>

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "knotfit/index.h"
namespace knotfit::python {
namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style>;
using Faces = py::array_t<std::int32_t, py::array::c_style>;

inline std::span<const double> span_of(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// A copy. Of a large array into large pages where the system has them: most of its time is the first touch of each page.
std::vector<double> vector_of(const Array& array);

/// An array that owns the vector's memory.
template <class T>
py::array_t<T> array_of(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(std::move(shape), kept->data(), owner);
}

template <class T>
py::array_t<T> array_of(std::vector<T> values) {
  const auto n = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {n});
}

}  // namespace knotfit::python
