// Printed faces of packs, drawn with Cairo and Pango from the product row.
//
// Sheets
// A sheet is the label picture of one product, divided into panels by assets/print/label_sheet.h:
// `panels_of(product)` gives each panel's rectangle in 0..1 sheet coordinates ((0, 0) top left, v
// downwards) and its true size. Both the meshes and the drawing use these numbers. The sheet has
// one scale: its pixels are square when the picture has the aspect of `sheet_size_of(product)`. By
// archetype:
//   band        can food_tin soda_bottle water_bottle wine_bottle beer_bottle sauce_bottle jar
//               The label unrolled, nothing else (lid, neck, ends are not on the sheet). u = 0..1
//               once around with the seam at the back (+Y); u = 0.25 is the left side (-X), u = 0.5
//               the middle of the front, u = 0.75 the right side. The shopper sees about u = 0.3 ..
//               0.7 upright; v = 0 the label's upper edge, v = 1 its lower edge.
//               Also slim_can canister spirit_bottle oil_bottle aerosol.
//   band_lid    tub flat_tin round_tin cream_jar yogurt_cup
//               `band` as above (u of the panel from u0 to u1); above it `top`, the lid: the disc
//               (rounded rectangle for a long tub) inscribed in the panel is seen, so fill the
//               panel and keep print away from its corners.
//   carton      box gable_carton brick_carton bundle loaf
//               The net of a carton: bottom row front | right | back | left, all of the body's
//               height; above the front lies `top`, above the back `bottom`. Neighbours join
//               without a gap, so a ground colour may run across. The rest of the upper row is not
//               seen. For gable_carton `top` is the roof: its lower 45 % slopes to the front, its
//               upper 45 % to the back, the strip between is the fin; the cap sits in the middle of
//               the lower part. A brick_carton from 150 mm up has its cap at (0.5, 0.7) of `top`. A
//               loaf is gathered at the left end of `front` (20 %), or at the far end of `top` when
//               it lies lengthwise. Also foil_brick, soft_pack (a flip lid hides the middle of
//               `top` on wipes); can_six_pack bottle_six_pack roll_pack: the film around the
//               pieces, its ends bare; crate: the long walls between frame and rim, `front` and
//               `back` alone.
//   front_back  flask tube pouch pillow_bag paper_bag
//               `front` left, `back` right. Flask and tube: the label zone of the body only, each
//               panel half way round, so its outer 12 % on the left and right turn away from the
//               shopper. Bags: the whole face, seals included (keep print out of the upper and
//               lower 8 % and the outer 6 %; of a paper_bag out of the upper 18 %, which is
//               folded). squeeze_bottle milk_jug jerrycan detergent_bottle spray_bottle pump_bottle
//               stick: a label with edges on the flat of the front, another on the back. flow_pack
//               chub baguette_bag: each half way round the pack. vacuum_pack sachet: the whole
//               face. blister: the card between hood and hole. net_bag: the header.
//   sleeve      tray meat_tray
//               `top` (the lid film and its sleeve as seen from above, read from the front) and
//               below it `front` (the tray's front wall, which the sleeve covers). The contents are
//               seen through the film, so draw them on `top` outside the printed band.
//               sardine_tin: the lid and the front wall. egg_box cheese_wedge: two paper labels.
//   skin        fruit, vegetables, unwrapped bakery goods
//               The skin, u once around (0 and 1 meet: tileable in u), v = 0 at the stem, the
//               leaves or the top, v = 1 at the other end. The rows near v = 0 and v = 1 shrink to
//               points. What lies along X has u = 0.5 up and its stem end left; what stands has
//               u = 0.5 in front. Leaves have their midribs at u = 0 and 0.5. The pieces of a bunch
//               share the sheet. Loose fruit with a PLU carries its sticker near u = 0.5.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen::assets {

// The label sheet of a product: what its archetype's UVs wrap round the pack, see "Sheets".
// `size_px` (16 to 8192) is the height, the width follows from `sheet_size_of`; a sheet more than
// twice as wide as high gets the pixels of a 2:1 sheet and is lower. Brand mark, name, variant,
// motif, net quantity; nutrition table and EAN-13 on the back or side, at 2 px a module for 512.
// A product with a mesh of its own gives that mesh's picture, one with pictures of its sides a
// sheet of these (assets/print/pack_pictures.h). Deterministic: same row, same pixels. Thread-safe.
// Loose produce has a skin instead of print. Errors: assets.bad_row, catalog.unknown_kind.
Result<Image> draw_label(const catalog::Product& product, int size_px = 512);

// The bars of a code, for a renderer that draws them as fine as the eye comes near.
struct LabelBars {
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;  // all modules on the picture, guard bars at full length
  float foot = 0;       // share of that length which only the guard bars reach into
  bool ladder = false;  // modules follow one another along v, feet towards u0; else along u and v1
  std::string modules;  // 95 times '0' or '1'
};

struct PrintedPicture {
  Image picture;  // even grey where the bars belong
  std::optional<LabelBars> bars;
};

// The label sheet as it is printed: `px_per_mm` (0.1 to 20) pixels a millimetre of the pack, the
// EAN true to size (X = 0.33 mm where there is room). Errors: as draw_label.
Result<PrintedPicture> print_label(const catalog::Product& product, double px_per_mm);

// The price strip's tag for a product: price, name, unit price, bar code. `promotion` gives the
// yellow one.
Result<Image> draw_price_tag(const catalog::Product& product, bool promotion, int height_px = 96);
// The same with the bars left out.
Result<PrintedPicture> print_price_tag(const catalog::Product& product,
                                       bool promotion,
                                       int height_px = 96);

// What stands on a tag in letters, from the top: the offer's word, brand and name, variant and net
// quantity, price, price a unit, the code's figures; what the product does not have is left out.
std::vector<std::string> price_tag_text(const catalog::Product& product, bool promotion);

// The card that hangs under the tag of an offer, 105 x 74 mm: picture, price, former price, saving.
constexpr double promotion_card_width_mm = 105, promotion_card_height_mm = 74;
Result<Image> draw_promotion_card(const catalog::Product& product, int height_px = 222);

// A hanging sign or a wall band with a text.
Result<Image> draw_sign(std::string_view text,
                        std::string_view ground_color,
                        std::string_view text_color,
                        int width_px,
                        int height_px);

}  // namespace marketgen::assets
