// marketgen._core: the C++ program's library for Python. Documents cross as JSON texts, which
// marketgen/*.py turns into dicts; planes of pictures cross as NumPy arrays without a copy.
#include <nanobind/stl/string.h>

#include "base/build_info.h"
#include "binding.h"
#include "io/program.h"

NB_MODULE(_core, module) {
  using namespace marketgen::python;
  module.attr("__version__") = marketgen::program_version;
  module.def("use_python", &marketgen::io::use_python, nb::arg("interpreter"));
  add_errors(module);
  add_cameras(module);
  add_photos(module);
  add_photo_numbers(module);
  add_stores(module);
  add_renderers(module);
  add_environments(module);
  add_evaluations(module);
  add_rankings(module);
  add_motions(module);
  add_program_policies(module);
  add_views(module);
}
