#include "grasping/grasp_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/hash.h"
#include "catalog/catalog.h"
#include "io/csv.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::grasping {
namespace {

constexpr std::size_t max_table_bytes = 16U << 20U;
constexpr std::array<std::string_view, 6> columns{
    "sku", "tool", "made_of", "excluded", "reason", "tries"};

constexpr double seen = 1e-9;  // of lengths, forces and masses: machines differ in the last bits

void add_numbers(Hasher& hasher, std::initializer_list<double> numbers) {
  for (const double number : numbers)
    hasher.add_rounded(number, seen);
}

void add_solids(Hasher& hasher, const std::vector<robots::ToolSolid>& solids) {
  hasher.add(static_cast<std::int64_t>(solids.size()));
  for (const robots::ToolSolid& solid : solids) {
    const auto& [at, turned] = solid.tool_from_solid;
    const Vec3& half = solid.half_size;
    add_numbers(hasher, {at.x, at.y, at.z, turned.w, turned.x, turned.y, turned.z});
    add_numbers(hasher, {half.x, half.y, half.z, solid.round ? 1.0 : 0.0});
  }
}

std::string made_of(const catalog::Product& product,
                    const robots::GraspTool& tool,
                    const std::vector<catalog::FrictionRow>& frictions) {
  Hasher hasher;
  hasher.add(catalog::line_without_contents(product));
  add_numbers(hasher, {rubber_friction(frictions, product)});
  hasher.add(tool.id).add(name_of(tool.kind));
  add_numbers(hasher, {tool.opening_m, tool.force_n, tool.payload_kg, tool.cup_radius_m});
  add_numbers(hasher, {tool.seal_depth_m, tool.mass_kg, tool.finger_kg, tool.finger_speed_m_s});
  add_numbers(hasher, {tool.pad_center.x, tool.pad_center.y, tool.pad_center.z});
  add_numbers(hasher, {tool.pad_x_m, tool.pad_z_m, tool.pad_thick_m});
  add_solids(hasher, tool.body);
  add_solids(hasher, tool.left);
  add_solids(hasher, tool.right);
  return hasher.hex().substr(0, 12);
}

std::string text_of(const GraspTry& t) {
  return fmt::format("{} {} {:.4g} {:.4g} {:.4g} {:.4g} {:.4g}",
                     name_of(t.strategy),
                     name_of(t.end),
                     t.width_mm,
                     t.force_n,
                     t.slip_mm,
                     t.turned_deg,
                     t.neighbour_n);
}

bool read_number(std::istream& words, double& number) {
  std::string word;
  if (!(words >> word)) return false;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
  return fault == std::errc() && end == word.data() + word.size();
}

Result<GraspTry> try_of(const std::string& text, const std::string& where) {
  std::istringstream words(text);
  std::string strategy, end;
  words >> strategy >> end;
  const auto how = value_named<motion::GraspStrategy>(strategy);
  const auto ended = value_named<GraspEnd>(end);
  GraspTry t;
  const bool numbers = read_number(words, t.width_mm) && read_number(words, t.force_n) &&
                       read_number(words, t.slip_mm) && read_number(words, t.turned_deg) &&
                       read_number(words, t.neighbour_n);
  if (!how || !ended || !numbers)
    return Error{"catalog.bad_row",
                 where + "/tries",
                 fmt::format("expected a strategy, an end and five numbers, not \"{}\"", text)};
  t.strategy = *how;
  t.end = *ended;
  return t;
}

Result<std::vector<GraspTry>> tries_of(const std::string& text, const std::string& where) {
  std::vector<GraspTry> tries;
  std::istringstream all(text);
  for (std::string one; std::getline(all, one, ';');) {
    MARKETGEN_TRY(GraspTry tried, try_of(one, where));
    tries.push_back(tried);
  }
  return tries;
}

Result<const catalog::Product*> product_of(const GraspRate& rate,
                                           const std::vector<const catalog::Product*>& products) {
  const auto found = std::ranges::find(products, rate.sku, &catalog::Product::sku);
  if (found == products.end())
    return Error{"catalog.unknown_sku", rate.sku, "is not among the products of the table"};
  return *found;
}

}  // namespace

Result<GraspTable> GraspTable::read(const std::filesystem::path& data) {
  const std::filesystem::path file = data / "grasps.csv";
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_table_bytes));
  MARKETGEN_TRY(const std::vector<io::CsvRow> rows, io::parse_csv(text, file.string()));
  if (rows.empty() || !std::ranges::equal(rows.front().fields, columns))
    return Error{"catalog.bad_row",
                 file.string() + ":1",
                 fmt::format("expected the columns {}", fmt::join(columns, ","))};
  GraspTable table;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& fields = rows[i].fields;
    const std::string where = fmt::format("{}:{}", file.string(), rows[i].line);
    GraspRate rate{fields[0], {}, fields[1], GraspSetting::stocked, {}, fields[4], {}};
    const auto excluded = value_named<GraspExclusion>(fields[3]);
    if (!excluded)
      return Error{"catalog.bad_row", where + "/excluded", "unknown: \"" + fields[3] + "\""};
    rate.excluded = *excluded;
    MARKETGEN_TRY(rate.tries, tries_of(fields[5], where));
    const std::pair key(rate.sku, rate.tool);
    table.rows_.insert_or_assign(key, Row{fields[2], std::move(rate)});
  }
  return table;
}

std::optional<GraspRate> GraspTable::find(
    const catalog::Product& product,
    const robots::GraspTool& tool,
    const std::vector<catalog::FrictionRow>& frictions) const {
  const auto row = rows_.find({product.sku, tool.id});
  if (row == rows_.end() || row->second.made_of != made_of(product, tool, frictions))
    return std::nullopt;
  GraspRate rate = row->second.rate;
  rate.archetype = product.archetype;
  return rate;
}

Result<std::string> grasp_table_text(const std::vector<GraspRate>& rates,
                                     const std::vector<const catalog::Product*>& products,
                                     const std::vector<robots::GraspTool>& tools,
                                     const std::vector<catalog::FrictionRow>& frictions) {
  std::map<std::pair<std::string, std::string>, std::string> lines;
  for (const GraspRate& rate : rates) {
    if (rate.setting != GraspSetting::stocked) continue;
    MARKETGEN_TRY(const catalog::Product* product, product_of(rate, products));
    const auto tool = std::ranges::find(tools, rate.tool, &robots::GraspTool::id);
    if (tool == tools.end())
      return Error{"catalog.unknown_sku", rate.tool, "is not among the tools of the table"};
    std::vector<std::string> tries;
    std::ranges::transform(rate.tries, std::back_inserter(tries), text_of);
    lines[{rate.sku, rate.tool}] = fmt::format("{},{},{},{},{},{}\n",
                                               rate.sku,
                                               rate.tool,
                                               made_of(*product, *tool, frictions),
                                               name_of(rate.excluded),
                                               io::csv_field(rate.reason),
                                               fmt::join(tries, ";"));
  }
  std::string text = fmt::format("{}\n", fmt::join(columns, ","));
  for (const auto& [key, line] : lines)
    text += line;
  return text;
}

}  // namespace marketgen::grasping
