#include "plan/plan_edit.h"

#include <algorithm>
#include <utility>

namespace marketgen::plan {
namespace {

template <class Row>
std::optional<std::size_t> index_of_id(const std::vector<Row>& rows, std::string_view id) {
  const auto found = std::ranges::find(rows, id, &Row::id);
  if (found == rows.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rows.begin());
}

// Pointers into the list that come after the removed row are counted anew; those into the row go.
void renumber(std::vector<Provenance>& provenance, std::string_view list, std::size_t removed) {
  const std::string prefix = "/" + std::string(list) + "/";
  std::erase_if(provenance, [&](const Provenance& p) {
    const std::string row = prefix + std::to_string(removed);
    return p.path == row || p.path.starts_with(row + "/");
  });
  for (Provenance& p : provenance) {
    if (!p.path.starts_with(prefix)) continue;
    const std::size_t end = p.path.find('/', prefix.size());
    const std::string number =
        p.path.substr(prefix.size(), end == std::string::npos ? end : end - prefix.size());
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::size_t index = std::stoul(number);
    if (index <= removed) continue;
    p.path =
        prefix + std::to_string(index - 1) + (end == std::string::npos ? "" : p.path.substr(end));
  }
}

}  // namespace

std::optional<std::size_t> leaf_of(const Plan& plan, std::string_view zone) {
  const auto leaf = std::ranges::find_if(plan.nodes, [&](const Node& n) { return n.zone == zone; });
  if (leaf == plan.nodes.end()) return std::nullopt;
  return static_cast<std::size_t>(leaf - plan.nodes.begin());
}

std::optional<std::size_t> parent_of(const Plan& plan, std::size_t child) {
  const std::string& id = plan.nodes[child].id;
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    if (std::ranges::find(plan.nodes[i].children, id) != plan.nodes[i].children.end()) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> zone_index(const Plan& plan, std::string_view zone) {
  return index_of_id(plan.zones, zone);
}

std::optional<std::size_t> node_index(const Plan& plan, std::string_view node) {
  return index_of_id(plan.nodes, node);
}

std::string unused_id(const Plan& plan, const std::string& wanted) {
  const auto is_used = [&](const std::string& id) {
    return find_zone(plan, id) != nullptr || find_node(plan, id) != nullptr ||
           index_of_id(plan.shell.openings, id).has_value();
  };
  std::string id = wanted;
  for (int i = 2; is_used(id); ++i)
    id = wanted + "-" + std::to_string(i);
  return id;
}

Zone usual_zone(const catalog::ZoneTypeRow& type, const catalog::Catalog& catalog) {
  Zone zone;
  zone.type = type.type;
  zone.label = type.label;
  zone.anchor = type.anchor;
  zone.fixture.kind = type.fixture;
  const catalog::FixtureKind* kind = catalog.fixture_kind(type.fixture);
  zone.temperature = kind != nullptr ? kind->temperature : type.temperature;
  return zone;
}

Node take_out_leaf(Plan& plan, std::size_t leaf) {
  const std::size_t parent = *parent_of(plan, leaf);
  Node cut = plan.nodes[parent];
  const std::string sibling = cut.children[cut.children.front() == plan.nodes[leaf].id ? 1 : 0];
  for (Node& node : plan.nodes)
    std::ranges::replace(node.children, cut.id, sibling);
  const std::array<std::size_t, 2> gone{std::max(leaf, parent), std::min(leaf, parent)};
  for (const std::size_t node : gone) {
    plan.nodes.erase(plan.nodes.begin() + static_cast<std::ptrdiff_t>(node));
    renumber(plan.provenance, "nodes", node);
  }
  return cut;
}

void erase_zone(Plan& plan, std::size_t zone) {
  plan.zones.erase(plan.zones.begin() + static_cast<std::ptrdiff_t>(zone));
  renumber(plan.provenance, "zones", zone);
}

void put_beside(Plan& plan, std::size_t target, Node cut, Node leaf, Wall side) {
  const std::string id = plan.nodes[target].id;
  const bool first = side == Wall::west || side == Wall::south;
  for (Node& node : plan.nodes)
    std::ranges::replace(node.children, id, cut.id);
  cut.split = side == Wall::west || side == Wall::east ? Axis::x : Axis::y;
  cut.children = first ? std::vector{leaf.id, id} : std::vector{id, leaf.id};
  cut.zone.reset();
  plan.nodes.push_back(std::move(cut));
  plan.nodes.push_back(std::move(leaf));
}

void note_provenance(Plan& plan, const std::vector<std::string>& paths, Source by) {
  for (const std::string& path : paths) {
    std::erase_if(plan.provenance, [&](const Provenance& p) { return p.path == path; });
    plan.provenance.push_back({path, by, std::nullopt, 1});
  }
  constexpr std::size_t max_entries = 2000;  // limit of Plan::provenance: the oldest go
  if (plan.provenance.size() > max_entries)
    plan.provenance.erase(plan.provenance.begin(), plan.provenance.end() - max_entries);
}

}  // namespace marketgen::plan
