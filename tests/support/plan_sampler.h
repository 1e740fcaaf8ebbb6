// Plans that take every value which market-plan/1 offers: the ends of every range, every name of
// every enumeration, every material, fixture kind and zone type. The fields come from the field
// lists, so that a new field, name or row is sampled as soon as it is there.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/seed.h"
#include "plan/plan.h"
#include "support/committed_catalog.h"

namespace marketgen {

// Small, so that its whole chain is quick: tills and one zone of goods, with everything in it that
// a plan can have.
inline plan::Plan sampled_shop() {
  plan::Plan plan;
  plan.shell.width_mm = 8000;
  plan.shell.depth_mm = 9000;
  plan.shell.openings = {{"in", plan::OpeningKind::entrance, plan::Wall::south, 0.25, 1800},
                         {"out", plan::OpeningKind::exit, plan::Wall::south, 0.75, 1800},
                         {"side", plan::OpeningKind::window, plan::Wall::north, 0.5, 1200}};
  plan.shell.columns = {{7600, 8600, 300}};
  plan::Node root, front, back;
  root.id = "root";
  root.split = plan::Axis::y;
  root.ratio = 0.45;
  root.gap_mm = 1200;
  root.children = {"front", "back"};
  front.id = "front";
  front.zone = "tills";
  back.id = "back";
  back.zone = "goods";
  plan.nodes = {root, front, back};
  plan::Zone tills, goods;
  tills.id = "tills";
  tills.type = "checkout";
  tills.fixture.kind = "checkout_lane";
  goods.id = "goods";
  goods.type = "canned";
  goods.stock.exclude = {"soup"};
  plan.zones = {tills, goods};
  plan::Relation relation;
  relation.a = "goods";
  relation.b = "north";
  plan.relations = {relation};
  const std::vector<catalog::Product>& products = committed_catalog().products;
  plan.placements = {{products.front().sku, {1, 4.6, 0}, 0},
                     {products.back().sku, {1, 5.2, 0}, 30}};
  return plan;
}

class PlanSampler {
 public:
  // A field of the sampled shop, and the values that it is given in turn.
  struct Knob {
    std::string path;  // JSON pointer
    std::size_t count;
    std::function<void(plan::Plan&, std::size_t)> set;
    std::vector<int> taken = {};  // how often each value was part of a valid plan
  };

  PlanSampler() {
    collect(
        type_of<plan::Plan>(), {}, [](plan::Plan& plan) { return static_cast<void*>(&plan); }, "");
    for (Knob& knob : knobs_)
      knob.taken.resize(knob.count);
  }

  const std::vector<Knob>& knobs() const { return knobs_; }

  // Rounds after which each value has had its turn.
  std::size_t rounds() const {
    std::size_t most = 0;
    for (const Knob& knob : knobs_)
      most = std::max(most, knob.count);
    return most;
  }

  // Every field at one of its values, each at another in the next round; a value that makes the
  // plan invalid gives way to what was there.
  plan::Plan plan(std::size_t round) {
    plan::Plan plan = sampled_shop();
    for (std::size_t k = 0; k < knobs_.size(); ++k)
      turn(plan, knobs_[k], (round + 5 * k) % knobs_[k].count);
    return plan;
  }

  // A few fields at values that chance decides.
  plan::Plan random_plan(Stream& draw) {
    plan::Plan plan = sampled_shop();
    for (Knob& knob : knobs_) {
      if (!draw.chance(0.15)) continue;
      turn(plan, knob, static_cast<std::size_t>(draw.integer(0, static_cast<int>(knob.count) - 1)));
    }
    return plan;
  }

  // The same, valid or not.
  plan::Plan wild_plan(Stream& draw) const {
    plan::Plan plan = sampled_shop();
    for (const Knob& knob : knobs_) {
      if (!draw.chance(0.05)) continue;
      knob.set(plan, static_cast<std::size_t>(draw.integer(0, static_cast<int>(knob.count) - 1)));
    }
    return plan;
  }

 private:
  using At = std::function<void*(plan::Plan&)>;

  // Leaves of the tree are not cut.
  static bool is_cut_of_a_leaf(const std::string& path) {
    const bool leaf = path.starts_with("/nodes/1/") || path.starts_with("/nodes/2/");
    return leaf &&
           (path.ends_with("/split") || path.ends_with("/ratio") || path.ends_with("/gap_mm"));
  }

  static void turn(plan::Plan& plan, Knob& knob, std::size_t value) {
    const plan::Plan before = plan;
    knob.set(plan, value);
    if (plan::validate_plan(plan, "sample", committed_catalog()).ok())
      ++knob.taken[value];
    else
      plan = before;
  }

  void add(const std::string& path,
           std::size_t count,
           std::function<void(plan::Plan&, std::size_t)> set) {
    knobs_.push_back({path, count, std::move(set)});
  }

  void collect(const TypeInfo& type,
               const FieldRules& rules,
               const At& at,
               const std::string& path) {
    if (is_cut_of_a_leaf(path)) return;
    switch (type.kind) {
      case TypeKind::object:
        for (const FieldInfo& field : type.fields)
          collect(
              field.type(),
              field.rules,
              [at, &field](plan::Plan& plan) { return field.in(at(plan)); },
              path + "/" + std::string(field.name));
        return;
      case TypeKind::array:
        return collect_entries(type, rules, at, path);
      case TypeKind::optional:
        return collect_optional(type, rules, at, path);
      case TypeKind::boolean:
        return collect_whole(type, {0, 1}, at, path);
      case TypeKind::enumeration: {
        std::vector<std::int64_t> all;
        for (std::size_t i = 0; i < type.names.size(); ++i)
          all.push_back(static_cast<std::int64_t>(i));
        return collect_whole(type, all, at, path);
      }
      case TypeKind::integer: {
        const auto values = ends_of(path, rules);
        return collect_whole(type, {values.begin(), values.end()}, at, path);
      }
      case TypeKind::number: {
        const std::vector<double> values = ends_of(path, rules);
        if (!values.empty())
          add(path, values.size(), [&type, at, values](plan::Plan& plan, std::size_t i) {
            type.set_number(at(plan), values[i]);
          });
        return;
      }
      case TypeKind::string: {
        const std::vector<std::string> values = names_for(path);
        if (!values.empty())
          add(path, values.size(), [at, values](plan::Plan& plan, std::size_t i) {
            *static_cast<std::string*>(at(plan)) = values[i];
          });
        return;
      }
    }
  }

  void collect_whole(const TypeInfo& type,
                     const std::vector<std::int64_t>& values,
                     const At& at,
                     const std::string& path) {
    if (values.empty()) return;
    add(path, values.size(), [&type, at, values](plan::Plan& plan, std::size_t i) {
      type.set_integer(at(plan), values[i]);
    });
  }

  void collect_entries(const TypeInfo& type,
                       const FieldRules& rules,
                       const At& at,
                       const std::string& path) {
    plan::Plan sample = sampled_shop();
    const std::size_t count = type.count(at(sample));
    for (std::size_t i = 0; i < count; ++i)
      collect(
          type.element(),
          rules,
          [at, &type, i](plan::Plan& plan) { return type.at(at(plan), i); },
          path + "/" + std::to_string(i));
  }

  // Absent, and then each value of what it may hold.
  void collect_optional(const TypeInfo& type,
                        const FieldRules& rules,
                        const At& at,
                        const std::string& path) {
    const TypeInfo& element = type.element();
    if (element.kind == TypeKind::object || element.kind == TypeKind::array) return;
    const std::size_t before = knobs_.size();
    const At inside = [at, &type](plan::Plan& plan) {
      if (type.count(at(plan)) == 0) type.resize(at(plan), 1);
      return type.at(at(plan), 0);
    };
    collect(element, rules, inside, path);
    if (knobs_.size() == before) return;
    Knob& knob = knobs_.back();
    knob.count += 1;
    knob.set = [at, &type, set = std::move(knob.set)](plan::Plan& plan, std::size_t i) {
      if (i == 0)
        type.resize(at(plan), 0);
      else
        set(plan, i - 1);
    };
  }

  // Both ends of a range and its middle; where other fields of the shop leave less, of what they
  // leave. A room stays small: large ones are another test's.
  static std::vector<double> ends_of(const std::string& path, const FieldRules& rules) {
    if (path == "/shell/width_mm") return {7600, 8000, 9000, 12000};
    if (path == "/shell/depth_mm") return {8800, 9000, 10000, 12000};
    if (path.ends_with("/center")) return {0.25, 0.5, 0.75};
    if (path.starts_with("/shell/openings/")) return {rules.min, 1500, 3000};
    if (path.starts_with("/shell/columns/") && !path.ends_with("/size_mm"))
      return {1000, 4000, 7600};
    if (path.starts_with("/placements/") && path.find("/position_m/") != std::string::npos)
      return {0.5, 1, 2};
    if (path.ends_with("/facings/0")) return {rules.min, 2};
    if (path.ends_with("/facings/1")) return {5, rules.max};
    if (path.starts_with("/zones/0/fixture/")) return built_ends(path, "checkout_lane", rules);
    if (path.starts_with("/zones/1/fixture/")) return built_ends(path, "gondola", rules);
    return all_ends(rules);
  }

  // What a kind is built in, which is less than a plan may say.
  static std::vector<double> built_ends(const std::string& path,
                                        std::string_view name,
                                        const FieldRules& rules) {
    const catalog::FixtureKind* kind = committed_catalog().fixture_kind(name);
    const auto of = [](const IntRange& range) {
      return std::vector<double>{
          double(range[0]), double((range[0] + range[1]) / 2), double(range[1])};
    };
    if (path.ends_with("/depth_mm")) return of(kind->depth_range_mm);
    if (path.ends_with("/height_mm")) return of(kind->height_range_mm);
    if (path.ends_with("/levels"))
      return of({std::max(1, kind->level_range[0]), std::max(1, kind->level_range[1])});
    return all_ends(rules);
  }

  static std::vector<double> all_ends(const FieldRules& rules) {
    if (!std::isfinite(rules.min) || !std::isfinite(rules.max)) return {};
    return {rules.min, std::floor((rules.min + rules.max) / 2), rules.max};
  }

  template <class Row>
  static std::vector<std::string> all(const std::vector<Row>& rows, std::string Row::*name) {
    std::vector<std::string> names;
    for (const Row& row : rows)
      names.push_back(row.*name);
    return names;
  }

  static std::vector<std::string> names_for(const std::string& path) {
    const catalog::Catalog& catalog = committed_catalog();
    const std::string last = path.substr(path.rfind('/') + 1);
    if (path.starts_with("/look/") && last != "accent")
      return all(catalog.materials, &catalog::MaterialRow::id);
    if (last == "material") return all(catalog.materials, &catalog::MaterialRow::id);
    if (last == "profile") return all(catalog.profiles, &catalog::ProfileRow::id);
    if (last == "accent" || last == "color") return {"#000000", "#ffffff", "#2e7d32"};
    if (path == "/zones/1/type") return all(catalog.zone_types, &catalog::ZoneTypeRow::type);
    if (path == "/zones/1/fixture/kind")
      return all(catalog.fixture_kinds, &catalog::FixtureKind::kind);
    if (last == "anchor") return {"any", "north", "south", "east", "west", "center", "entrance"};
    if (last == "label") return {"", "Goods & more", "Früchte"};
    if (last == "name") return {"Market", "A", "Früchte & Gemüse <1>"};
    if (path == "/relations/0/b") return {"north", "tills", "in", "entrance", "checkout", "center"};
    return {};
  }

  std::vector<Knob> knobs_;
};

}  // namespace marketgen
