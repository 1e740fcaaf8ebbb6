#include "assets/print/pack_pictures.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assets/own_pack.h"
#include "assets/print/label_sheet.h"
#include "assets/product_model.h"
#include "catalog/own_faces.h"

namespace marketgen::assets {
namespace {

constexpr std::string_view band_sides[] = {"front", "back", "left", "right", "wrap"};
constexpr std::string_view band_lid_sides[] = {"front", "back", "left", "right", "wrap", "top"};
constexpr std::string_view carton_sides[] = {"front", "back", "left", "right", "top", "bottom"};
constexpr std::string_view front_back_sides[] = {"front", "back"};
constexpr std::string_view sleeve_sides[] = {"front", "top"};

std::span<const std::string_view> sides_of(SheetKind kind) {
  switch (kind) {
    case SheetKind::band:
      return band_sides;
    case SheetKind::band_lid:
      return band_lid_sides;
    case SheetKind::carton:
      return carton_sides;
    case SheetKind::front_back:
      return front_back_sides;
    case SheetKind::sleeve:
      return sleeve_sides;
    case SheetKind::skin:
      return {};
  }
  return {};
}

std::vector<std::string_view> shapes_with_print() {
  std::vector<std::string_view> names;
  for (const ArchetypeInfo& shape : archetypes()) {
    const Result<SheetKind> kind = sheet_kind_of(shape.name);
    if (kind.ok() && !sides_of(*kind).empty()) names.push_back(shape.name);
  }
  return names;
}

Error no_print(const catalog::Product& product) {
  return {"assets.bad_row",
          product.sku + "/faces",
          fmt::format("{} shows no pictures of sides; shapes that do: {}",
                      has_own_mesh(product) ? "a mesh has pictures of its own and"
                                            : "a pack of archetype \"" + product.archetype + "\"",
                      fmt::join(shapes_with_print(), ", "))};
}

// Whether the shape takes every one of the pictures.
Result<void> check_sides(const catalog::Product& product, const PixelsBySide& pictures) {
  if (has_own_mesh(product)) return no_print(product);
  MARKETGEN_TRY(const SheetKind kind, sheet_kind_of(product.archetype));
  const std::span<const std::string_view> sides = sides_of(kind);
  if (sides.empty()) return no_print(product);
  for (const auto& [side, picture] : pictures) {
    if (std::ranges::find(sides, side) == sides.end())
      return Error{
          "assets.bad_row",
          picture.where,
          fmt::format("there is no print on the {} of a pack of archetype \"{}\"; it takes {}",
                      side,
                      product.archetype,
                      fmt::join(sides, ", "))};
  }
  const auto wrap = pictures.find("wrap");
  const bool round =
      std::ranges::any_of(std::span(band_sides).first(4),
                          [&](std::string_view side) { return pictures.contains(side); });
  if (wrap == pictures.end() || !round) return {};
  return Error{"assets.bad_row",
               wrap->second.where,
               "is the whole label, and sides of it are given too; give the one or the others"};
}

// Width and height in millimetres of what a picture of that side shows.
Result<std::array<double, 2>> face_size_mm(const catalog::Product& product, std::string_view side) {
  const auto& [w, d, h] = product.size_mm;
  if (side == "front" || side == "back") return std::array<double, 2>{double(w), double(h)};
  if (side == "left" || side == "right") return std::array<double, 2>{double(d), double(h)};
  if (side == "top" || side == "bottom") return std::array<double, 2>{double(w), double(d)};
  MARKETGEN_TRY(const std::vector<Panel> panels, panels_of(product));  // wrap: the band
  return std::array<double, 2>{1e3 * static_cast<double>(panels[0].width_m),
                               1e3 * static_cast<double>(panels[0].height_m)};
}

// What it is a picture of.
std::string shown_by(const FaceFit& fit) {
  return fit.side == "wrap" ? "unrolled label" : fit.side;
}

// "1.3 times as wide for its height as the front of 66 x 115 mm".
std::string stretched(const FaceFit& fit) {
  const bool wide = fit.stretch > 1;
  return fmt::format("{:.2g} times as {} as the {} of {:.0f} x {:.0f} mm",
                     wide ? fit.stretch : 1 / fit.stretch,
                     wide ? "wide for its height" : "high for its width",
                     shown_by(fit),
                     fit.width_mm,
                     fit.height_mm);
}

bool is_stretched(const FaceFit& fit, double by) {
  return std::max(fit.stretch, 1 / fit.stretch) > by;
}

}  // namespace

Result<PixelsBySide> kept_pixels(const catalog::Product& product) {
  PixelsBySide pictures;
  for (const catalog::FaceSlot& slot : catalog::face_slots) {
    const catalog::KeptName name = catalog::face_name(product, slot);
    if (name.name.empty()) continue;
    MARKETGEN_TRY(const PictureSize size, catalog::kept_face_size(name));
    pictures[std::string(slot.name)] = {size, name.where};
  }
  return pictures;
}

Result<std::vector<FaceFit>> face_fits(const catalog::Product& product,
                                       const PixelsBySide& pictures) {
  MARKETGEN_CHECK(check_sides(product, pictures));
  std::vector<FaceFit> fits;
  for (const catalog::FaceSlot& slot : catalog::face_slots) {
    const auto found = pictures.find(slot.name);
    if (found == pictures.end()) continue;
    MARKETGEN_TRY(const auto mm, face_size_mm(product, slot.name));
    const PictureSize px = found->second.size;
    fits.push_back(
        {found->first, found->second, mm[0], mm[1], px.width * mm[1] / (px.height * mm[0])});
  }
  return fits;
}

std::vector<std::string> face_notes(const std::vector<FaceFit>& fits) {
  std::vector<std::string> notes;
  for (const FaceFit& fit : fits) {
    if (is_stretched(fit, told_stretch))
      notes.push_back(fmt::format(
          "the picture of the {} is {}: it is stretched to fit; crop it to the pack, or "
          "correct the size",
          shown_by(fit),
          stretched(fit)));
  }
  return notes;
}

Result<void> check_fits(const std::vector<FaceFit>& fits) {
  for (const FaceFit& fit : fits) {
    if (is_stretched(fit, max_stretch))
      return Error{"assets.bad_row",
                   fit.picture.where,
                   fmt::format("a picture of {} x {} pixels is {}; crop it to the pack alone, turn "
                               "it upright, or correct the size",
                               fit.picture.size.width,
                               fit.picture.size.height,
                               stretched(fit))};
  }
  return {};
}

Result<void> check_faces(const catalog::Product& product) {
  if (!product.faces) return {};
  MARKETGEN_TRY(const PixelsBySide pictures, kept_pixels(product));
  MARKETGEN_TRY(const std::vector<FaceFit> fits, face_fits(product, pictures));
  return check_fits(fits);
}

}  // namespace marketgen::assets
