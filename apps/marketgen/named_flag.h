// An option whose value is one of a list of names.
#pragma once
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::app {

// As the type of an option: "{text,csv}". Help shows it, and shells complete it.
template <class Names>
std::string choice_of(const Names& names) {
  return fmt::format("{{{}}}", fmt::join(names, ","));
}

// `no_such` begins the message about another name: "there is no split". Error usage.bad_flag, with
// the names there are.
template <class Enum>
Result<Enum> value_of_flag(const char* flag, std::string_view no_such, const std::string& name) {
  if (const auto value = value_named<Enum>(name)) return *value;
  return Error{
      "usage.bad_flag",
      flag,
      fmt::format("{} \"{}\"; there are: {}", no_such, name, fmt::join(names_of(Enum{}), ", "))};
}

}  // namespace marketgen::app
