#include "io/field_check.h"
#include "io/json.h"
#include "plan/plan.h"
#include "plan/validation.h"

namespace marketgen::plan {

std::string element_pointer(std::string_view list, std::size_t index, std::string_view rest) {
  std::string pointer = "/";
  pointer.append(list).append("/").append(std::to_string(index));
  if (!rest.empty()) pointer.append("/").append(rest);
  return pointer;
}

Result<void> validate_plan(const Plan& plan,
                           const std::string& source,
                           const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(io::check_fields(plan, source));
  const PlanCheck check{plan, catalog, source};
  using Part = Result<void> (*)(const PlanCheck&);
  constexpr Part parts[] = {check_ids,
                            check_shell,
                            check_openings,
                            check_tree,
                            check_room,
                            check_names,
                            check_zone_values,
                            check_equipment,
                            check_references};
  for (const Part part : parts)
    MARKETGEN_CHECK(part(check));
  return {};
}

Result<Plan> read_plan(std::string_view text,
                       const std::string& source,
                       const catalog::Catalog& catalog) {
  MARKETGEN_TRY(Plan plan, io::read_json<Plan>(text, source));
  MARKETGEN_CHECK(validate_plan(plan, source, catalog));
  return plan;
}

}  // namespace marketgen::plan
