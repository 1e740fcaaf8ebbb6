#include <nanobind/stl/string.h>

#include "binding.h"

namespace marketgen::python {
namespace {

PyObject* error_type = nullptr;  // marketgen.Error, which lives as long as the module

}  // namespace

void raise(const Error& error) {
  if (error.code == "internal.interrupted") {
    if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw nb::python_error();
  }
  const nb::object made = nb::borrow(error_type)(error.code, error.where, error.message);
  PyErr_SetObject(error_type, made.ptr());
  throw nb::python_error();
}

void add_errors(nb::module_& module) {
  const nb::object type = nb::module_::import_("marketgen.errors").attr("Error");
  error_type = type.ptr();
  module.attr("Error") = type;
}

}  // namespace marketgen::python
