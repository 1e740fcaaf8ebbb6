// Where the price tags and offer cards of shelf edges are stuck on, in pictures and exports.
#pragma once
#include <cstddef>

#include "assets/print/label.h"
#include "geometry/vector.h"
#include "scene/scene.h"

namespace marketgen::render {

// A tag's face before the face of its rail: label stock, metres.
constexpr float price_tag_lift_m = 8e-4F;

// Middle of the tag in the frame of its shelf, metres: before the price rail where the shelf has
// one. The tag is upright there, as wide and high as its label says, and faces -Y.
Vec3f price_tag_place(const scene::Scene& scene, const scene::PriceLabel& label);

constexpr auto promotion_card_width_m = static_cast<float>(assets::promotion_card_width_mm * 1e-3);
constexpr auto promotion_card_height_m =
    static_cast<float>(assets::promotion_card_height_mm * 1e-3);

// Middle of the card that hangs below an offer's tag, as above. Cards of neighbours may overlap and
// hang a little apart. `row`: of Scene::price_labels.
Vec3f promotion_card_place(const scene::Scene& scene, std::size_t row);

}  // namespace marketgen::render
