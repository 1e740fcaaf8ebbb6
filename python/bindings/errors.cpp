#include <nanobind/stl/string.h>

#include "base/error_codes.h"
#include "base/safe_line.h"
#include "binding.h"

namespace marketgen::python {
namespace {

PyObject* error_of_library = nullptr;  // makes a marketgen.Error; lives as long as the module

}  // namespace

void raise(const Error& error) {
  constexpr std::size_t longest_where = 300, longest_message = 2000;
  if (error.code == "internal.interrupted") {
    if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw nb::python_error();
  }
  const nb::object made = nb::borrow(error_of_library)(
      error.code, safe_line(error.where, longest_where), safe_line(error.message, longest_message));
  PyErr_SetObject(made.type().ptr(), made.ptr());
  throw nb::python_error();
}

void add_errors(nb::module_& module) {
  const nb::module_ errors = nb::module_::import_("marketgen.errors");
  module.attr("Error") = errors.attr("Error");
  const nb::object of_library = errors.attr("of_library");
  error_of_library = of_library.ptr();
  module.attr("_error_of_library") = of_library;
  module.def("exit_status_of", [](const std::string& code) { return exit_status_of(code); });
  // Of a loop that ran outside without_interpreter() while another call was interrupted.
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace marketgen::python
