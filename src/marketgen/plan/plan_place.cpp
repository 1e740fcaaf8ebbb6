#include "plan/plan_place.h"

#include <algorithm>

#include "base/text.h"
#include "plan/plan.h"

namespace marketgen::plan {

Error in_plan_file(Error error, const std::string& file) {
  if (!error.where.starts_with('/')) return error;
  const std::string first = split(error.where, '/')[1];
  const auto& fields = type_of<Plan>().fields;
  const bool of_the_plan =
      std::ranges::any_of(fields, [&](const FieldInfo& field) { return field.name == first; });
  if (of_the_plan) error.where = file + ":" + error.where;
  return error;
}

}  // namespace marketgen::plan
