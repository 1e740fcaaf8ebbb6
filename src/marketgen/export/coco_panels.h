// Upright rectangles of shelves that pictures show but have no number for: price tags, where tags
// are missing, and the fronts of facings where nothing stands.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/pose.h"
#include "render/cameras/camera.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// A rectangle round the origin of its frame: X to the right for who looks at it, Z up, facing -Y.
struct ShelfPanel {
  Pose world_from_panel;
  double width_m = 0, height_m = 0;
  std::uint32_t facing = 0;        // row of scene.facings
  std::uint32_t label = 0;         // price tags: row of scene.price_labels
  std::optional<int> column = {};  // gaps: of the block, from 0 at the left; nothing: all of it
};

// The tags of all shelf edges, by row.
std::vector<ShelfPanel> price_tag_panels(const scene::Scene& scene);

// Where tags are missing: on the faces of price rails before blocks that have none.
std::vector<ShelfPanel> missing_tag_panels(const scene::Scene& scene);

// Facings of the planogram that are empty from front to back: a column of a block, or a whole block
// of loose goods. As high as the packs would stand there, in the plane of the goods' fronts.
std::vector<ShelfPanel> gap_panels(const scene::Scene& scene);

// What a picture shows of a panel.
struct PanelView {
  std::vector<std::uint32_t> pixels;  // that show it: x * height + y, ascending
  int alone = 0;                      // pixels of the picture that it covers
  std::array<int, 4> box{};           // x0, y0, x1, y1 around `pixels`; past the last
};

// A tag, and the rail where one is missing, shows where the picture's depth is its own and its
// number the fixture's; a gap where nothing is nearer than its plane. Nothing is shown of panels
// that turn their backs. Precondition: the camera has no distortion.
PanelView view_of_tag(const ShelfPanel& tag,
                      std::uint32_t fixture_object,
                      const render::Camera& camera,
                      const render::Frame& frame);
PanelView view_of_gap(const ShelfPanel& gap,
                      const render::Camera& camera,
                      const render::Frame& frame);

}  // namespace marketgen::exporters
