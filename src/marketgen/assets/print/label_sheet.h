// The label sheet: which rectangle of a product's label picture lies on which face of the pack.
//
// One description for both sides: the meshes take their UVs from it and draw_label paints into it.
// See the heading "Sheets" in assets/print/label.h for what each kind looks like.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/product.h"

namespace marketgen::assets {

// How the sheet of an archetype is divided.
enum class SheetKind {
  band,      // one panel `band`: the developed label of a round pack
  band_lid,  // `band` below, `top` (the lid, a disc or rounded rectangle inscribed in it) above its
             // middle
  carton,    // the net of a box: front, right, back, left side by side, `top` above front, `bottom`
             // above back
  front_back,  // `front` on the left, `back` on the right
  sleeve,      // `top` above, `front` below it
  skin         // one panel `skin`
};
constexpr std::array<std::string_view, 6> names_of(SheetKind) {
  return {"band", "band_lid", "carton", "front_back", "sleeve", "skin"};
}

enum class PanelKind { band, front, right, back, left, top, bottom, skin };
constexpr std::array<std::string_view, 8> names_of(PanelKind) {
  return {"band", "front", "right", "back", "left", "top", "bottom", "skin"};
}

// A face of the pack on the sheet. (u0, v0) is its upper left corner as a person sees it when it is
// turned upright before them: `right` is the side at the shopper's right hand (+X). `top` is read
// from the front: its lower edge joins the front. `bottom` joins the front by its upper edge.
struct Panel {
  PanelKind kind = PanelKind::front;
  float u0 = 0, v0 = 0, u1 = 1, v1 = 1;
  float width_m = 0, height_m = 0;  // true size on the pack, so that print is not squeezed
};

struct SheetSize {
  float width_m = 0, height_m = 0;  // of the whole sheet on the pack: one scale for all its panels
};

// Errors: catalog.unknown_kind for an archetype that archetypes.inc does not list.
Result<SheetKind> sheet_kind_of(std::string_view archetype);
// In the order of SheetKind's comment. Panels of one sheet do not overlap. Errors:
// catalog.unknown_kind, assets.bad_row.
Result<std::vector<Panel>> panels_of(const catalog::Product& product);
Result<SheetSize> sheet_size_of(const catalog::Product& product);

}  // namespace marketgen::assets
