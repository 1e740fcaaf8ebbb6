#include "render/picture_objects.h"

#include <fmt/format.h>

#include <algorithm>

namespace marketgen::render {
namespace {

constexpr std::string_view plain_actor = "actor";
constexpr std::uint16_t plain_actor_number = 2;

// Row numbers of the categories called so, all of one kind, added to `rows` by name.
std::map<std::string, std::uint16_t> add_rows(std::vector<PictureCategory>& rows,
                                              ObjectKind kind,
                                              const std::vector<std::string>& names) {
  std::map<std::string, std::uint16_t> numbers;
  for (const std::string& name : names)
    numbers[name];
  for (auto& [name, number] : numbers) {
    number = static_cast<std::uint16_t>(rows.size() + 1);
    rows.push_back({number, kind, name, hex_of_object_color(number)});
  }
  return numbers;
}

}  // namespace

std::string hex_of_object_color(std::uint32_t object) {
  const auto [r, g, b] = object_color(object);
  return fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
}

ObjectKind kind_of(const scene::Scene& scene, std::uint32_t object) {
  if (object >= first_actor_object(scene)) return ObjectKind::actor;
  if (object >= first_product_object(scene)) return ObjectKind::product;
  return object >= first_fixture_object ? ObjectKind::fixture : ObjectKind::shell;
}

PictureCategories::PictureCategories(const scene::Scene& scene,
                                     const std::vector<std::string>& categories_of_actors)
    : scene_(scene) {
  add_rows(rows_, ObjectKind::shell, {"shell"});
  add_rows(rows_, ObjectKind::actor, {std::string(plain_actor)});
  std::vector<std::string> kinds, categories;
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i)
    kinds.push_back(scene.layout.fixtures[i].kind);
  for (const catalog::Product& product : scene.catalog)
    categories.push_back(product.category);
  const auto number_of_kind = add_rows(rows_, ObjectKind::fixture, kinds);
  const auto number_of_category = add_rows(rows_, ObjectKind::product, categories);
  for (const std::string& kind : kinds)
    of_fixture_.push_back(number_of_kind.at(kind));
  for (const std::string& category : categories)
    of_sku_.push_back(number_of_category.at(category));
  add_categories_of(categories_of_actors);
}

void PictureCategories::add_categories_of(const std::vector<std::string>& actors) {
  std::vector<std::string> others;
  std::copy_if(
      actors.begin(), actors.end(), std::back_inserter(others), [](const std::string& category) {
        return category != plain_actor;
      });
  auto numbers = add_rows(rows_, ObjectKind::actor, others);
  numbers.emplace(plain_actor, plain_actor_number);
  for (const std::string& category : actors)
    of_actor_.push_back(numbers.at(category));
}

std::uint16_t PictureCategories::of(std::uint32_t object) const {
  if (object == 0) return 0;
  switch (kind_of(scene_, object)) {
    case ObjectKind::fixture:
      return of_fixture_[object - first_fixture_object];
    case ObjectKind::product:
      return of_sku_[scene_.products[object - first_product_object(scene_)].sku];
    case ObjectKind::actor: {
      const std::uint32_t actor = object - first_actor_object(scene_);
      return actor < of_actor_.size() ? of_actor_[actor] : plain_actor_number;
    }
    case ObjectKind::shell:
      break;
  }
  return 1;
}

Image draw_object_ids(const Frame& frame) {
  Image image(frame.color.width, frame.color.height);
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(frame.instance[i] >> (8 * c));
  }
  return image;
}

std::vector<std::uint16_t> category_ids(const Frame& frame, const PictureCategories& categories) {
  std::vector<std::uint16_t> ids(frame.instance.size());
  std::transform(
      frame.instance.begin(), frame.instance.end(), ids.begin(), [&](std::uint32_t object) {
        return categories.of(object);
      });
  return ids;
}

}  // namespace marketgen::render
