// The parts of the extension module, a file each.
#pragma once
#include <pybind11/pybind11.h>
namespace knotfit::python {

void bind_errors(pybind11::module_& m);
void bind_options(pybind11::module_& m);
void bind_sources(pybind11::module_& m);
void bind_surface(pybind11::module_& m);
void bind_nearest(pybind11::module_& m);
void bind_fit(pybind11::module_& m);
void bind_compare(pybind11::module_& m);
void bind_map(pybind11::module_& m);
void bind_curve(pybind11::module_& m);
void bind_files(pybind11::module_& m);

}  // namespace knotfit::python
