// Printed faces of packs, drawn with Cairo and Pango from the product row.
//
// Sheets
// A sheet is the label picture of one product, divided into panels by assets/label_sheet.h:
// `panels_of(product)` gives each panel's rectangle in 0..1 sheet coordinates ((0, 0) top left, v
// downwards) and its true size. Both the meshes and the drawing use these numbers. The sheet has
// one scale: its pixels are square when the picture has the aspect of `sheet_size_of(product)`. By
// archetype:
//   band        can food_tin soda_bottle water_bottle wine_bottle beer_bottle sauce_bottle jar
//               The label unrolled, nothing else (lid, neck, ends are not on the sheet). u = 0..1
//               once around with the seam at the back (+Y); u = 0.25 is the left side (-X), u = 0.5
//               the middle of the front, u = 0.75 the right side. The shopper sees about u = 0.3 ..
//               0.7 upright; v = 0 the label's upper edge, v = 1 its lower edge.
//   band_lid    tub
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
//               it lies lengthwise.
//   front_back  flask tube pouch pillow_bag paper_bag
//               `front` left, `back` right. Flask and tube: the label zone of the body only, each
//               panel half way round, so its outer 12 % on the left and right turn away from the
//               shopper. Bags: the whole face, seals included (keep print out of the upper and
//               lower 8 % and the outer 6 %; of a paper_bag out of the upper 18 %, which is
//               folded).
//   sleeve      tray
//               `top` (the lid film and its sleeve as seen from above, read from the front) and
//               below it `front` (the tray's front wall, which the sleeve covers). The contents are
//               seen through the film, so draw them on `top` outside the printed band.
//   skin        round_produce elongated_produce leafy_produce
//               The skin, u once around (0 and 1 meet: tileable in u), v = 0 at the stem or top, v
//               = 1 at the other end. The rows near v = 0 and v = 1 shrink to points.
//               elongated_produce: u = 0.5 is up, the stem end lies left. leafy_produce: v = 0 is
//               the heart at the top, v = 1 the cut stalk on the ground.
#pragma once
#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen {

// The label sheet of a product: what its archetype's UVs wrap round the pack, see "Sheets".
// `size_px` (16 to 8192) is the height, the width follows from `sheet_size_of`; a sheet more than
// twice as wide as high gets the pixels of a 2:1 sheet and is lower. Brand mark, name, variant,
// motif, net quantity; nutrition table and EAN-13 on the back or side, at 2 px a module for 512.
// Deterministic: same row, same pixels. Thread-safe. Loose produce has a skin instead of print.
// Errors: assets.bad_row, catalog.unknown_kind.
Result<Image> draw_label(const Product& product, int size_px = 512);

// The price strip's tag for a product: price, name, unit price, bar code. `promotion` gives the
// yellow one.
Result<Image> draw_price_tag(const Product& product, bool promotion, int height_px = 96);

// A hanging sign or a wall band with a text.
Result<Image> draw_sign(std::string_view text,
                        std::string_view ground_color,
                        std::string_view text_color,
                        int width_px,
                        int height_px);

}  // namespace marketgen
