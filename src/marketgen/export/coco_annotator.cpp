#include "export/coco_annotator.h"

#include <algorithm>
#include <cmath>

#include "assets/print/label.h"
#include "render/picture_objects.h"
#include "scene/placements.h"
#include "scene/price_tags.h"

namespace marketgen::exporters {
namespace {

double rounded(double value, double steps) {
  return std::round(value * steps) / steps;
}

// 1 - shown / alone, in ten-thousandths.
double occlusion_of(int shown, int alone) {
  return rounded(1 - static_cast<double>(shown) / alone, 1e4);
}

void show(CocoAnnotation& annotation, const std::array<int, 4>& box, int pixels, int alone) {
  annotation.bbox = {box[0], box[1], box[2] - box[0], box[3] - box[1]};
  annotation.area = pixels;
  annotation.occlusion = occlusion_of(pixels, alone);
}

}  // namespace

std::vector<CocoCategory> coco_categories(const scene::Scene& scene) {
  std::vector<CocoCategory> categories;
  const auto next = [&] { return static_cast<int>(categories.size()) + 1; };
  for (const catalog::Product& product : scene.catalog) {
    CocoCategory category{next(), product.sku, product.category, product.name, {}, {}};
    if (!product.variant.empty()) *category.product += " " + product.variant;
    if (!product.brand.empty()) category.brand = product.brand;
    if (!product.ean.empty()) category.gtin = product.ean;
    categories.push_back(std::move(category));
  }
  for (const std::string_view name : coco_shelf_categories)
    categories.push_back({next(), std::string(name), std::string(coco_shelf), {}, {}, {}});
  return categories;
}

CocoAnnotator::CocoAnnotator(const scene::Scene& scene)
    : scene_(scene),
      planogram_(scene::planogram_rows(scene)),
      gaps_(gap_panels(scene)),
      tags_(price_tag_panels(scene)),
      missing_tags_(missing_tag_panels(scene)) {}

std::vector<CocoAnnotation> CocoAnnotator::annotate(
    const render::Frame& frame,
    const render::Camera& camera,
    const VisibleParts& parts,
    const std::map<std::uint32_t, int>& silhouettes) const {
  std::vector<CocoAnnotation> annotations = items(frame, parts, silhouettes);
  const auto add = [&](CocoAnnotation annotation, const PanelView& view) {
    show(annotation, view.box, static_cast<int>(view.pixels.size()), view.alone);
    annotation.segmentation =
        render::mask_runs_of_pixels(view.pixels, frame.color.width, frame.color.height);
    annotations.push_back(std::move(annotation));
  };
  for (const ShelfPanel& panel : gaps_) {
    const PanelView view = view_of_gap(panel, camera, frame);
    if (!view.pixels.empty()) add(gap(panel), view);
  }
  const auto view_on_rail = [&](const ShelfPanel& panel) {
    const std::uint32_t fixture = scene_.shelves[scene_.facings[panel.facing].shelf].fixture;
    return view_of_tag(panel, render::first_fixture_object + fixture, camera, frame);
  };
  for (const ShelfPanel& panel : tags_) {
    const PanelView view = view_on_rail(panel);
    if (!view.pixels.empty()) add(price_tag(panel), view);
  }
  for (const ShelfPanel& panel : missing_tags_) {
    const PanelView view = view_on_rail(panel);
    if (!view.pixels.empty()) add(missing_tag(panel), view);
  }
  return annotations;
}

std::vector<CocoAnnotation> CocoAnnotator::items(
    const render::Frame& frame,
    const VisibleParts& parts,
    const std::map<std::uint32_t, int>& silhouettes) const {
  auto masks = render::mask_runs_of(frame.instance, frame.color.width, frame.color.height);
  std::vector<CocoAnnotation> annotations;
  for (const auto& [object, part] : parts) {
    if (render::kind_of(scene_, object) != render::ObjectKind::product) continue;
    CocoAnnotation annotation = item(object - render::first_product_object(scene_));
    show(annotation, part.box, part.pixels, silhouettes.at(object));
    annotation.segmentation = std::move(masks.at(object));
    annotation.depth_m = rounded(part.depth_sum_m / part.pixels, 1e4);
    annotations.push_back(std::move(annotation));
  }
  return annotations;
}

CocoAnnotation CocoAnnotator::item(std::uint32_t product) const {
  const scene::SceneProduct& row = scene_.products[product];
  CocoAnnotation annotation;
  annotation.category_id = static_cast<int>(row.sku) + 1;
  annotation.sku = scene_.catalog[row.sku].sku;
  annotation.instance = scene::product_id(scene_, product);
  annotation.misplaced = (row.flags & scene::product_misplaced) != 0;
  if (row.facing == scene::no_facing) return annotation;
  place(annotation, row.facing);
  if (*annotation.misplaced) annotation.planogram_sku = planogram_[row.facing].sku;
  return annotation;
}

void CocoAnnotator::place(CocoAnnotation& annotation, std::uint32_t facing) const {
  const scene::PlanogramRow& row = planogram_[facing];
  annotation.place = {row.fixture, coco_side(row.side), row.bay, row.level + 1, row.position + 1};
}

int CocoAnnotator::shelf_category(std::string_view name) const {
  const auto at = std::ranges::find(coco_shelf_categories, name) - coco_shelf_categories.begin();
  return static_cast<int>(scene_.catalog.size()) + static_cast<int>(at) + 1;
}

CocoAnnotation CocoAnnotator::gap(const ShelfPanel& panel) const {
  CocoAnnotation annotation;
  annotation.category_id = shelf_category(coco_gap);
  annotation.sku = planogram_[panel.facing].sku;
  place(annotation, panel.facing);
  if (panel.column) annotation.column = *panel.column + 1;
  return annotation;
}

CocoAnnotation CocoAnnotator::price_tag(const ShelfPanel& panel) const {
  const scene::PriceLabel& label = scene_.price_labels[panel.label];
  const catalog::Product product = scene::product_on_tag(scene_, label);
  CocoAnnotation annotation;
  annotation.category_id = shelf_category(coco_price_tag);
  annotation.sku = product.sku;
  place(annotation, panel.facing);
  annotation.text = assets::price_tag_text(product, label.promotion != 0);
  annotation.price = product.price;
  annotation.promotion = label.promotion != 0;
  const scene::TagFault fault = scene::fault_of(scene_, label);
  if (fault != scene::TagFault::none) annotation.fault = name_of(fault);
  if (fault == scene::TagFault::wrong_product)
    annotation.planogram_sku = planogram_[panel.facing].sku;
  return annotation;
}

CocoAnnotation CocoAnnotator::missing_tag(const ShelfPanel& panel) const {
  CocoAnnotation annotation;
  annotation.category_id = shelf_category(coco_missing_tag);
  annotation.sku = planogram_[panel.facing].sku;
  place(annotation, panel.facing);
  return annotation;
}

}  // namespace marketgen::exporters
