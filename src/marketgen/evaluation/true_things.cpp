#include "evaluation/true_things.h"

#include <variant>

#include "episodes/aisle/aisle_world.h"
#include "episodes/checkout/checkout_world.h"

namespace marketgen::evaluation {
namespace {

Vec3 middle_of(const catalog::Product& product, const Pose& pose) {
  return pose * Vec3{0, 0, product.height_m() / 2};
}

// Looks at one true thing after the other.
class Nearest {
 public:
  Nearest(const std::string& sku, Vec3 middle) : sku_(sku), middle_(middle) {}

  void see(const catalog::Product& product, const Pose& pose) {
    const double off = length(middle_of(product, pose) - middle_);
    if (product.sku == sku_ && (!there_.own_m || off < *there_.own_m)) there_.own_m = off;
    if (off > near_truth_m || (!there_.sku.empty() && off >= there_.off_m)) return;
    there_.sku = product.sku;
    there_.off_m = off;
  }
  TruthThere there() const { return there_; }

 private:
  const std::string& sku_;
  Vec3 middle_;
  TruthThere there_;
};

void see_all(const episodes::CheckoutWorld& world, Nearest& nearest) {
  for (std::size_t item = 0; item < world.item_count(); ++item)
    nearest.see(world.goods(item).product, world.item_pose(item));
}

void see_all(const episodes::AisleWorld& world, Nearest& nearest) {
  const scene::Scene& scene = world.store().scene;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row)
    nearest.see(scene.catalog[scene.products[row].sku], world.world().product_pose(row));
}

}  // namespace

TruthThere truth_at(const episodes::TrackWorld& world, const std::string& sku, Vec3 middle) {
  Nearest nearest(sku, middle);
  std::visit([&](const auto* of_track) { see_all(*of_track, nearest); }, world.any());
  return nearest.there();
}

std::string held_sku(const episodes::TrackWorld& world) {
  for (const auto& [product, item] : world.watch().items())
    if (item.held_by >= 0) return world.thing_of(product).sku;
  return {};
}

}  // namespace marketgen::evaluation
