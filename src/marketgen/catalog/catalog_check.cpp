#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "catalog/catalog.h"
#include "catalog/gtin.h"
#include "catalog/product_check.h"

namespace marketgen::catalog {
namespace {

bool is_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return false;
  return text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

Error bad_row(std::string_view table, std::string_view row, std::string_view what) {
  return {"catalog.bad_row", fmt::format("{}/{}", table, row), std::string(what)};
}

template <class Row>
std::vector<std::string_view> names_in(const std::vector<Row>& rows, std::string Row::*key) {
  std::vector<std::string_view> names;
  for (const Row& row : rows)
    names.push_back(row.*key);
  return names;
}

bool has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Result<void> require_known(const std::vector<std::string_view>& known,
                           std::string where,
                           std::string_view what,
                           std::string_view name) {
  if (has(known, name)) return {};
  return unknown_name("catalog.bad_row", std::move(where), what, name, known);
}

template <class Row>
Result<void> require_unique(const std::vector<Row>& rows,
                            std::string Row::*key,
                            std::string_view table) {
  std::set<std::string_view> seen;
  for (const Row& row : rows) {
    if (!seen.insert(row.*key).second) {
      return Error{"catalog.duplicate_sku",
                   fmt::format("{}/{}", table, row.*key),
                   "this id stands in two rows"};
    }
  }
  return {};
}

// Mass over the volume of the bounding box, kg/m3. From expanded polystyrene-light crisps (about
// 35: 150 g in 5 l) to glass jars and detergents (1,400); paper rolls reach down to 45. Outside of
// this a row has a slipped digit.
constexpr double min_density = 20, max_density = 2200;

Result<void> check_density(const Product& p) {
  const double density = p.mass_kg / (p.width_m() * p.depth_m() * p.height_m());
  if (density >= min_density && density <= max_density) return {};
  return bad_row("products",
                 p.sku,
                 fmt::format("{:.3f} kg in {} x {} x {} mm is {:.0f} kg/m3; {} to {} is plausible: "
                             "check mass and size",
                             p.mass_kg,
                             p.size_mm[0],
                             p.size_mm[1],
                             p.size_mm[2],
                             density,
                             min_density,
                             max_density));
}

Result<void> check_codes(const Product& p) {
  if (p.ean.empty() == p.plu.empty())
    return bad_row("products", p.sku, "needs an EAN-13 if packed, or a PLU if loose, and not both");
  if (p.ean.empty()) return {};
  if (!is_ean13(p.ean))
    return bad_row(
        "products",
        p.sku,
        fmt::format("\"{}\" is not an EAN-13: 13 digits with a right check digit", p.ean));
  if (!is_restricted_circulation(p.ean)) {
    return bad_row(
        "products",
        p.sku,
        fmt::format("EAN {} may belong to somebody; use a prefix 020-029, 040-049 or 200-299",
                    p.ean));
  }
  return {};
}

Result<void> check_contents(const std::string& sku, const Contents& contents) {
  const bool pieces = contents.particle_mm > 0;
  for (const std::string* color : {&contents.color, &contents.particle_color}) {
    if (is_color(*color) || (color->empty() && !pieces && color != &contents.color)) continue;
    return bad_row(
        "products", sku, fmt::format("contents: \"{}\" is not a colour #rrggbb", *color));
  }
  if (pieces && contents.opacity == Opacity::clear)
    return bad_row("products", sku, "contents: pieces can be seen in opaque contents only");
  return {};
}

Result<void> check_row(const Product& p, const std::vector<std::string_view>& categories) {
  MARKETGEN_CHECK(
      require_known(categories, "products/" + p.sku + "/category", "category", p.category));
  MARKETGEN_CHECK(check_codes(p));
  MARKETGEN_CHECK(check_density(p));
  for (const std::string* color :
       {&p.label.primary, &p.label.secondary, &p.label.accent, &p.label.text}) {
    if (!is_color(*color))
      return bad_row("products", p.sku, fmt::format("\"{}\" is not a colour #rrggbb", *color));
  }
  if (p.contents) MARKETGEN_CHECK(check_contents(p.sku, *p.contents));
  return {};
}

Result<void> check_products(const Catalog& c) {
  MARKETGEN_CHECK(require_unique(c.products, &Product::sku, "products"));
  const auto categories = names_in(c.categories, &CategoryRow::id);
  std::map<std::string_view, std::string_view> sku_of_code;
  for (const Product& p : c.products) {
    MARKETGEN_CHECK(check_row(p, categories));
    const std::string_view code = p.ean.empty() ? p.plu : p.ean;
    const auto [entry, is_new] = sku_of_code.try_emplace(code, p.sku);
    if (!is_new)
      return Error{"catalog.duplicate_sku",
                   "products/" + p.sku,
                   fmt::format("code {} belongs to {} already", code, entry->second)};
  }
  return {};
}

Result<void> check_zone_types(const Catalog& c) {
  std::set<std::string_view> subcategories;
  for (const Product& p : c.products)
    subcategories.insert(p.subcategory);
  const std::vector<std::string_view> known_subcategories(subcategories.begin(),
                                                          subcategories.end());
  const auto categories = names_in(c.categories, &CategoryRow::id);
  const auto kinds = names_in(c.fixture_kinds, &FixtureKind::kind);
  for (const ZoneTypeRow& z : c.zone_types) {
    const std::string where = "zone_types/" + z.type;
    if (!z.fixture.empty())
      MARKETGEN_CHECK(require_known(kinds, where + "/fixture", "fixture kind", z.fixture));
    for (const std::string& category : z.categories)
      MARKETGEN_CHECK(require_known(categories, where + "/categories", "category", category));
    for (const std::string& s : z.subcategories)
      MARKETGEN_CHECK(
          require_known(known_subcategories, where + "/subcategories", "subcategory", s));
    if (!is_color(z.color))
      return bad_row("zone_types", z.type, fmt::format("\"{}\" is not a colour #rrggbb", z.color));
  }
  return {};
}

Result<void> check_looks(const Catalog& c) {
  const auto materials = names_in(c.materials, &MaterialRow::id);
  for (const StyleRow& s : c.styles) {
    for (const std::string* id : {&s.floor, &s.wall, &s.ceiling, &s.fixture}) {
      MARKETGEN_CHECK(require_known(materials, "styles/" + s.id, "material", *id));
    }
    if (!is_color(s.accent) || !is_color(s.fixture_color))
      return bad_row("styles", s.id, "accent and fixture_color must be #rrggbb");
  }
  for (const FixtureKind& k : c.fixture_kinds) {
    MARKETGEN_CHECK(
        require_known(materials, "fixtures/" + k.kind + "/material", "material", k.material));
    if (!is_color(k.color))
      return bad_row("fixtures", k.kind, fmt::format("\"{}\" is not a colour #rrggbb", k.color));
    if (!k.accent.empty() && !is_color(k.accent))
      return bad_row("fixtures", k.kind, "accent must be #rrggbb, or empty");
    if (k.module_widths_mm.empty())
      return bad_row("fixtures", k.kind, "needs at least one module width");
  }
  for (const MaterialRow& m : c.materials) {
    if (!is_color(m.color) || !is_color(m.second_color))
      return bad_row("materials", m.id, "colours must be #rrggbb");
    if (!m.third_color.empty() && !is_color(m.third_color))
      return bad_row("materials", m.id, "third_color must be #rrggbb, or empty");
  }
  return {};
}

// A number that a reader can look up, or an estimate with its range.
Result<void> check_friction(const FrictionRow& row, const std::vector<FrictionSource>& sources) {
  const std::string where = row.a + " on " + row.b;
  const auto source = std::find_if(
      sources.begin(), sources.end(), [&](const auto& known) { return known.key == row.source; });
  if (source == sources.end())
    return require_known(
        names_in(sources, &FrictionSource::key), "frictions/" + where, "source", row.source);
  const auto [least, most] = row.possible;
  if (source->is_estimate() && !(least < row.sliding && row.sliding < most))
    return bad_row("frictions", where, "an estimate needs a range that holds it");
  if (!source->is_estimate() && most != 0)
    return bad_row("frictions", where, "a range belongs to an estimate");
  return {};
}

}  // namespace

Result<void> check_product(const Product& product, const Catalog& catalog) {
  return check_row(product, names_in(catalog.categories, &CategoryRow::id));
}

Result<void> check_catalog(const Catalog& c) {
  MARKETGEN_CHECK(require_unique(c.fixture_kinds, &FixtureKind::kind, "fixtures"));
  MARKETGEN_CHECK(require_unique(c.categories, &CategoryRow::id, "categories"));
  MARKETGEN_CHECK(require_unique(c.zone_types, &ZoneTypeRow::type, "zone_types"));
  MARKETGEN_CHECK(require_unique(c.materials, &MaterialRow::id, "materials"));
  MARKETGEN_CHECK(require_unique(c.profiles, &ProfileRow::id, "profiles"));
  MARKETGEN_CHECK(require_unique(c.styles, &StyleRow::id, "styles"));
  MARKETGEN_CHECK(check_products(c));
  MARKETGEN_CHECK(check_zone_types(c));
  MARKETGEN_CHECK(check_looks(c));
  MARKETGEN_CHECK(require_unique(c.friction_sources, &FrictionSource::key, "friction_sources"));
  for (const FrictionRow& row : c.frictions)
    MARKETGEN_CHECK(check_friction(row, c.friction_sources));
  const auto types = names_in(c.zone_types, &ZoneTypeRow::type);
  for (const ProfileRow& p : c.profiles) {
    for (const std::string& zone : p.zones)
      MARKETGEN_CHECK(require_known(types, "profiles/" + p.id + "/zones", "zone type", zone));
  }
  return {};
}

}  // namespace marketgen::catalog
