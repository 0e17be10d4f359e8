// What the library throws, as Python's exceptions. The package says them in its own words (knotfit/_words.py).
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "knotfit/exceptions.h"
namespace knotfit::python {
namespace py = pybind11;

void bind_errors(py::module_& m) {
  py::register_exception<InvalidInput>(m, "InvalidInput", PyExc_ValueError);
  py::register_exception<FileError>(m, "FileError", PyExc_ValueError).attr("__doc__") =
      "A file that cannot be read as what it claims to be, or an output that cannot be opened.";
  py::register_exception<WriteError>(m, "WriteError", PyExc_OSError).attr("__doc__") =
      "Writing began and failed, as on a full disk. No half-written file is left.";
  m.def(
      "remedies",
      [](const std::string& text) {
        std::vector<std::tuple<std::string, std::string, std::string>> found;
        for (const NamedRemedy& r : remedies_in(text))
          found.emplace_back(remedy_text(r.remedy, r.value), remedy_name(r.remedy), r.value);
        return found;
      },
      py::arg("text"), "Remedies that a text names: (as it stands there, name, value).");
  m.def(
      "all_remedies",
      [] {
        std::vector<std::string> names;
        for (const Remedy r : all_remedies()) names.emplace_back(remedy_name(r));
        return names;
      },
      "The name of every remedy.");
}

}  // namespace knotfit::python
