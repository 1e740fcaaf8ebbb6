#include "plan/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/text.h"
#include "io/field_check.h"
#include "io/json.h"
#include "plan/patch_change.h"
#include "plan/plan_edit.h"

namespace marketgen::plan {
namespace {

// The operation of a patch, type-erased.
struct Operation {
  std::string_view name;
  const TypeInfo* type = nullptr;
  const void* value = nullptr;
};

std::vector<Operation> operations_in(const Patch& patch) {
  std::vector<Operation> operations;
#define PLAN_PATCH(name, Type, what) \
  if (patch.name) operations.push_back({#name, &type_of<Type>(), &*patch.name});
#include "plan/patches.inc"
#undef PLAN_PATCH
  return operations;
}

Result<Operation> only_operation(const Patch& patch, const std::string& where) {
  const std::vector<Operation> operations = operations_in(patch);
  if (operations.size() == 1) return operations.front();
  if (operations.size() > 1) {
    return Error{"plan.bad_value",
                 where,
                 "has " + std::string(operations[0].name) + " and " +
                     std::string(operations[1].name) +
                     ", but a patch has one operation; write one object for each, in the order in "
                     "which they shall be done"};
  }
  std::string names;
#define PLAN_PATCH(name, Type, what) names += " " #name;
#include "plan/patches.inc"
#undef PLAN_PATCH
  return Error{"plan.bad_value", where, "has no operation; a patch has one of" + names};
}

// A fault of the outcome, told at the patch that led to it.
Error at_patch(Error error, const Operation& operation, std::string where) {
  const std::size_t start = error.where.find('/');
  const std::string pointer = start == std::string::npos ? "" : error.where.substr(start);
  const std::string last = pointer.substr(pointer.rfind('/') + 1);
  const bool is_said = std::ranges::any_of(operation.type->fields,
                                           [&](const FieldInfo& f) { return f.name == last; });
  if (is_said) where += "/" + last;
  if (!pointer.empty()) error.message += " (" + pointer + " of the changed plan)";
  error.where = std::move(where);
  return error;
}

// What a patch sets, as "set_fixture dairy levels" -> "6". Nothing for operations that may follow
// one another.
std::map<std::string, std::string> settings_of(const Operation& operation) {
  constexpr std::array<std::string_view, 5> subjects = {
      "node", "zone", "opening", "fixture", "field"};
  std::map<std::string, std::string> settings;
  const bool sets = (operation.name.starts_with("set_") && operation.name != "set_relation") ||
                    operation.name == "move_opening";
  if (!sets) return settings;
  std::string subject(operation.name);
  for (const FieldInfo& field : operation.type->fields) {
    const bool names = std::ranges::find(subjects, field.name) != subjects.end() &&
                       field.type().kind == TypeKind::string;
    const void* value = field.in(operation.value);
    if (names) {
      subject += " " + io::write_json_line_of(field.type(), value);
    } else if (field.name != "usual") {
      const bool said = field.type().kind != TypeKind::optional || field.type().count(value) > 0;
      if (said)
        settings[subject + " " + std::string(field.name)] =
            io::write_json_line_of(field.type(), value);
    }
  }
  return settings;
}

// Remembers what each patch has set; the error when another said something else.
class Agreement {
 public:
  Result<void> take(const Operation& operation, const std::string& where, std::size_t index) {
    for (const auto& [key, value] : settings_of(operation)) {
      const auto [known, is_new] = set_.try_emplace(key, Setting{value, index});
      if (is_new || known->second.value == value) continue;
      const std::string field = key.substr(key.rfind(' ') + 1);
      return Error{
          "plan.bad_value",
          fmt::format("{}/{}", where, field),
          fmt::format("contradicts /patches/{}, which sets {} to {} and not to {}; keep one "
                      "of them",
                      known->second.patch,
                      field,
                      known->second.value,
                      value)};
    }
    return {};
  }

 private:
  struct Setting {
    std::string value;
    std::size_t patch;
  };
  std::map<std::string, Setting> set_;
};

}  // namespace

std::string_view operation_of(const Patch& patch) {
  const std::vector<Operation> operations = operations_in(patch);
  return operations.empty() ? std::string_view() : operations.front().name;
}

Result<Patched> patched(const Plan& plan,
                        const Patch& patch,
                        const catalog::Catalog& catalog,
                        const std::string& where) {
  MARKETGEN_TRY(const Operation operation, only_operation(patch, where));
  Patched result{plan, {}};
  PlanChange task{result.plan, catalog, where + "/" + std::string(operation.name), {}};
#define PLAN_PATCH(name, Type, what) \
  if (patch.name) MARKETGEN_CHECK(change(task, *patch.name));
#include "plan/patches.inc"
#undef PLAN_PATCH
  result.paths = std::move(task.paths);
  return result;
}

Result<Plan> apply_patches(const Plan& plan,
                           const PatchSet& set,
                           const std::string& source,
                           Source by,
                           const catalog::Catalog& catalog) {
  MARKETGEN_CHECK(io::check_fields(set, source));
  Plan now = plan;
  Agreement agreement;
  for (std::size_t i = 0; i < set.patches.size(); ++i) {
    const Patch& patch = set.patches[i];
    const std::string where = source + ":/patches/" + std::to_string(i);
    Result<Patched> next = patched(now, patch, catalog, where);
    if (!next.ok()) {
      Error error = next.error();
      const bool was_there = i > 0 && patched(plan, patch, catalog, where).ok();
      if (was_there) error.message += "; a patch before it has taken away what it names";
      return error;
    }
    const Operation operation = operations_in(patch).front();
    const std::string place = where + "/" + std::string(operation.name);
    MARKETGEN_CHECK(agreement.take(operation, place, i));
    note_provenance(next->plan, next->paths, by);
    if (const auto valid = validate_plan(next->plan, "plan", catalog); !valid.ok())
      return at_patch(valid.error(), operation, place);
    now = std::move(next->plan);
  }
  return now;
}

Result<PatchSet> read_patches(std::string_view text, const std::string& source) {
  MARKETGEN_TRY(PatchSet set, io::read_json<PatchSet>(text, source));
  for (std::size_t i = 0; i < set.patches.size(); ++i)
    MARKETGEN_CHECK(only_operation(set.patches[i], source + ":/patches/" + std::to_string(i)));
  if (set.patches.empty()) {
    return Error{"plan.bad_value",
                 source + ":/patches",
                 "is empty; write at least one patch, as in {\"set_fixture\": {\"zone\": "
                 "\"dairy\", \"levels\": 6}}"};
  }
  return set;
}

}  // namespace marketgen::plan
