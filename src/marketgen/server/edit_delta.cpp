#include "server/edit_delta.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/hash.h"
#include "io/json.h"
#include "server/goods_rows.h"
#include "server/view_mesh.h"

namespace marketgen::server {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

template <class Value>
void add_bits(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Where a product stands and what it is; `sku` is the page's number.
std::uint64_t hash_of(const scene::SceneProduct& item, std::uint32_t sku) {
  struct Bits {  // without gaps
    std::array<float, 3> position_m;
    std::array<float, 4> rotation_wxyz;
    std::uint32_t flags, sku;
  };
  static_assert(sizeof(Bits) == 9 * sizeof(std::uint32_t));
  const Bits bits{item.position_m, item.rotation_wxyz, item.flags, sku};
  return hash64({reinterpret_cast<const char*>(&bits), sizeof bits});
}

// How a fixture stands and what it is made of, without the numbers of rows.
std::string shape_of(const scene::Scene& scene, const scene::SceneFixture& fixture) {
  std::string bytes;
  add_bits(bytes, fixture.position_m);
  add_bits(bytes, fixture.quarter_turns);
  for (std::uint32_t i = 0; i < fixture.part_count; ++i) {
    scene::ScenePart part = scene.parts[fixture.first_part + i];
    if (part.material >= 0) bytes += scene.materials[static_cast<std::size_t>(part.material)].id;
    part.fixture = 0;
    part.material = -1;
    if (part.joint >= 0) part.joint -= static_cast<std::int32_t>(fixture.first_joint);
    add_bits(bytes, part);
  }
  return bytes;
}

template <class Number>
void add_column(PackedSections& sections, const char* name, const std::vector<Number>& values) {
  sections.add(name, 1, std::span<const Number>(values));
}

}  // namespace

// Which products of the base stay, in runs of rows, and those that do not come from it.
class DeltaBase::Goods {
 public:
  Goods(const DeltaBase& base, const scene::Scene& now, const std::vector<std::uint32_t>& skus)
      : base_(base),
        now_(now),
        skus_(skus),
        facings_(base.base_.facings.size()),
        shelves_(base.base_.shelves.size()) {
    for (std::uint32_t row = 0; row < now.products.size(); ++row)
      place(row);
  }

  void pack(PackedSections& sections) const {
    sections.add("runs", 2, std::span<const std::uint32_t>(runs_));
    add_column(sections, "facing_rows", facings_.rows());
    add_column(sections, "shelf_rows", shelves_.rows());
    changed_.pack(sections, "goods_");
  }

 private:
  // A map of rows that refuses a second answer.
  class RowMap {
   public:
    explicit RowMap(std::size_t rows) : to_(rows, none) {}
    bool admits(std::uint32_t from, std::uint32_t to) const {
      return to_[from] == none || to_[from] == to;
    }
    void set(std::uint32_t from, std::uint32_t to) { to_[from] = to; }
    const std::vector<std::uint32_t>& rows() const { return to_; }

   private:
    std::vector<std::uint32_t> to_;
  };

  void place(std::uint32_t row) {
    const std::uint32_t from = base_row(row);
    if (from == none) changed_.add(now_, row, skus_[now_.products[row].sku]);
    const bool goes_on =
        !runs_.empty() && (from == none ? runs_[runs_.size() - 2] == none
                                        : runs_[runs_.size() - 2] != none &&
                                              runs_[runs_.size() - 2] + runs_.back() == from);
    if (goes_on) {
      ++runs_.back();
      return;
    }
    runs_.push_back(from);
    runs_.push_back(1);
  }

  // The row of the base that is this product in its place; its block and shelf have one number now.
  std::uint32_t base_row(std::uint32_t row) {
    const scene::SceneProduct& item = now_.products[row];
    const auto found = base_.products_.find(hash_of(item, skus_[item.sku]));
    if (found == base_.products_.end()) return none;
    const scene::SceneProduct& old = base_.base_.products[found->second];
    const bool loose = item.facing >= now_.facings.size();
    if (loose != (old.facing >= base_.base_.facings.size())) return none;
    if (loose) return found->second;
    const std::uint32_t shelf = now_.facings[item.facing].shelf;
    const std::uint32_t old_shelf = base_.base_.facings[old.facing].shelf;
    if (!facings_.admits(old.facing, item.facing) || !shelves_.admits(old_shelf, shelf))
      return none;
    facings_.set(old.facing, item.facing);
    shelves_.set(old_shelf, shelf);
    return found->second;
  }

  const DeltaBase& base_;
  const scene::Scene& now_;
  const std::vector<std::uint32_t>& skus_;
  RowMap facings_, shelves_;
  std::vector<std::uint32_t> runs_;  // first row of the base or none, how many
  GoodsRows changed_;
};

std::vector<DeltaBase::FixtureLook> DeltaBase::looks_of(const scene::Scene& scene) {
  std::vector<std::uint64_t> printed;  // on a tag of the SKU
  for (const catalog::Product& product : scene.catalog)
    printed.push_back(hash64(io::write_json_line(product)));
  std::vector<std::string> tags(scene.fixtures.size());
  for (const scene::PriceLabel& label : scene.price_labels) {
    const scene::SceneShelf& shelf = scene.shelves[label.shelf];
    std::string& text = tags[shelf.fixture];
    add_bits(text, printed[label.sku]);
    add_bits(text, shelf.level);
    add_bits(text, shelf.side);
    add_bits(text, label.x_m);
    add_bits(text, label.promotion);
    add_bits(text, label.price_cents);
  }
  std::vector<FixtureLook> looks;
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i)
    looks.push_back({hash64(shape_of(scene, scene.fixtures[i])), hash64(tags[i])});
  return looks;
}

DeltaBase::DeltaBase(const scene::Scene& scene) : base_(scene), looks_(looks_of(scene)) {
  for (std::uint32_t i = 0; i < scene.catalog.size(); ++i)
    skus_[scene.catalog[i].sku] = i;
  for (std::uint32_t i = 0; i < scene.fixtures.size(); ++i)
    fixtures_[scene.layout.fixtures[i].id] = i;
  products_.reserve(scene.products.size());
  for (std::uint32_t i = 0; i < scene.products.size(); ++i)
    products_[hash_of(scene.products[i], scene.products[i].sku)] = i;
}

DeltaBase::SkuRows DeltaBase::sku_rows(const scene::Scene& now) const {
  SkuRows rows;
  for (std::uint32_t i = 0; i < now.catalog.size(); ++i) {
    const auto known = skus_.find(now.catalog[i].sku);
    if (known != skus_.end()) {
      rows.page.push_back(known->second);
      continue;
    }
    rows.page.push_back(static_cast<std::uint32_t>(skus_.size() + rows.fresh.size()));
    rows.fresh.push_back(i);
  }
  return rows;
}

// Which fixtures of the scene have no like in the base.
std::vector<bool> DeltaBase::describe_fixtures(const scene::Scene& now,
                                               PackedSections& sections) const {
  const std::vector<FixtureLook> looks = looks_of(now);
  std::vector<std::uint16_t> rows(base_.fixtures.size(), no_row);
  std::vector<std::uint8_t> tags(base_.fixtures.size(), 0);
  std::vector<std::uint32_t> joints(now.joints.size(), none);
  std::vector<bool> is_new(now.fixtures.size(), true);
  for (std::uint32_t i = 0; i < now.fixtures.size(); ++i) {
    const auto old = fixtures_.find(now.layout.fixtures[i].id);
    if (old == fixtures_.end() || looks_[old->second].shape != looks[i].shape) continue;
    is_new[i] = false;
    rows[old->second] = static_cast<std::uint16_t>(i);
    tags[old->second] = looks_[old->second].tags == looks[i].tags ? 1 : 0;
    for (std::uint32_t k = 0; k < now.fixtures[i].joint_count; ++k)
      joints[now.fixtures[i].first_joint + k] = base_.fixtures[old->second].first_joint + k;
  }
  add_column(sections, "fixture_rows", rows);
  add_column(sections, "fixture_tags", tags);
  add_column(sections, "joint_rows", joints);
  return is_new;
}

std::vector<std::uint32_t> DeltaBase::describe(const scene::Scene& now,
                                               PackedSections& sections) const {
  SkuRows skus = sku_rows(now);
  add_column(sections, "sku_rows", skus.page);
  Goods(*this, now, skus.page).pack(sections);
  const std::vector<bool> is_new = describe_fixtures(now, sections);
  std::vector<std::uint32_t> shapes;
  for (std::uint32_t i = 0; i < is_new.size(); ++i)
    if (is_new[i]) shapes.push_back(i);
  pack_fixture_shapes(now, shapes, sections);
  return std::move(skus.fresh);
}

}  // namespace marketgen::server
