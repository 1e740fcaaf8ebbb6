// Where print lies on packs of film, paper and board that are neither round nor plain boxes: shared
// by the meshes that carry it and the sheet that is drawn for it.
#pragma once
#include "assets/shapes/archetypes/pack_builder.h"
#include "catalog/product.h"

namespace marketgen::assets {

struct FaceSize {
  float width_m = 0, height_m = 0;
};

// Film or paper around something long (flow_pack, chub, baguette_bag): a body along X, or along Z
// when it stands.
struct WrapForm {
  float length_m = 0;
  // Of the cross-section: along the printed face, and from face to face.
  float half_across_m = 0, half_thick_m = 0;
  float roundness = 1;
  float print_from_m = 0, print_to_m = 0;  // along the length; front and back half way around
  bool standing = false;
  PartFrame frame;  // the loft's: its Z along the length, its front where the reader is
};
WrapForm wrap_form_of(const catalog::Product& product);

// A flow_pack's fins are as wide as half its film, its body takes this share of them.
inline constexpr float flow_body_share = 0.90F;

// A flat pack (vacuum_pack, sachet) stands on its edge, or lies with its front upwards when that is
// its lesser size. `size` is its own: width, thickness, height as one reads it.
struct FlatForm {
  Vec3f size;
  PartFrame frame;
};
FlatForm flat_form_of(const catalog::Product& product);

// Film around upright pieces in rows, from the ground up to `high_m`: the pieces' tops stand out of
// it. Its corners are as round as a piece; `girth_share` is its girth over that of the footprint.
struct FilmForm {
  int across = 1, deep = 1, high = 1;  // pieces
  float piece_radius_m = 0, high_m = 0, girth_share = 1;
};
bool is_film_pack(const catalog::Product& product);  // can_six_pack, bottle_six_pack, roll_pack
FilmForm film_form_of(const catalog::Product& product);

// Of a front_back pack without a label zone.
FaceSize front_face_of(const catalog::Product& product);

// The block of a soft_pack inside its end seals and under its lid, and how round its edges are.
struct SoftForm {
  Vec3f size;
  float edge_m = 0;
  float fin_m = 0;  // length of each end seal
  float lid_m = 0;  // height of the flip lid; 0 for packs without one
};
SoftForm soft_form_of(const catalog::Product& product);

// Of the sleeve packs.
struct SleeveFaces {
  FaceSize top, front;
};
SleeveFaces sleeve_faces_of(const catalog::Product& product);

// The printed front of a blister card lies between the bubble and the hole it hangs by: shares of
// the height.
inline constexpr float blister_bubble_high = 0.47F, blister_print_high = 0.86F;

// A crate's walls lie between its corner posts, its foot and its rim.
inline constexpr float crate_post_share = 0.075F;  // of the width and depth
inline constexpr float crate_bar_share = 0.085F;   // of the height: foot and rim
inline constexpr float crate_wall_high = 0.90F;    // of the height: bottles stand over the rim
FaceSize crate_face_of(float width_m, float height_m);

// The header of a net bag takes the upper part of its height.
inline constexpr float net_header_low = 0.70F;

}  // namespace marketgen::assets
