// Outside models: what is measured is right, what is guessed says why, and the result can be used
// as a product.
#include "assets/import/import_asset.h"

#include <gtest/gtest.h>

#include <fstream>

#include "assets/import/model_look.h"
#include "assets/own_pack.h"
#include "assets/print/label.h"
#include "assets/product_model.h"
#include "assets/shapes/convex_worker.h"
#include "assets/shapes/outer_hull.h"
#include "catalog/gtin.h"
#include "catalog/user_products.h"
#include "io/json.h"
#include "io/png.h"
#include "io/program.h"
#include "support/committed_catalog.h"
#include "support/glb_bytes.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

const catalog::AssetDatabase& database() {
  static const auto made = catalog::AssetDatabase::build(committed_catalog());
  return made.value();
}

class Import : public testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", (scratch_.path() / "cache").c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  Result<assets::ImportedAsset> import(const std::string& name,
                                       const std::string& bytes,
                                       assets::ImportOptions options = {}) const {
    options.coacd = false;
    std::ofstream(scratch_.path() / name, std::ios::binary) << bytes;
    return assets::import_asset(scratch_.path() / name,
                                options,
                                committed_catalog(),
                                assets::offline_annotator(committed_catalog(), database()));
  }
  // Imports, writes, and loads it as `--catalog` does.
  Result<catalog::Product> imported_product(const std::string& name,
                                            const std::string& bytes) const {
    MARKETGEN_TRY(const assets::ImportedAsset asset, import(name, bytes));
    MARKETGEN_CHECK(assets::write_asset(asset, scratch_.path() / "library"));
    MARKETGEN_TRY(const std::vector<catalog::Product> read,
                  catalog::read_user_products(scratch_.path() / "library/asset.json"));
    return read.at(0);
  }
  ScratchFolder scratch_;
};

// A box of 80 x 60 x 150 mm whose texture is red above and yellow below.
std::string painted_box() {
  Image picture(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      picture.at(x, y)[0] = 200;
      picture.at(x, y)[1] = static_cast<std::uint8_t>(y < 6 ? 16 : 208);
      picture.at(x, y)[2] = 16;
    }
  }
  const std::string png = io::encode_png(picture).value();
  std::string uvs = raw_bytes<float>({0, 1, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0});
  std::string glb = box_glb(0.08F,
                            0.15F,
                            0.06F,
                            R"({"mesh": 0, "name": "Cube.001"})",
                            R"(, "materials": [{"name": "printed cardboard", "pbrMetallicRoughness":
          {"roughnessFactor": 0.5, "metallicFactor": 0, "baseColorTexture": {"index": 0}}}],
          "textures": [{"source": 0}], "images": [{"bufferView": 3}])",
                            uvs + png);
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, 4);
  std::string json = glb.substr(20, size);
  const auto put = [&](const std::string& from, const std::string& to) {
    json.replace(json.find(from), from.size(), to);
  };
  put(R"({"POSITION": 0}, "indices": 1)",
      R"({"POSITION": 0, "TEXCOORD_0": 2}, "indices": 1, "material": 0)");
  put(R"("type": "SCALAR"})",
      R"("type": "SCALAR"}, {"bufferView": 2, "componentType": 5126, "count": 8, "type": "VEC2"})");
  put(R"("byteLength": 72})",
      R"("byteLength": 72}, {"buffer": 0, "byteOffset": 168, "byteLength": 64},
         {"buffer": 0, "byteOffset": 232, "byteLength": )" +
          std::to_string(png.size()) + "}");
  return glb_bytes(json, glb.substr(20 + size + 8));
}

TEST_F(Import, MeasuresNamesAndPixelsBecomeAnAsset) {
  const auto asset = import("GreenTea_box.glb", painted_box());
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  const catalog::AssetFile& file = asset->file;
  EXPECT_EQ(file.product.size_mm, (std::array<int, 3>{80, 60, 150}));
  EXPECT_EQ(file.product.name, "Green tea box");
  EXPECT_EQ(file.product.category, "dry_goods");
  EXPECT_EQ(file.product.subcategory, "tea");
  EXPECT_EQ(file.product.material, "cardboard");  // the material's name says so
  EXPECT_EQ(file.annotation.archetype, "box");
  EXPECT_EQ(file.annotation.annotator, "offline");
  EXPECT_TRUE(catalog::is_ean13(file.product.ean)) << file.product.ean;
  EXPECT_TRUE(catalog::is_restricted_circulation(file.product.ean));
  EXPECT_TRUE(file.source.watertight);
  EXPECT_EQ(file.source.open_edges, 0);
  EXPECT_EQ(file.source.triangles, 12);
  EXPECT_NEAR(file.estimates.volume_m3, 0.00072, 1e-7);
  EXPECT_EQ(file.estimates.contact_from, "hull");
  EXPECT_NEAR(file.estimates.pieces_volume_m3, 0.00072, 1e-6);
  EXPECT_DOUBLE_EQ(file.product.friction, 0.35);  // cardboard on steel, data/friction.json
  ASSERT_EQ(file.look.colors.size(), 2U);
  EXPECT_EQ(file.look.colors[0].color, "#c81010");
  EXPECT_DOUBLE_EQ(file.look.colors[0].share, 0.75);
  EXPECT_DOUBLE_EQ(file.look.roughness, 0.5);
  // Tea in cardboard: between 100 and 400 kg/m3.
  EXPECT_GT(file.product.mass_kg, 0.05);
  EXPECT_LT(file.product.mass_kg, 0.35);
  EXPECT_NE(file.estimates.mass_from.find("median"), std::string::npos);
}

// What an import writes, --catalog reads: a mass that no row may have is refused before the work,
// one that contradicts the size before anything is written.
TEST_F(Import, AMassThatNoRowMayHave) {
  for (const double mass_kg : {1e308, 50.001, 1e-7, 0.0, -1.0}) {
    assets::ImportOptions options;
    options.row.mass_kg = mass_kg;
    const auto asset = import("box.glb", painted_box(), options);
    ASSERT_FALSE(asset.ok()) << mass_kg;
    EXPECT_EQ(asset.error().code, "usage.bad_flag");
    EXPECT_EQ(asset.error().where, "--mass-kg");
    EXPECT_NE(asset.error().message.find("0.001 to 50 kg"), std::string::npos);
  }
  assets::ImportOptions options;
  options.row.mass_kg = 40;  // 0.7 litres
  const auto heavy = import("box.glb", painted_box(), options);
  ASSERT_FALSE(heavy.ok());
  EXPECT_EQ(heavy.error().code, "catalog.bad_row");
  EXPECT_NE(heavy.error().message.find("is plausible"), std::string::npos);
  options.row.mass_kg = 0.5;
  EXPECT_TRUE(import("box.glb", painted_box(), options).ok());
}

TEST_F(Import, TheAssetIsAProductLikeAnyOther) {
  const auto product = imported_product("green tea.glb", painted_box());
  ASSERT_TRUE(product.ok()) << to_string(product.error());
  const auto model = assets::make_product_model(*product);
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  const Bounds3 bounds = bounds_of(model->mesh);
  EXPECT_NEAR(bounds.size().x, 0.08, 1e-5);
  EXPECT_NEAR(bounds.size().y, 0.06, 1e-5);
  EXPECT_NEAR(bounds.high.z, 0.15, 1e-5);
  EXPECT_NEAR(bounds.low.z, 0, 1e-6);
  EXPECT_TRUE(is_watertight(model->mesh));
  EXPECT_EQ(model->surfaces.at(model->mesh.surfaces[0]).texture, "label");
  const auto picture = assets::draw_label(*product, 64);
  ASSERT_TRUE(picture.ok()) << to_string(picture.error());
  EXPECT_EQ(picture->at(0, 0)[0], 200);

  const auto body = assets::make_product_body(*product);
  ASSERT_TRUE(body.ok()) << to_string(body.error());
  EXPECT_NEAR(body->center_of_mass.z, 0.075, 1e-4);
  const double m = product->mass_kg;  // a box: m (b2 + c2) / 12
  EXPECT_NEAR(body->inertia_kg_m2[0] / (m * (0.06 * 0.06 + 0.15 * 0.15) / 12), 1, 0.01);
  EXPECT_NEAR(body->inertia_kg_m2[2] / (m * (0.08 * 0.08 + 0.06 * 0.06) / 12), 1, 0.01);
  ASSERT_EQ(body->pieces.size(), 1U);
  EXPECT_EQ(body->pieces[0].shape, assets::PieceShape::hull);
}

TEST_F(Import, FrontIsTheSideThatFacesPlusZ) {  // glTF: +Z to the viewer; ours: -Y to the shopper
  io::OutsideModel wedge;                       // a roof whose ridge lies towards +Z
  std::ofstream(scratch_.path() / "wedge.obj")
      << "v -0.05 0 -0.05\nv 0.05 0 -0.05\nv 0.05 0 0.05\nv -0.05 0 0.05\nv -0.05 0.1 0.05\n"
         "v 0.05 0.1 0.05\nf 1 2 3 4\nf 3 6 5 4\nf 1 5 6 2\nf 1 4 5\nf 2 6 3\n";
  const auto asset = import("wedge.obj", contents_of(scratch_.path() / "wedge.obj"), [] {
    assets::ImportOptions options;
    options.row.category = "bakery";
    options.row.mass_kg = 0.4;
    return options;
  }());
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  ASSERT_TRUE(assets::write_asset(*asset, scratch_.path() / "wedge").ok());
  const auto product = catalog::read_user_products(scratch_.path() / "wedge/asset.json");
  ASSERT_TRUE(product.ok()) << to_string(product.error());
  EXPECT_DOUBLE_EQ(product->at(0).mass_kg, 0.4);
  EXPECT_LT(assets::make_product_body(product->at(0))->center_of_mass.y, -0.01);
}

TEST_F(Import, WrongUnitSaysWhichFits) {
  const auto refused = [&](float width, float height, float depth, const char* says) {
    const auto asset = import("tea.glb", box_glb(width, height, depth));
    ASSERT_FALSE(asset.ok());
    EXPECT_EQ(asset.error().code, "model.bad_scale");
    EXPECT_NE(asset.error().message.find(says), std::string::npos) << asset.error().message;
  };
  refused(80, 150, 60, "--unit mm");
  refused(8, 15, 6, "--unit cm");
  refused(0.08F, 0.15F, 0.0001F, "5 mm to 1.5 m");
  assets::ImportOptions options;
  options.unit = catalog::LengthUnit::mm;
  const auto asset = import("tea.glb", box_glb(80, 150, 60), options);
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  EXPECT_EQ(asset->file.product.size_mm, (std::array<int, 3>{80, 60, 150}));
}

TEST_F(Import, ZUpIsTurned) {
  assets::ImportOptions options;
  options.up = assets::UpAxis::z;
  const auto asset = import("tea.glb", box_glb(0.08F, 0.06F, 0.15F), options);
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  EXPECT_EQ(asset->file.product.size_mm, (std::array<int, 3>{80, 60, 150}));
}

TEST_F(Import, HolesAreReported) {
  std::string glb = box_glb(0.08F, 0.15F, 0.06F);
  const std::string all = R"("count": 36)", fewer = R"("count": 33)";
  glb.replace(glb.find(all), all.size(), fewer);  // a triangle less
  const auto asset = import("tea.glb", glb);
  ASSERT_TRUE(asset.ok()) << to_string(asset.error());
  EXPECT_FALSE(asset->file.source.watertight);
  EXPECT_EQ(asset->file.source.open_edges, 3);
  EXPECT_NEAR(asset->file.estimates.volume_m3, 0.00072, 1e-6);  // of its hull
  EXPECT_NE(asset->file.notes.at(0).find("3 open edges"), std::string::npos);
}

TEST_F(Import, NamesThatSayNothingNeedACategory) {
  const auto asset = import("mesh_001.glb", box_glb(0.08F, 0.15F, 0.06F, R"({"mesh": 0})"));
  ASSERT_FALSE(asset.ok());
  EXPECT_EQ(asset.error().code, "catalog.unknown_kind");
  EXPECT_NE(asset.error().message.find("--category"), std::string::npos);
  assets::ImportOptions options;
  options.row.category = "snaks";
  EXPECT_NE(import("x.glb", box_glb(0.1F, 0.1F, 0.1F), options).error().message.find("\"snacks\""),
            std::string::npos);
}

TEST_F(Import, AnyAnnotatorCanBePluggedIn) {
  std::ofstream(scratch_.path() / "x.glb", std::ios::binary) << painted_box();
  assets::ImportOptions options;
  options.coacd = false;
  const assets::AssetAnnotator oracle =
      [](const assets::AssetEvidence& evidence) -> Result<catalog::AssetAnnotation> {
    EXPECT_EQ(evidence.file_name, "x.glb");
    EXPECT_EQ(evidence.size_mm, (std::array<int, 3>{80, 60, 150}));
    EXPECT_EQ(evidence.pictures->size(), 1U);
    catalog::AssetAnnotation said;
    said.annotator = "oracle";
    said.name = "Rice";
    said.category = "dry_goods";
    said.subcategory = "rice";
    return said;
  };
  const auto asset =
      assets::import_asset(scratch_.path() / "x.glb", options, committed_catalog(), oracle);
  ASSERT_TRUE(asset.ok());
  EXPECT_EQ(asset->file.product.subcategory, "rice");
}

TEST_F(Import, TheFileIsItsOwnSchema) {
  const auto asset = import("green tea.glb", painted_box());
  ASSERT_TRUE(asset.ok());
  const std::string text = io::write_json(asset->file);
  const auto read = io::read_json<catalog::AssetFile>(text, "asset.json");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(io::write_json(*read), text);
  EXPECT_EQ(import("green tea.glb", painted_box())->model, asset->model);  // the same bytes again
}

TEST(AssetNames, WordsOfNames) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(assets::words_of_names({"TomatoSoup_can.001"}), (Words{"tomato", "soup", "can"}));
  EXPECT_EQ(assets::words_of_names({"Mesh_0", "lambert1SG", "default"}), (Words{"sg"}));
  EXPECT_EQ(assets::words_of_names({"glass jar", "Jar"}), (Words{"glass", "jar"}));
}

TEST(OuterHull, OfABoxAndABall) {
  std::vector<Vec3f> box, ball;
  for (int i = 0; i < 8; ++i)
    box.push_back(
        {(i & 1) != 0 ? 0.1F : 0.0F, (i & 2) != 0 ? 0.2F : 0.0F, (i & 4) != 0 ? 0.3F : 0.0F});
  EXPECT_NEAR(volume_of(assets::outer_hull(box)), 0.006, 1e-6);
  for (int i = 0; i < 5000; ++i) {  // a golden spiral over the unit sphere
    const double z = 1 - (2.0 * i + 1) / 5000, r = std::sqrt(1 - z * z), a = 2.399963 * i;
    ball.push_back(to_float(Vec3{r * std::cos(a), r * std::sin(a), z}));
  }
  EXPECT_NEAR(volume_of(assets::outer_hull(ball)) / (4.0 / 3 * 3.14159265), 0.985, 0.015);
  EXPECT_TRUE(assets::outer_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.empty());
}

// An L of two arms: no convex shape; CoACD gives two pieces that fill it.
TEST(ConvexPieces, OfAnLAreItsArms) {
  if (const auto coacd = io::worker_part("coacd"); !coacd.ok())
    GTEST_SKIP() << to_string(coacd.error());
  const std::vector<Vec2f> outline{
      {0, 0}, {0.1F, 0}, {0.1F, 0.03F}, {0.03F, 0.03F}, {0.03F, 0.1F}, {0, 0.1F}};
  Mesh mesh;
  for (const float z : {0.0F, 0.05F}) {
    for (const Vec2f& p : outline)
      mesh.add_vertex({p.x, p.y, z}, {0, 0, 1}, {});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.add_triangle(i, j, 6 + j, 0);
    mesh.add_triangle(i, 6 + j, 6 + i, 0);
  }
  for (std::uint32_t i = 1; i + 1 < 6; ++i) {
    mesh.add_triangle(0, i + 1, i, 0);
    mesh.add_triangle(6, 6 + i, 6 + i + 1, 0);
  }
  const auto pieces = assets::convex_pieces(mesh);
  ASSERT_TRUE(pieces.ok()) << to_string(pieces.error());
  ASSERT_EQ(pieces->size(), 2U);
  double volume = 0;
  for (const std::vector<Vec3f>& piece : *pieces)
    volume += volume_of(assets::outer_hull(piece));
  EXPECT_NEAR(volume / (0.05 * (0.1 * 0.03 + 0.03 * 0.07)), 1, 0.03);
  EXPECT_EQ(*assets::convex_pieces(mesh), *pieces);
}

}  // namespace
}  // namespace marketgen
