#include "scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalog/own_files.h"
#include "io/file.h"
#include "io/flatbuffer.h"
#include "scene/placements.h"

namespace marketgen::scene {
namespace {

// First fault found; later ones are not looked for.
class IndexCheck {
 public:
  explicit IndexCheck(const std::string& source) : source_(source) {}

  void row(std::string_view table,
           std::size_t at,
           std::string_view column,
           std::uint64_t value,
           std::size_t rows) {
    if (fault_.empty() && value >= rows) {
      fault_ =
          fmt::format("{}[{}].{} is {}, but there are {} rows", table, at, column, value, rows);
    }
  }
  void range(std::string_view table,
             std::size_t at,
             std::string_view column,
             std::uint64_t first,
             std::uint64_t number,
             std::size_t rows) {
    if (fault_.empty() && first + number > rows) {
      fault_ = fmt::format("{}[{}]: {} {} to {} go past the {} rows",
                           table,
                           at,
                           column,
                           first,
                           first + number,
                           rows);
    }
  }
  void require(bool holds, std::string_view what) {
    if (fault_.empty() && !holds) fault_ = std::string(what);
  }
  Result<void> result() const {
    if (fault_.empty()) return {};
    return Error{
        "scene.corrupt", source_, fault_ + "; restore the file or generate the store again"};
  }

 private:
  const std::string& source_;
  std::string fault_;
};

void check_fixtures(const Scene& scene, IndexCheck& check) {
  check.require(scene.fixtures.size() == scene.layout.fixtures.size(),
                "fixtures and layout.fixtures differ in length");
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i) {
    const SceneFixture& f = scene.fixtures[i];
    check.range("fixtures", i, "parts", f.first_part, f.part_count, scene.parts.size());
    check.range("fixtures", i, "shelves", f.first_shelf, f.shelf_count, scene.shelves.size());
    check.range("fixtures", i, "joints", f.first_joint, f.joint_count, scene.joints.size());
  }
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    check.row("parts", i, "fixture", scene.parts[i].fixture, scene.fixtures.size());
    if (scene.parts[i].material >= 0) {
      check.row("parts",
                i,
                "material",
                static_cast<std::uint64_t>(scene.parts[i].material),
                scene.materials.size());
    }
  }
  for (std::size_t i = 0; i < scene.shelves.size(); ++i)
    check.row("shelves", i, "fixture", scene.shelves[i].fixture, scene.fixtures.size());
}

// Limits the right way round, and every named position within them.
bool has_sound_range(const SceneJoint& joint) {
  constexpr double rounding = 1e-5;  // limits are single precision, states double
  const double low = joint.lower - rounding, high = joint.upper + rounding;
  return joint.lower <= joint.upper && low <= 0 && high >= 0 &&
         std::ranges::all_of(joint.states, [&](const assets::JointState& state) {
           return state.position >= low && state.position <= high;
         });
}

// What a row of joints must fulfil beside its field rules: a parent that stands before it on the
// same fixture, so that no chain of parents ever closes.
void check_joints(const Scene& scene, IndexCheck& check) {
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const SceneJoint& joint = scene.joints[i];
    check.row("joints", i, "fixture", joint.fixture, scene.fixtures.size());
    check.require(has_sound_range(joint), "limits and states of a joint do not fit together");
    if (joint.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(joint.parent);
    check.row("joints", i, "parent", parent, i);
    check.require(parent >= i || scene.joints[parent].fixture == joint.fixture,
                  "a joint and its parent are on two fixtures");
  }
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const ScenePart& part = scene.parts[i];
    if (part.joint < 0) continue;
    const auto joint = static_cast<std::size_t>(part.joint);
    check.row("parts", i, "joint", joint, scene.joints.size());
    check.require(joint >= scene.joints.size() || scene.joints[joint].fixture == part.fixture,
                  "a part and its joint are on two fixtures");
  }
}

void check_stock(const Scene& scene, IndexCheck& check) {
  for (std::size_t i = 0; i < scene.facings.size(); ++i) {
    const Facing& f = scene.facings[i];
    check.row("facings", i, "shelf", f.shelf, scene.shelves.size());
    check.row("facings", i, "sku", f.sku, scene.catalog.size());
    check.range("facings", i, "products", f.first_product, f.product_count, scene.products.size());
  }
  for (std::size_t i = 0; i < scene.products.size(); ++i) {
    check.row("products", i, "sku", scene.products[i].sku, scene.catalog.size());
    if (scene.products[i].facing != no_facing)
      check.row("products", i, "facing", scene.products[i].facing, scene.facings.size());
  }
  for (std::size_t i = 0; i < scene.price_labels.size(); ++i) {
    check.row("price_labels", i, "shelf", scene.price_labels[i].shelf, scene.shelves.size());
    check.row("price_labels", i, "sku", scene.price_labels[i].sku, scene.catalog.size());
    check.row("price_labels", i, "facing", scene.price_labels[i].facing, scene.facings.size());
  }
}

}  // namespace

std::string encode_scene(const Scene& scene) {
  return io::write_flatbuffer_of(type_of<Scene>(), &scene, scene_file_identifier);
}

Result<void> check_indices(const Scene& scene, const std::string& source) {
  IndexCheck check(source);
  check.require(scene.schema == "market-scene/1", "the schema tag is not market-scene/1");
  check_fixtures(scene, check);
  check_joints(scene, check);
  check_stock(scene, check);
  return check.result();
}

Result<Scene> decode_scene(std::span<const std::byte> bytes, const std::string& source) {
  Scene scene;
  MARKETGEN_CHECK(
      io::read_flatbuffer_into(bytes, source, scene_file_identifier, type_of<Scene>(), &scene));
  MARKETGEN_CHECK(check_indices(scene, source));
  return scene;
}

Result<Scene> open_scene(const std::filesystem::path& file) {
  MARKETGEN_TRY(const io::MappedFile mapped, io::MappedFile::open(file));
  MARKETGEN_TRY(Scene scene, decode_scene(mapped.bytes(), file.string()));
  MARKETGEN_CHECK(catalog::restore_own_files(scene.catalog, file.parent_path()));
  return scene;
}

}  // namespace marketgen::scene
