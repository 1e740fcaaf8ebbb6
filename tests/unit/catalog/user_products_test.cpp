// A user's own products: CSV, JSON, and rows with a mesh.
#include "catalog/user_products.h"

#include <gtest/gtest.h>

#include <fstream>

#include "catalog/catalog.h"
#include "catalog/own_files.h"
#include "catalog/own_mesh.h"
#include "support/glb_bytes.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

class UserProducts : public testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", (scratch_.path() / "cache").c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  fs::path write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((scratch_.path() / name).parent_path());
    std::ofstream(scratch_.path() / name, std::ios::binary) << bytes;
    return scratch_.path() / name;
  }
  Result<std::vector<catalog::Product>> read(const std::string& name,
                                             const std::string& bytes) const {
    return catalog::read_user_products(write(name, bytes));
  }
  void expect_refused(const Result<std::vector<catalog::Product>>& read,
                      const std::string& code,
                      const std::string& where,
                      const std::string& says) const {
    ASSERT_FALSE(read.ok()) << says;
    EXPECT_EQ(read.error().code.rfind(code, 0), 0U) << to_string(read.error());
    EXPECT_NE(read.error().where.find(where), std::string::npos) << to_string(read.error());
    EXPECT_NE(read.error().message.find(says), std::string::npos) << to_string(read.error());
  }

  ScratchFolder scratch_;
};

constexpr const char* header =
    "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg,keywords,storage,label.primary\n";

// What a row does not say about what it is made of comes from packs of its shape, and the friction
// from that; what it says, stays.
TEST_F(UserProducts, AContactMaterialThatIsNotNamedIsThatOfThePack) {
  const fs::path file =
      write("own.csv",
            "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg,material\n"
            "own-a,2999999999991,A,beverages,soft drinks,can,66x66x115,0.35,\n"
            "own-b,2999999999984,B,canned,soup,food_tin,75x75x110,0.4,\n"
            "own-c,2999999999977,C,dry_goods,sauces,jar,70x70x120,0.5,\n"
            "own-d,2999999999960,D,snacks,crisps,pillow_bag,150x60x220,0.2,foil\n");
  const fs::path rows =
      write("own.json",
            R"([{"sku": "own-e", "ean": "2999999999953", "name": "E", "category": "beverages",
          "subcategory": "soft drinks", "archetype": "can", "size_mm": [66, 66, 115],
          "mass_kg": 0.35, "friction": 0.31}])");
  const auto catalog = catalog::load_catalog(fs::path(MARKETGEN_SOURCE_DIR) / "data", {file, rows});
  ASSERT_TRUE(catalog.ok()) << to_string(catalog.error());
  const auto material = [&](const char* sku) { return catalog->product(sku)->material; };
  EXPECT_EQ(material("own-a"), "aluminium");
  EXPECT_EQ(material("own-b"), "tin");
  EXPECT_EQ(material("own-c"), "glass");
  EXPECT_EQ(material("own-d"), "foil");
  EXPECT_EQ(material("own-e"), "aluminium");
  EXPECT_DOUBLE_EQ(catalog->product("own-a")->friction, 0.25);  // data/friction.json
  EXPECT_DOUBLE_EQ(catalog->product("own-d")->friction, 0.28);
  EXPECT_DOUBLE_EQ(catalog->product("own-e")->friction, 0.31);
  EXPECT_EQ(catalog->own, (std::vector<std::string>{"own-a", "own-b", "own-c", "own-d", "own-e"}));
}

TEST_F(UserProducts, CsvRow) {
  const auto products =
      read("own.csv",
           std::string(header) +
               "own-cola,2999999999991,\"Cola, red\",beverages,soft drinks,can,66x66 x115,0.35,"
               "cola; soft drink,chilled,#aa0000\n");
  ASSERT_TRUE(products.ok()) << to_string(products.error());
  ASSERT_EQ(products->size(), 1U);
  const catalog::Product& p = products->at(0);
  EXPECT_EQ(p.sku, "own-cola");
  EXPECT_EQ(p.name, "Cola, red");
  EXPECT_EQ(p.size_mm, (std::array<int, 3>{66, 66, 115}));
  EXPECT_DOUBLE_EQ(p.mass_kg, 0.35);
  EXPECT_EQ(p.keywords, (std::vector<std::string>{"cola", "soft drink"}));
  EXPECT_EQ(p.storage, catalog::Storage::chilled);
  EXPECT_EQ(p.label.primary, "#aa0000");
  EXPECT_EQ(p.label.text, catalog::LabelStyle{}.text);  // what is not given keeps its default
}

TEST_F(UserProducts, CsvFaultsNameLineAndField) {
  const std::string row =
      "own-cola,2999999999991,Cola,beverages,soft drinks,can,66x66x115,0.35,,,\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = header + row;
    text.replace(text.find(from), from.size(), to);
    return read("own.csv", text);
  };
  expect_refused(with("mass_kg", "mas_kg"), "json.unknown_field", "own.csv:1", "\"mass_kg\"");
  expect_refused(
      with("label.primary", "label.colour"), "json.unknown_field", "own.csv:1", "column");
  expect_refused(with("0.35", "heavy"), "json.wrong_type", "own.csv:2:/mass_kg", "\"heavy\"");
  expect_refused(with("66x66x115", "66x66"), "json.", "own.csv:2:/size_mm", "");
  expect_refused(with("0.35,", "99,"), "json.out_of_range", "own.csv:2:/mass_kg", "99");
  expect_refused(with("Cola", ""), "json.missing_field", "own.csv:2", "name");
  expect_refused(with(",,,\n", ",,cold,\n"), "json.unknown_name", "own.csv:2:/storage", "cold");
  expect_refused(with(",,,\n", ",\n"), "csv.syntax", "own.csv:2", "fields");
}

std::string mesh_row(const std::string& mesh, const std::string& size = "[80, 60, 150]") {
  return R"([{"sku": "own-tea", "ean": "2999999999991", "name": "Tea", "category": "dry_goods",
    "subcategory": "tea", "archetype": "mesh", "mesh": ")" +
         mesh + R"(", "size_mm": )" + size + R"(, "mass_kg": 0.1}])";
}

TEST_F(UserProducts, MeshIsKeptByItsContent) {
  write("tea.glb", box_glb(0.0802F, 0.15F, 0.06F));  // 0.2 mm wider than the row says
  const auto products = read("own.json", mesh_row("tea.glb"));
  ASSERT_TRUE(products.ok()) << to_string(products.error());
  const catalog::Product& p = products->at(0);
  EXPECT_EQ(p.mesh.size(), 68U);
  EXPECT_EQ(read("again/own.json", mesh_row("x.glb")).error().code, "input.not_found");
  write("again/other.glb", box_glb(0.0802F, 0.15F, 0.06F));
  EXPECT_EQ(read("again/own.json", mesh_row("other.glb"))->at(0).mesh, p.mesh);
  const auto model = catalog::kept_mesh(p);
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  const Bounds3 bounds = bounds_of(model->mesh);
  EXPECT_NEAR(bounds.size().x, 0.08, 1e-6);  // exactly the row's
  EXPECT_NEAR(bounds.low.y, 0, 1e-6);
  EXPECT_NEAR(bounds.center().z, 0, 1e-6);
}

// What lies in the cache under a mesh's name is that mesh or is put right: from the catalogue, or
// from a store that has it.
TEST_F(UserProducts, AChangedMeshIsPutRight) {
  write("tea.glb", box_glb(0.0802F, 0.15F, 0.06F));
  const catalog::Product tea = read("own.json", mesh_row("tea.glb"))->at(0);
  const std::filesystem::path kept = scratch_.path() / "cache" / "meshes" / tea.mesh;
  const std::string whole = contents_of(kept);
  ASSERT_TRUE(catalog::save_own_files({tea}, scratch_.path() / "shop").ok());
  for (const std::string& damaged : {whole.substr(0, 100), std::string(), whole + "x"}) {
    std::ofstream(kept, std::ios::binary) << damaged;
    EXPECT_EQ(catalog::kept_mesh(tea).error().code, "input.not_found") << "it is not used";
    std::ofstream(kept, std::ios::binary) << damaged;
    ASSERT_TRUE(read("own.json", mesh_row("tea.glb")).ok());
    EXPECT_EQ(contents_of(kept), whole);
    std::ofstream(kept, std::ios::binary) << damaged;
    ASSERT_TRUE(catalog::restore_own_files({tea}, scratch_.path() / "shop").ok());
    EXPECT_EQ(contents_of(kept), whole);
    EXPECT_TRUE(catalog::kept_mesh(tea).ok());
  }
}

TEST_F(UserProducts, MeshMustBeThereWithinTheFolderAndTheArchetype) {
  write("tea.glb", box_glb(0.08F, 0.15F, 0.06F));
  for (const char* name : {"../tea.glb", "/etc/passwd", "a/../../tea.glb"})
    expect_refused(read("rows/own.json", mesh_row(name)),
                   "input.outside_folder",
                   "own-tea/mesh",
                   "not in the folder");
  expect_refused(
      read("own.json", mesh_row("")), "catalog.bad_row", "own-tea/mesh", "name of a file");
  std::string row = mesh_row("tea.glb");
  row.replace(row.find("\"mesh\""), 6, "\"box\"");
  expect_refused(read("own.json", row), "catalog.bad_row", "own-tea/mesh", "write \"mesh\"");
}

TEST_F(UserProducts, WrongUnitAndWrongSideSayWhatMendsThem) {
  write("mm.glb", box_glb(80, 150, 60));
  write("inch.glb", box_glb(3.15F, 5.906F, 2.362F));
  write("lying.glb", box_glb(0.08F, 0.06F, 0.15F));
  write("other.glb", box_glb(0.09F, 0.15F, 0.06F));
  const auto refused = [&](const char* mesh, const char* says) {
    expect_refused(read("own.json", mesh_row(mesh)), "model.bad_scale", mesh, says);
  };
  refused("mm.glb", "--unit mm");
  refused("inch.glb", "--unit inch");
  refused("lying.glb", "turn it");
  refused("other.glb", "correct size_mm");
}

TEST_F(UserProducts, StoreFoldersCarryTheirMeshes) {
  write("tea.glb", box_glb(0.08F, 0.15F, 0.06F));
  const auto products = read("own.json", mesh_row("tea.glb"));
  ASSERT_TRUE(products.ok());
  ASSERT_TRUE(catalog::save_own_files(*products, scratch_.path() / "store").ok());
  fs::remove_all(scratch_.path() / "cache");
  EXPECT_EQ(catalog::kept_mesh(products->at(0)).error().code, "input.not_found");
  ASSERT_TRUE(catalog::restore_own_files(*products, scratch_.path() / "store").ok());
  EXPECT_TRUE(catalog::kept_mesh(products->at(0)).ok());

  fs::remove_all(scratch_.path() / "cache");
  write("store/meshes/" + products->at(0).mesh, box_glb(1, 1, 1));  // not what the name says
  EXPECT_EQ(catalog::restore_own_files(*products, scratch_.path() / "store").error().code,
            "model.bad_file");
  catalog::Product hostile = products->at(0);
  hostile.mesh = "../../../etc/passwd";
  EXPECT_EQ(catalog::kept_mesh(hostile).error().code, "model.bad_file");
  EXPECT_EQ(catalog::restore_own_files({hostile}, scratch_.path()).error().code, "model.bad_file");
}

}  // namespace
}  // namespace marketgen
