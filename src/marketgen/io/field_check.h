// What the rules of a field list say against values: one owner for readers, who ask about what a
// text holds, and for writers, who ask about what they hold. A document that passes is one that
// read_json accepts.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::io {

struct FieldFault {
  std::string_view code;  // json.out_of_range, json.bad_identifier...
  std::string message;
};

// Nothing when the rules hold. `type` is that of the number: what does not fit into it is a fault.
std::optional<FieldFault> fault_of_number(double value,
                                          const TypeInfo& type,
                                          const FieldRules& rules);
std::optional<FieldFault> fault_of_text(std::string_view text, const FieldRules& rules);
std::optional<FieldFault> fault_of_count(std::size_t count, const FieldRules& rules);

// Against the rules of the field of that name, for a flag that sets it. Precondition: there is one.
std::optional<FieldFault> fault_of_field_of(const TypeInfo& type,
                                            std::string_view name,
                                            double value);
template <class T>
std::optional<FieldFault> fault_of_field(std::string_view name, double value) {
  return fault_of_field_of(type_of<T>(), name, value);
}

// Of a list's entries: what a list says of its numbers and texts holds for each, its length does
// not.
FieldRules rules_of_elements(FieldRules rules);

// Every value below an object against its field's rules; the first fault, with
// "<source>:<JSON pointer>". Costs no more than walking over the object.
Result<void> check_fields_of(const TypeInfo& type, const void* object, const std::string& source);

template <class T>
Result<void> check_fields(const T& value, const std::string& source) {
  return check_fields_of(type_of<T>(), &value, source);
}

// A text as messages show it: quoted, and cut off when it is long.
std::string shown_text(std::string_view text);

}  // namespace marketgen::io
