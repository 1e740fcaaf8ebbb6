// Packs that show photographs: pictures of their sides (Product::faces) as a label sheet.
//
// A picture of a side shows the whole pack as it is seen from there, cropped to the pack. It is
// thrown onto the pack straight from that side: a point of the printed surface has the colour of
// the pixel that it lies behind, so that the pack, looked at from there, is the photograph. What is
// not print (lid, cap, neck, glass) stays as its shape has it. `wrap` is the label itself,
// unrolled.
//
//   SheetKind    pictures that are taken
//   band         front, back, left, right; or wrap
//   band_lid     the same, and top
//   carton       front, back, left, right, top, bottom
//   front_back   front, back
//   sleeve       front, top
//   skin         none: produce and unwrapped bakery goods have no print
//
// On a flat panel lies the picture of its side. On a band a point has the picture of the side that
// it faces most: of front and back, and of left and right where one of them is given. A side
// without a picture has the one of the opposite side; where that has none, either, the label's
// ground colour.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen::assets {

// A picture as far as it must fit; `where` is its place in errors.
struct SidePixels {
  PictureSize size;
  std::string where;
};
using PixelsBySide = std::map<std::string, SidePixels, std::less<>>;  // by names of face_slots

// Those of the kept pictures that the row names. Errors: input.not_found, image.*.
Result<PixelsBySide> kept_pixels(const catalog::Product& product);

// How a picture's shape agrees with the face of the pack that it shows.
struct FaceFit {
  std::string side;  // "front"
  SidePixels picture;
  double width_mm = 0, height_mm = 0;  // of the face
  double stretch = 1;                  // width of the picture for its height, over the face's
};

// Of each picture, in the order of catalog::face_slots. Errors: assets.bad_row for a shape that
// takes no pictures or not this side, and for wrap beside sides that it shows too;
// catalog.unknown_kind.
Result<std::vector<FaceFit>> face_fits(const catalog::Product& product,
                                       const PixelsBySide& pictures);

// Beyond this a picture is told of (face_notes), or refused (check_fits).
constexpr double told_stretch = 1.1, max_stretch = 2;

// A sentence for a person about each picture that is stretched by more than told_stretch.
std::vector<std::string> face_notes(const std::vector<FaceFit>& fits);
// Error: assets.bad_row, with the remedy, for a picture stretched by more than max_stretch.
Result<void> check_fits(const std::vector<FaceFit>& fits);

// All of it for the kept pictures of a row; nothing to do for a row without.
Result<void> check_faces(const catalog::Product& product);

// The label sheet (assets/print/label.h) of a row with pictures, by area filter. Deterministic.
// Errors: those of check_faces().
Result<Image> pictured_sheet(const catalog::Product& product, int width_px, int height_px);

}  // namespace marketgen::assets
