// A world under construction: materials and textures get their numbers first, then all pictures are
// drawn side by side, then geometry is added (its mip constants need the textures' sizes).
#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "assets/print/label.h"
#include "assets/product_model.h"
#include "base/progress.h"
#include "base/result.h"
#include "render/render.h"
#include "render/stage/world.h"
#include "scene/scene.h"

namespace marketgen::render::raytrace {

// How finely a world is drawn. What only light is baked in needs far less memory: rays of probes
// meet surfaces a hand wide (docs/figures.md, the server's first opening).
struct WorldDetail {
  PrintDetail print = PrintDetail::near;
  assets::Detail goods = assets::Detail::near;  // shapes of packs
  int coarser = 0;      // mip levels that tiled materials and labels of packs lack
  bool as_new = false;  // packs without the tint of a batch and without wear (item_look.h)
};

class Draft {
 public:
  Draft(const scene::Scene& scene, World& world, const WorldDetail& detail)
      : scene_(scene), world_(world), detail_(detail) {}

  const scene::Scene& scene() const { return scene_; }
  World& world() const { return world_; }
  PrintDetail print() const { return detail_.print; }
  const WorldDetail& detail() const { return detail_; }

  // The texture drawn by `draw` from `content` (which decides its pixels). Equal contents share one
  // texture.
  std::int32_t texture(const std::string& content, std::function<Result<Image>()> draw);
  // The same for a picture of seven channels: colour, then what ReliefTexture reads. Both textures
  // have this number in World.
  std::int32_t relief_texture(const std::string& content, std::function<Result<Image>()> draw);
  // The same for print: kept in blocks, its bars drawn at every look-up.
  std::int32_t print_texture(const std::string& content,
                             std::function<Result<assets::PrintedPicture>()> draw);
  // The same for the label of a pack, WorldDetail::coarser levels coarser.
  std::int32_t label_texture(const std::string& content,
                             std::function<Result<assets::PrintedPicture>()> draw);
  // Number of a material; equal ones share it, except glowing ones, whose light is measured later.
  std::uint16_t material(const Material& material);
  // A catalogue material tiled by UV in units of its own extent; plain white plaster in scenes
  // without materials, a bright checker and a warning when the scene lacks the row.
  std::uint16_t tiled_material(std::string_view id);
  // The same of a row that is no catalogue material.
  std::uint16_t tiled_material(const catalog::MaterialRow& row);
  // What one metre of UV must be divided by for `tiled_material(id)`.
  float extent_m(std::string_view id) const;
  const catalog::MaterialRow* row(std::string_view id) const;

  // Draws everything asked for so far into World::textures.
  Result<void> draw_textures(Progress& progress);

 private:
  const scene::Scene& scene_;
  World& world_;
  WorldDetail detail_;
  struct Order {
    std::string content;
    std::function<Result<Image>()> draw;
    bool relief = false;
    std::function<Result<assets::PrintedPicture>()> print;  // instead of `draw`
    int coarser = 0;
  };
  std::int32_t add_order(Order wanted);
  Result<void> carry_out(std::size_t order);  // into the textures of the same number
  void remember_whole_tiles(std::size_t from);
  std::uint16_t pane(const catalog::MaterialRow& row);
  std::uint16_t missing_material(std::string_view id);

  std::vector<Order> orders_;
  std::map<std::string, std::int32_t> texture_of_content_;
  std::set<std::string> missing_;  // materials that were asked for
  using MaterialLook = std::array<float, 15>;
  std::map<MaterialLook, std::uint16_t> material_of_look_;
};

}  // namespace marketgen::render::raytrace
