#include "scene/crop.h"

#include <algorithm>
#include <cmath>

#include "scene/placements.h"

namespace marketgen::scene {
namespace {

constexpr std::uint32_t gone = 0xFFFFFFFF;

class Cropper {
 public:
  Cropper(const Scene& whole, const std::vector<std::uint32_t>& fixtures)
      : whole_(whole), kept_(fixtures), new_fixture_(whole.fixtures.size(), gone) {
    for (std::uint32_t i = 0; i < kept_.size(); ++i)
      new_fixture_[kept_[i]] = i;
  }

  Scene made() {
    made_.schema = whole_.schema;
    made_.seed = whole_.seed;
    made_.layout = whole_.layout;
    made_.layout.violations.clear();
    made_.layout.fixtures.clear();
    made_.materials = whole_.materials;
    for (const std::uint32_t fixture : kept_)
      add_fixture(fixture);
    mark_goods();
    add_catalog();
    add_goods();
    return std::move(made_);
  }

 private:
  // Joints, parts and shelves lie together by fixture: one distance a table moves their rows.
  void add_fixture(std::uint32_t fixture) {
    made_.layout.fixtures.push_back(whole_.layout.fixtures[fixture]);
    const SceneFixture& from = whole_.fixtures[fixture];
    SceneFixture& to = made_.fixtures.emplace_back(from);
    to.first_part = static_cast<std::uint32_t>(made_.parts.size());
    to.first_shelf = static_cast<std::uint32_t>(made_.shelves.size());
    to.first_joint = static_cast<std::uint32_t>(made_.joints.size());
    const auto row = new_fixture_[fixture];
    const auto new_joint = [&](std::int32_t joint) {
      return joint < 0 ? joint
                       : static_cast<std::int32_t>(to.first_joint) + joint -
                             static_cast<std::int32_t>(from.first_joint);
    };
    for (std::uint32_t i = 0; i < from.joint_count; ++i) {
      SceneJoint& joint = made_.joints.emplace_back(whole_.joints[from.first_joint + i]);
      joint.fixture = row;
      joint.parent = new_joint(joint.parent);
    }
    for (std::uint32_t i = 0; i < from.part_count; ++i) {
      ScenePart& part = made_.parts.emplace_back(whole_.parts[from.first_part + i]);
      part.fixture = row;
      part.joint = new_joint(part.joint);
    }
    for (std::uint32_t i = 0; i < from.shelf_count; ++i)
      made_.shelves.emplace_back(whole_.shelves[from.first_shelf + i]).fixture = row;
  }

  bool stays(const Facing& facing) const {
    return new_fixture_[whole_.shelves[facing.shelf].fixture] != gone;
  }
  bool stays(const SceneProduct& product) const {
    if (product.facing != no_facing) return stays(whole_.facings[product.facing]);
    const PointMm at = floor_mm(Vec2{product.position_m[0], product.position_m[1]});
    return std::ranges::any_of(kept_, [&](std::uint32_t fixture) {
      return layout::footprint_of(whole_.layout.fixtures[fixture]).contains(at);
    });
  }
  std::uint32_t new_shelf(std::uint32_t shelf) const {
    const std::uint32_t fixture = whole_.shelves[shelf].fixture;
    return made_.fixtures[new_fixture_[fixture]].first_shelf + shelf -
           whole_.fixtures[fixture].first_shelf;
  }

  // Numbers what stays of facings and products anew, and marks their SKUs.
  void mark_goods() {
    new_sku_.assign(whole_.catalog.size(), gone);
    new_facing_.assign(whole_.facings.size(), gone);
    new_product_.assign(whole_.products.size() + 1, 0);
    std::uint32_t facings = 0, products = 0;
    for (std::size_t i = 0; i < whole_.facings.size(); ++i) {
      if (!stays(whole_.facings[i])) continue;
      new_facing_[i] = facings++;
      new_sku_[whole_.facings[i].sku] = 0;
    }
    for (std::size_t i = 0; i < whole_.products.size(); ++i) {
      new_product_[i] = products;
      if (!stays(whole_.products[i])) continue;
      ++products;
      new_sku_[whole_.products[i].sku] = 0;
    }
    new_product_.back() = products;
    for (const PriceLabel& label : whole_.price_labels)
      if (new_facing_[label.facing] != gone) new_sku_[label.sku] = 0;
  }

  void add_catalog() {
    for (std::size_t sku = 0; sku < new_sku_.size(); ++sku) {
      if (new_sku_[sku] == gone) continue;
      new_sku_[sku] = static_cast<std::uint32_t>(made_.catalog.size());
      made_.catalog.push_back(whole_.catalog[sku]);
    }
  }

  void add_goods() {
    for (std::size_t i = 0; i < whole_.facings.size(); ++i) {
      if (new_facing_[i] == gone) continue;
      Facing& facing = made_.facings.emplace_back(whole_.facings[i]);
      facing.shelf = new_shelf(facing.shelf);
      facing.sku = new_sku_[facing.sku];
      facing.first_product = new_product_[facing.first_product];
    }
    for (std::size_t i = 0; i < whole_.products.size(); ++i) {
      if (new_product_[i] == new_product_[i + 1]) continue;
      SceneProduct& product = made_.products.emplace_back(whole_.products[i]);
      product.sku = new_sku_[product.sku];
      if (product.facing != no_facing) product.facing = new_facing_[product.facing];
    }
    for (const PriceLabel& label : whole_.price_labels) {
      if (new_facing_[label.facing] == gone) continue;
      made_.price_labels.push_back(label);
      PriceLabel& added = made_.price_labels.back();
      added.shelf = new_shelf(label.shelf);
      added.sku = new_sku_[label.sku];
      added.facing = new_facing_[label.facing];
    }
  }

  const Scene& whole_;
  const std::vector<std::uint32_t>& kept_;
  // By row of the whole scene: the row in the part, or `gone`. Of a product that goes, the next
  // one's that stays.
  std::vector<std::uint32_t> new_fixture_, new_sku_, new_facing_, new_product_;
  Scene made_;
};

}  // namespace

Scene cropped(const Scene& scene, const std::vector<std::uint32_t>& fixtures) {
  return Cropper(scene, fixtures).made();
}

}  // namespace marketgen::scene
