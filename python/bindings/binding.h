// What the parts of the Python module share: errors, and work with the interpreter let go.
#pragma once
#include <nanobind/nanobind.h>

#include <string>
#include <utility>

#include "base/fields.h"
#include "base/interrupt.h"
#include "base/result.h"

namespace marketgen::python {

namespace nb = nanobind;

// Raises marketgen.Error(code, where, message), or KeyboardInterrupt.
[[noreturn]] void raise(const Error& error);
void add_errors(nb::module_& module);
void add_cameras(nb::module_& module);
void add_photos(nb::module_& module);
void add_photo_numbers(nb::module_& module);
void add_stores(nb::module_& module);
void add_renderers(nb::module_& module);
void add_environments(nb::module_& module);
void add_evaluations(nb::module_& module);
void add_rankings(nb::module_& module);
void add_motions(nb::module_& module);
void add_program_policies(nb::module_& module);
void add_views(nb::module_& module);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result.ok()) raise(result.error());
  return std::move(result).value();
}
inline void check_or_raise(const Result<void>& result) {
  if (!result.ok()) raise(result.error());
}

// Calls `work`, which must not touch Python objects, while other Python threads run; Ctrl-C ends it
// as it does the program's commands.
template <class Work>
auto without_interpreter(const Work& work) {
  const InterruptWatch watch;
  const nb::gil_scoped_release released;
  return until_interrupted(work);
}

// The value that `text` names; raises usage.bad_flag at `where` with the names there are.
template <class Enum>
Enum named(const std::string& text, const std::string& where) {
  if (const auto value = value_named<Enum>(text)) return *value;
  std::string names;
  for (const std::string_view name : names_of(Enum{}))
    names += (names.empty() ? "" : ", ") + std::string(name);
  raise({"usage.bad_flag", where, "\"" + text + "\" is none of " + names});
}

}  // namespace marketgen::python
