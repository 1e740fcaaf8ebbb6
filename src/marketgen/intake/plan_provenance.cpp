#include "intake/plan_provenance.h"

#include <algorithm>

namespace marketgen::intake {
namespace {

// The field of a zone's stock that such a wish sets.
std::string stock_path(std::string_view subject) {
  return subject.starts_with("tags_") ? "stock/price_tags" : "stock/" + std::string(subject);
}

using Kind = plan::RequirementKind;

constexpr std::size_t max_entries = 2000;  // limit of Plan::provenance
constexpr double said = 1, implied = 0.7;

class ProvenanceWriter {
 public:
  ProvenanceWriter(const plan::Plan& plan, const PlanSources& sources)
      : plan_(plan), sources_(sources) {}

  std::vector<plan::Provenance> run() {
    add_flags();
    add_drawing();
    add_drawn_zones();
    if (const auto& name = sources_.understanding.name) add("/name", name->span, said);
    add_photographed();
    for (const plan::Requirement& wish : sources_.understanding.requirements)
      add_wish(wish);
    for (const Emphasis& emphasis : sources_.understanding.emphases) {
      for_zones(emphasis.zone, "area_m2/target", emphasis.span, implied);
    }
    if (entries_.size() > max_entries) entries_.resize(max_entries);
    return std::move(entries_);
  }

 private:
  plan::Provenance& add_entry(std::string path, plan::Source source, double confidence) {
    plan::Provenance& entry = entries_.emplace_back();
    entry.path = std::move(path);
    entry.source = source;
    entry.confidence = confidence;
    return entry;
  }

  void add(std::string path, IntRange span, double confidence) {
    add_entry(std::move(path), plan::Source::text, confidence).span = span;
  }

  void add_flag(std::string path) {
    plan::Provenance& entry = entries_.emplace_back();
    entry.path = std::move(path);
    entry.source = plan::Source::flag;
  }

  void add_flags() {
    if (sources_.brief.size_mm) {
      add_flag("/shell/width_mm");
      add_flag("/shell/depth_mm");
    }
    if (sources_.brief.profile) add_flag("/profile");
    if (sources_.brief.style) add_flag("/look");
  }

  void add_drawn(std::string path) {
    add_entry(std::move(path), plan::Source::drawing, sources_.brief.shell_confidence);
  }

  // Where a drawing has zones, each of its types' zones and how the floor is cut.
  void add_drawn_zones() {
    if (!sources_.program.drawn) return;
    add_drawn("/nodes");
    const std::vector<std::string> ids = sources_.program.drawn->ids();
    for (std::size_t i = 0; i < plan_.zones.size(); ++i)
      if (std::ranges::find(ids, plan_.zones[i].id) != ids.end())
        add_drawn("/zones/" + std::to_string(i));
    for (const ProgramZone& zone : sources_.program.zones)
      if (zone.drawn_runs) add_drawn_runs(zone);
  }

  void add_drawn_runs(const ProgramZone& zone) {
    const auto at = std::ranges::find(plan_.zones, zone.id, &plan::Zone::id);
    if (at == plan_.zones.end()) return;
    const std::string fixture = "/zones/" + std::to_string(at - plan_.zones.begin()) + "/fixture/";
    add_entry(fixture + "axis", plan::Source::drawing, zone.drawn_runs->confidence);
    if (zone.main.runs)
      add_entry(fixture + "runs", plan::Source::drawing, zone.drawn_runs->confidence);
  }

  // What a floor plan says, but for the size where somebody said another.
  void add_drawing() {
    if (!sources_.program.shell) return;
    const plan::Shell& drawn = *sources_.program.shell;
    const bool sized = sources_.brief.size_mm || sources_.understanding.find(Kind::size) != nullptr;
    if (!sized) add_drawn("/shell/width_mm");
    if (!sized) add_drawn("/shell/depth_mm");
    if (drawn.outline_mm) add_drawn("/shell/outline_mm");
    if (!drawn.columns.empty()) add_drawn("/shell/columns");
    for (std::size_t i = 0; i < plan_.shell.openings.size(); ++i) {
      const auto same = [&](const plan::Opening& one) {
        return one.id == plan_.shell.openings[i].id;
      };
      if (std::ranges::any_of(drawn.openings, same))
        add_drawn("/shell/openings/" + std::to_string(i));
    }
  }

  template <class T>
  void add_shown(const std::string& path, const std::optional<Photographed<T>>& shown) {
    if (shown) add_entry(path, shown->source, shown->confidence);
  }

  void add_photographed() {
    const PhotoWishes& shown = sources_.understanding.photographed;
    add_shown("/profile", shown.profile);
    add_shown("/look/floor", shown.floor);
    add_shown("/look/wall", shown.wall);
    add_shown("/look/ceiling", shown.ceiling);
    add_shown("/look/fixture", shown.fixture);
    add_shown("/look/lamps", shown.lamps);
    add_shown("/look/light_kelvin", shown.light_kelvin);
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      if (plan_.zones[i].fixture.kind != "gondola") continue;
      add_shown_shelves("/zones/" + std::to_string(i) + "/fixture/", plan_.zones[i], shown);
    }
  }

  // Of one zone's gondolas: what photos show and the plan has.
  void add_shown_shelves(const std::string& fixture,
                         const plan::Zone& zone,
                         const PhotoWishes& shown) {
    const bool own = sources_.understanding.find(Kind::levels, zone.type) != nullptr;
    if (!own && shown.levels && zone.fixture.levels == shown.levels->value)
      add_shown(fixture + "levels", shown.levels);
    add_shown(fixture + "aisle_mm", shown.aisle_mm);
    const bool across = zone.fixture.axis ==
                        (front_runs_east(sources_.candidate) ? plan::RunAxis::x : plan::RunAxis::y);
    if (shown.across && shown.across->value == across) add_shown(fixture + "axis", shown.across);
  }

  // An entry for `field` of each zone of the type; every zone when `type` is empty.
  void for_zones(const std::string& type,
                 const std::string& field,
                 IntRange span,
                 double confidence) {
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      if (!type.empty() && plan_.zones[i].type != type) continue;
      std::string path = "/zones/" + std::to_string(i);
      if (!field.empty()) path += "/" + field;
      add(std::move(path), span, confidence);
    }
  }

  void for_gondolas(const std::string& field, IntRange span) {
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      if (plan_.zones[i].fixture.kind != "gondola") continue;
      add("/zones/" + std::to_string(i) + "/fixture/" + field, span, said);
    }
  }

  void for_openings(const plan::Requirement& wish) {
    for (std::size_t i = 0; i < plan_.shell.openings.size(); ++i) {
      if (name_of(plan_.shell.openings[i].kind) != wish.subject) continue;
      add("/shell/openings/" + std::to_string(i), wish.span, said);
    }
  }

  void add_size(IntRange span, double confidence) {
    if (sources_.brief.size_mm) return;
    add("/shell/width_mm", span, confidence);
    add("/shell/depth_mm", span, confidence);
  }

  void add_wish(const plan::Requirement& wish) {
    switch (wish.kind) {
      case Kind::size:
        return add_size(wish.span, said);
      case Kind::area:
        if (wish.subject.empty()) return add_size(wish.span, implied);
        return for_zones(wish.subject, "area_m2/target", wish.span, said);
      case Kind::profile:
        return add("/profile", wish.span, said);
      case Kind::style:
        return add("/look", wish.span, said);
      case Kind::material:
        return add("/look/" + wish.subject, wish.span, said);
      case Kind::color:
        if (wish.subject == "accent") return add("/look/accent", wish.span, said);
        return for_zones("", "fixture/color", wish.span, said);
      case Kind::light:
        return add("/look/" + wish.subject, wish.span, said);
      case Kind::time:
        return add("/time", wish.span, said);
      case Kind::opening:
        return for_openings(wish);
      case Kind::relation:
        return add_relation(wish);
      default:
        return add_zone_wish(wish);
    }
  }

  void add_zone_wish(const plan::Requirement& wish) {
    switch (wish.kind) {
      case Kind::zone_present:
      case Kind::zone_count:
        return for_zones(wish.subject, "", wish.span, said);
      case Kind::product_present:
        return for_zones(wish.object, "", wish.span, implied);
      case Kind::product_absent:
        return for_zones("", "stock/exclude", wish.span, said);
      case Kind::fixture_count:
      case Kind::run_count:
        return add_fixtures(wish);
      case Kind::levels:
        if (wish.subject.empty()) return for_gondolas("levels", wish.span);
        return for_zones(wish.subject, "fixture/levels", wish.span, said);
      case Kind::height:
        if (wish.subject == "ceiling") return add("/shell/ceiling_mm", wish.span, said);
        return for_gondolas("height_mm", wish.span);
      case Kind::endcaps:
        return for_gondolas("endcaps", wish.span);
      case Kind::aisle_count:
        return add("/nodes", wish.span, said);
      case Kind::aisle_width:
        return for_gondolas("aisle_mm", wish.span);
      case Kind::stock:
        return for_zones("", stock_path(wish.subject), wish.span, said);
      default:
        return;  // what must not be there leaves no trace in a plan
    }
  }

  // The wish's kind is a zone's main one, or one of those beside it, or stands at a door.
  void add_fixtures(const plan::Requirement& wish) {
    for (std::size_t i = 0; plan_.equipment && i < plan_.equipment->size(); ++i) {
      if ((*plan_.equipment)[i].kind == wish.subject)
        return add("/equipment/" + std::to_string(i), wish.span, said);
    }
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      const plan::Zone& zone = plan_.zones[i];
      if (!wish.object.empty() && zone.type != wish.object) continue;
      std::string path = "/zones/" + std::to_string(i) + "/fixture";
      for (std::size_t k = 0; zone.also && k < zone.also->size(); ++k) {
        if ((*zone.also)[k].kind == wish.subject)
          path = "/zones/" + std::to_string(i) + "/also/" + std::to_string(k);
      }
      add(std::move(path), wish.span, said);
    }
  }

  void add_relation(const plan::Requirement& wish) {
    const auto same = [&](const plan::Relation& relation) {
      return relation.kind == wish.relation && relation.a == wish.subject &&
             relation.b == wish.object;
    };
    const auto found = std::ranges::find_if(plan_.relations, same);
    if (found == plan_.relations.end()) return;
    add("/relations/" + std::to_string(found - plan_.relations.begin()), wish.span, said);
  }

  const plan::Plan& plan_;
  const PlanSources& sources_;
  std::vector<plan::Provenance> entries_;
};

}  // namespace

std::vector<plan::Provenance> provenance_of(const plan::Plan& plan, const PlanSources& sources) {
  return ProvenanceWriter(plan, sources).run();
}

}  // namespace marketgen::intake
