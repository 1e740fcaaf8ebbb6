// Pictures of a pack's sides: a user's PNG or JPEG files beside his catalogue.
//
// A row names files in its own folder (Product::faces). When it is loaded each is made ready:
// turned as the camera was held, cut to what is not see-through, at most max_face_px a side,
// without what else its file says (place, date). So it is kept by its content
// (catalog/kept_file.h), and the row has that name from then on. What a pack shows of its pictures:
// assets/print/pack_pictures.h.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/kept_file.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen::catalog {

// A longer side is made so long: 6 pixels a millimetre of a pack of 25 cm, more than any label has.
constexpr int max_face_px = 1600;
constexpr int min_face_px = 16;
constexpr std::uint64_t max_face_bytes = 64U << 20;

struct FaceSlot {
  std::string_view name;
  std::string PackFaces::*file;
};
constexpr std::array<FaceSlot, 7> face_slots{{{"front", &PackFaces::front},
                                              {"back", &PackFaces::back},
                                              {"left", &PackFaces::left},
                                              {"right", &PackFaces::right},
                                              {"top", &PackFaces::top},
                                              {"bottom", &PackFaces::bottom},
                                              {"wrap", &PackFaces::wrap}}};

// A picture made ready, as a file.
struct ReadyFace {
  Image picture;      // three channels
  std::string bytes;  // JPEG of a JPEG, otherwise PNG
  std::string_view ending;
};
// `where` names the bytes in errors: image.bad_file (also one that is wholly see-through),
// image.too_small, input.too_large.
Result<ReadyFace> ready_face(std::string_view bytes, const std::string& where);

// Keeps the pictures that the row names in `folder`; from then on it names kept ones. Its label's
// ground colour, unless the row has one of its own, is that of the border of the first picture of
// front, back and so on. `where`: the row's place. Errors: those of ready_face(), with the file as
// place; catalog.bad_row when the row's faces name none; input.*, io.*.
Result<void> keep_faces(Product& product,
                        const std::filesystem::path& folder,
                        const std::string& where);

// The pictures that a row names, in the order of face_slots.
std::vector<KeptName> face_names(const Product& product);
// The one of a side that has one; errors of either: those of kept_bytes(), image.*.
KeptName face_name(const Product& product, const FaceSlot& slot);
Result<Image> kept_face(const KeptName& name);
Result<PictureSize> kept_face_size(const KeptName& name);

// "#rrggbb": the median of the picture's outermost hundredth, channel by channel.
std::string border_color(const Image& picture);

}  // namespace marketgen::catalog
