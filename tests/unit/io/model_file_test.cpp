// Models from outside: what a GLB or an OBJ says is what is read; what is broken, hostile or too
// large is refused with its own code.
#include "io/model_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "io/png.h"
#include "support/glb_bytes.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

std::string changed(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) fatal("the text does not hold what should be replaced");
  return text.replace(at, from.size(), to);
}

// The JSON of a GLB with one piece of it replaced; the chunk's length follows.
std::string with_json(const std::string& glb, std::string_view from, std::string_view to) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, 4);
  return glb_bytes(changed(glb.substr(20, size), from, to), glb.substr(20 + size + 8));
}

Result<io::OutsideModel> obj(const std::string& text, const std::string& library = "") {
  return io::parse_obj(text, "thing.obj", [&](const std::string& name) -> Result<std::string> {
    if (!library.empty()) return library;
    return Error{"input.not_found", name, "is not there"};
  });
}

void expect_refused(const Result<io::OutsideModel>& read,
                    const std::string& code,
                    const char* says) {
  ASSERT_FALSE(read.ok()) << says;
  EXPECT_EQ(read.error().code, code) << to_string(read.error());
  EXPECT_NE(read.error().message.find(says), std::string::npos) << to_string(read.error());
}

// ---- What is read. ----

TEST(Glb, BoxHasItsSizeItsNamesAndSharpNormals) {
  const auto model = io::parse_glb(box_glb(0.2F, 0.3F, 0.1F), "box.glb");
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_EQ(model->mesh.triangles.size(), 12U);
  const Vec3f size = bounds_of(model->mesh).size();
  EXPECT_FLOAT_EQ(size.x, 0.2F);
  EXPECT_FLOAT_EQ(size.y, 0.3F);
  EXPECT_FLOAT_EQ(size.z, 0.1F);
  EXPECT_NEAR(volume_of(model->mesh), 0.006, 1e-8);
  EXPECT_TRUE(is_watertight(model->mesh));
  EXPECT_EQ(model->names, (std::vector<std::string>{"box", "Object"}));
  for (const Vec3f& n : model->mesh.normals)  // made with creases: along one axis each
    EXPECT_NEAR(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1, 1e-5);
}

TEST(Glb, NodesScaleTurnMoveAndMirror) {
  const std::string half = "0.70710678";
  const auto turned =
      io::parse_glb(box_glb(0.2F,
                            0.3F,
                            0.1F,
                            R"({"mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0, )" + half + ", " +
                                half + R"(], "translation": [1, 0, 0]})"),
                    "box.glb");
  ASSERT_TRUE(turned.ok()) << to_string(turned.error());
  const Bounds3 bounds = bounds_of(turned->mesh);  // y (0..0.6) turned to -x, then moved by 1
  EXPECT_NEAR(bounds.low.x, 0.4, 1e-5);
  EXPECT_NEAR(bounds.high.x, 1.0, 1e-5);
  EXPECT_NEAR(bounds.size().y, 0.4, 1e-5);
  const auto mirrored = io::parse_glb(
      box_glb(0.2F,
              0.3F,
              0.1F,
              R"({"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]})"),
      "box.glb");
  EXPECT_GT(volume_of(mirrored->mesh), 0);  // the outside stayed outside
  EXPECT_NEAR(bounds_of(mirrored->mesh).center().z, 5, 1e-5);
}

TEST(Glb, MaterialsAndPictures) {
  Image picture(2, 2);
  picture.pixels = {255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  const std::string png = io::encode_png(picture).value();
  std::string glb =
      box_glb(0.1F,
              0.1F,
              0.1F,
              R"({"mesh": 0})",
              R"(, "materials": [{"name": "Blue PET", "alphaMode": "BLEND", "pbrMetallicRoughness":
          {"baseColorFactor": [0.5, 0.25, 1, 0.5], "roughnessFactor": 0.125, "metallicFactor": 0,
           "baseColorTexture": {"index": 0}}}],
          "textures": [{"source": 0}], "images": [{"bufferView": 2, "mimeType": "image/png"}])",
              png);
  glb = with_json(glb, R"("indices": 1)", R"("indices": 1, "material": 0)");
  glb = with_json(glb,
                  R"("byteLength": 72})",
                  R"("byteLength": 72}, {"buffer": 0, "byteOffset": 168, "byteLength": )" +
                      std::to_string(png.size()) + "}");
  const auto model = io::parse_glb(glb, "box.glb");
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  const io::ModelMaterial& material = model->materials.at(model->mesh.surfaces.at(0));
  EXPECT_EQ(material.name, "Blue PET");
  EXPECT_FLOAT_EQ(material.color.y, 0.25F);
  EXPECT_FLOAT_EQ(material.roughness, 0.125F);
  EXPECT_TRUE(material.clear);
  ASSERT_EQ(material.picture, 0);
  EXPECT_EQ(model->pictures.at(0).pixels, picture.pixels);
}

TEST(Glb, ReadsWhatTinygltfWrites) {  // an outside writer, with normals, UVs and byte strides
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.buffers.resize(1);
  auto& bytes = model.buffers[0].data;
  const auto add = [&](const std::string& raw) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = raw.size();
    bytes.insert(bytes.end(), raw.begin(), raw.end());
    model.bufferViews.push_back(view);
  };
  add(raw_bytes<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}));  // p n p n p n
  add(raw_bytes<std::uint8_t>({0, 0, 255, 0, 0, 255, 0, 0}));                     // padded to 8
  model.bufferViews[0].byteStride = 24;
  const auto accessor = [&](int view, std::size_t offset, int component, int type, bool unit) {
    tinygltf::Accessor a;
    a.bufferView = view;
    a.byteOffset = offset;
    a.componentType = component;
    a.type = type;
    a.count = 3;
    a.normalized = unit;
    model.accessors.push_back(a);
  };
  accessor(0, 0, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, false);
  accessor(0, 12, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, false);
  accessor(1, 0, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_VEC2, true);
  tinygltf::Primitive primitive;
  primitive.attributes = {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}};
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.indices = -1;
  primitive.material = -1;
  tinygltf::Mesh mesh;
  mesh.primitives = {primitive};
  model.meshes = {mesh};
  tinygltf::Node node;
  node.mesh = 0;
  model.nodes = {node};
  tinygltf::Scene scene;
  scene.nodes = {0};
  model.scenes = {scene};
  model.defaultScene = 0;
  std::ostringstream out;
  ASSERT_TRUE(tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, false, true));

  const auto read = io::parse_glb(out.str(), "tiny.glb");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->mesh.positions.size(), 3U);
  EXPECT_EQ(read->mesh.positions[1], (Vec3f{1, 0, 0}));
  EXPECT_EQ(read->mesh.normals[2], (Vec3f{0, 0, 1}));
  EXPECT_EQ(read->mesh.uvs[1], (Vec2f{1, 0}));
}

TEST(Obj, BoxOfQuadsWithMaterialAndNegativeIndices) {
  const auto model = obj(
      "mtllib box.mtl\no Crate of apples\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\n"
      "v 1 1 1\nv 0 1 1\nvt 0 0\nusemtl wood\nf 4 3 2 1\nf 5/1 6/1 7/1 8/1\nf -8 -7 -3 -4\n"
      "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
      "newmtl wood\nKd 0.5 0.25 0.125\nPr 0.75\nPm 0\n");
  ASSERT_TRUE(model.ok()) << to_string(model.error());
  EXPECT_EQ(model->mesh.triangles.size(), 12U);
  EXPECT_NEAR(volume_of(model->mesh), 1, 1e-6);
  EXPECT_TRUE(is_watertight(model->mesh));
  EXPECT_EQ(model->names, std::vector<std::string>{"Crate of apples"});
  const io::ModelMaterial& material = model->materials.at(model->mesh.surfaces.at(0));
  EXPECT_EQ(material.name, "wood");
  EXPECT_FLOAT_EQ(material.color.z, 0.125F);
  EXPECT_FLOAT_EQ(material.roughness, 0.75F);
}

TEST(Obj, MissingLibraryIsARemark) {
  const auto model = obj("mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->remarks.size(), 1U);
  EXPECT_NE(model->remarks[0].find("gone.mtl"), std::string::npos);
}

// ---- What is refused. ----

TEST(Glb, BrokenFiles) {
  const std::string good = box_glb(0.1F, 0.1F, 0.1F);
  expect_refused(io::parse_glb("", "x"), "model.bad_file", "is not a GLB");
  expect_refused(io::parse_glb("solid cube\nfacet normal", "x"), "model.bad_file", "is not a GLB");
  expect_refused(io::parse_glb(good.substr(0, good.size() - 9), "x"), "model.bad_file", "cut off");
  expect_refused(io::parse_glb(changed(good, "{", "["), "x"), "model.bad_file", "not valid JSON");
  expect_refused(io::parse_glb(glb_bytes(std::string(100'000, '['), ""), "x"),
                 "model.bad_file",
                 "nests more than 64 deep");
  expect_refused(io::parse_glb(glb_bytes("{}", ""), "x"), "model.no_mesh", "no scene");
}

TEST(Glb, IndicesAndLengthsBeyondTheFile) {
  const std::string good = box_glb(0.1F, 0.1F, 0.1F);
  const auto refused = [&](const char* from, const char* to, const char* code, const char* says) {
    expect_refused(io::parse_glb(with_json(good, from, to), "x"), code, says);
  };
  refused(R"("count": 8)", R"("count": 9)", "model.bad_file", "beyond its buffer view");
  refused(R"("count": 8)", R"("count": 4000000000)", "input.too_large", "elements");
  refused(R"("count": 36)", R"("count": 37)", "model.bad_file", "beyond its buffer view");
  EXPECT_TRUE(io::parse_glb(with_json(good, R"("count": 36)", R"("count": 33)"), "x").ok());
}

TEST(Glb, HostileReferences) {
  const std::string good = box_glb(0.1F, 0.1F, 0.1F);
  const auto refused = [&](const char* from, const char* to, const char* code, const char* says) {
    expect_refused(io::parse_glb(with_json(good, from, to), "x"), code, says);
  };
  refused(R"("POSITION": 0)", R"("POSITION": 7)", "model.bad_file", "/accessors/7");
  refused(R"("POSITION": 0)", R"("POSITION": 1)", "model.bad_file", "expected type VEC3");
  refused(R"("byteLength": 96)", R"("byteLength": 4294967295)", "model.bad_file", "beyond");
  refused(R"("byteOffset": 96)", R"("byteOffset": 4294967295)", "model.bad_file", "beyond");
  refused(R"("nodes": [0])", R"("nodes": [0, 0])", "model.bad_file", "no tree");
  refused(R"("mesh": 0,)", R"("mesh": 0, "children": [0],)", "model.bad_file", "no tree");
  refused(R"("mesh": 0)", R"("mesh": 5)", "model.bad_file", "/meshes/5");
  refused(R"([{"byteLength": 168}])",
          R"([{"byteLength": 168, "uri": "/etc/passwd"}])",
          "input.outside_folder",
          "\"/etc/passwd\"");
  refused(R"("scene": 0)",
          R"("scene": 0, "extensionsRequired": ["KHR_draco_mesh_compression"])",
          "model.bad_file",
          "uncompressed");
}

TEST(Glb, NumbersThatAreNone) {
  std::string glb = box_glb(0.1F, 0.1F, 0.1F);
  const float nan = std::nanf("");
  std::uint32_t json_size = 0;
  std::memcpy(&json_size, glb.data() + 12, 4);
  std::memcpy(glb.data() + 20 + json_size + 8 + 12, &nan, 4);  // x of vertex 1
  expect_refused(io::parse_glb(glb, "x"), "model.bad_file", "vertex 1");
  const std::string far = R"({"mesh": 0, "scale": [1e30, 1, 1]})";
  expect_refused(io::parse_glb(box_glb(1, 1, 1, far), "x"), "model.bad_file", "must be a number");
}

TEST(Glb, NothingToSee) {
  const std::string flat = R"({"mesh": 0, "scale": [1, 0, 0]})";
  expect_refused(io::parse_glb(box_glb(1, 1, 1, flat), "x"), "model.no_mesh", "no triangles");
  const std::string lines =
      with_json(box_glb(1, 1, 1), R"("indices": 1)", R"("indices": 1, "mode": 1)");
  expect_refused(io::parse_glb(lines, "x"), "model.no_mesh", "no triangles");
}

TEST(Obj, BrokenLinesNameTheirPlace) {
  const auto refused = [](const std::string& text, const char* line, const char* says) {
    const auto read = obj(text);
    expect_refused(read, "model.bad_file", says);
    EXPECT_EQ(read.error().where, std::string("thing.obj:") + line);
  };
  refused("v 0 0\n", "1", "three numbers");
  refused("v 0 0 nan\n", "1", "must be a number");
  refused("v 0 0 1e300\n", "1", "must be a number");
  refused("v 0 0 0\nf 1 2 3\n", "2", "row 2 of 1");
  refused("v 0 0 0\nf -1 -2 -3\n", "2", "row -2 of 1");
  refused("v 0 0 0\nf 1/x 1 1\n", "2", "1/2/3");
  refused("v 0 0 0\nf 99999999999999999999 1 1\n", "2", "1/2/3");
  refused("v 0 0 0\nf //1 1 1\n", "2", "row 1 of 0");
  expect_refused(obj("# nothing\n"), "model.no_mesh", "no triangles");
}

TEST(ModelFile, CompanionsStayInTheFolder) {
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "models");
  std::ofstream(scratch.path() / "secret.mtl") << "newmtl a\n";
  std::ofstream(scratch.path() / "models/good.mtl") << "newmtl a\nKd 0 1 0\n";
  fs::create_symlink("../secret.mtl", scratch.path() / "models/link.mtl");
  const auto read = [&](const std::string& library) {
    std::ofstream(scratch.path() / "models/thing.obj")
        << "mtllib " + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    return io::read_model_file(scratch.path() / "models/thing.obj");
  };
  EXPECT_TRUE(read("good.mtl").ok());
  for (const char* library :
       {"../secret.mtl", "/etc/passwd", "link.mtl", ".", "a/../../secret.mtl"})
    expect_refused(read(library), "input.outside_folder", "not in the folder");
}

TEST(ModelFile, OtherEndingsAndHugeFiles) {
  const ScratchFolder scratch;
  expect_refused(io::read_model_file("/no/such.gltf"), "model.bad_file", "binary glTF");
  expect_refused(io::read_model_file("/no/such.fbx"), "model.bad_file", "neither .glb nor .obj");
  EXPECT_EQ(io::read_model_file("/no/such.glb").error().code, "input.not_found");
  const fs::path huge = scratch.path() / "huge.glb";
  std::ofstream(huge) << "glTF";
  fs::resize_file(huge, 10'000'000'000);  // sparse: takes no room
  expect_refused(io::read_model_file(huge), "input.too_large", "larger than");
}

TEST(ModelFile, FlippedBytesAreReadOrRefused) {  // never a crash; fuzz/ goes further
  const std::string good = box_glb(0.1F, 0.2F, 0.3F);
  std::mt19937 random(3);
  int read = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes = good;
    for (int flips = 0; flips < 3; ++flips)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    read += io::parse_glb(bytes, "x").ok() ? 1 : 0;
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, 2000);
}

}  // namespace
}  // namespace marketgen
