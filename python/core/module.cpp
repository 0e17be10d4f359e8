// knotfit._core: the library for the Python around it, which alone is for users. Arrays come in as float64, C order.
#include "bind.h"
#include "knotfit/threads.h"
#include "knotfit/version.h"

PYBIND11_MODULE(_core, m) {
  using namespace knotfit::python;
  m.doc() = "The compiled part of knotfit; use the package.";
  m.attr("__version__") = std::string(knotfit::version());
  bind_errors(m);
  bind_options(m);
  bind_sources(m);
  bind_surface(m);
  bind_nearest(m);
  bind_fit(m);
  bind_compare(m);
  bind_map(m);
  bind_curve(m);
  bind_files(m);
}
