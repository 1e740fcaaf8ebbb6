// What one picture of shelves shows, as COCO annotations.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "export/coco_document.h"
#include "export/coco_panels.h"
#include "render/render.h"
#include "render/visible_parts.h"
#include "scene/planogram_rows.h"
#include "scene/scene.h"

namespace marketgen::exporters {

using VisibleParts = std::map<std::uint32_t, render::VisiblePart>;

// One a SKU of the store, in the order of its catalogue, then gaps, price tags and
// missing tags; numbers from 1.
std::vector<CocoCategory> coco_categories(const scene::Scene& scene);

// Holds what all pictures of a store share. annotate() may be called from many threads at a time.
class CocoAnnotator {
 public:
  explicit CocoAnnotator(const scene::Scene& scene);  // which must outlive it

  // Items, gaps, price tags, missing tags; those that show at least one pixel. `parts` are those of
  // the frame, `silhouettes` what each of its items would cover alone, by object number. Ids of
  // annotations and of the picture are left 0.
  std::vector<CocoAnnotation> annotate(const render::Frame& frame,
                                       const render::Camera& camera,
                                       const VisibleParts& parts,
                                       const std::map<std::uint32_t, int>& silhouettes) const;

 private:
  std::vector<CocoAnnotation> items(const render::Frame& frame,
                                    const VisibleParts& parts,
                                    const std::map<std::uint32_t, int>& silhouettes) const;
  CocoAnnotation item(std::uint32_t product) const;
  void place(CocoAnnotation& annotation, std::uint32_t facing) const;
  int shelf_category(std::string_view name) const;  // of coco_shelf_categories
  CocoAnnotation gap(const ShelfPanel& panel) const;
  CocoAnnotation price_tag(const ShelfPanel& panel) const;
  CocoAnnotation missing_tag(const ShelfPanel& panel) const;

  const scene::Scene& scene_;
  std::vector<scene::PlanogramRow> planogram_;  // by facing
  std::vector<ShelfPanel> gaps_, tags_, missing_tags_;
};

}  // namespace marketgen::exporters
