#include "export/usd_materials.h"

#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "export/material_pictures.h"

namespace marketgen::exporters {
namespace {

void write_picture(UsdText& out,
                   const std::string& path,
                   std::string_view name,
                   const std::string& file,
                   bool is_color,
                   bool tiled,
                   const std::vector<std::string>& more) {
  out.open(fmt::format("def Shader \"{}\"", name));
  out.line("uniform token info:id = \"UsdUVTexture\"");
  out.line("asset inputs:file = @./{}@", file);
  out.line("token inputs:sourceColorSpace = \"{}\"", is_color ? "sRGB" : "raw");
  out.line("float2 inputs:st.connect = <{}/st.outputs:result>", path);
  for (const char axis : {'S', 'T'})
    out.line("token inputs:wrap{} = \"{}\"", axis, tiled ? "repeat" : "clamp");
  for (const std::string& line : more)
    out.line("{}", line);
  out.close();
}

std::string color_value(Vec3f c) {
  return fmt::format("({}, {}, {})", c.x, c.y, c.z);
}

// MuJoCo takes the greater friction of the two in contact, and so does PhysX when it is told to.
void write_contact_material(UsdText& out, double friction) {
  const auto value = static_cast<float>(friction);
  out.open("def Material \"contact\"",
           {"prepend apiSchemas = [\"PhysicsMaterialAPI\", \"PhysxMaterialAPI\"]"});
  out.line("float physics:dynamicFriction = {}", value);
  out.line("float physics:restitution = 0");
  out.line("float physics:staticFriction = {}", value);
  out.line("uniform token physxMaterial:frictionCombineMode = \"max\"");
  out.close();
}

}  // namespace

std::string UsdPictures::add(const std::string& name, std::string_view ending, std::string bytes) {
  files_.push_back({usd_identifier(name) + std::string(ending), std::move(bytes)});
  return files_.back().name;
}

const UsdPictures::Tiled& UsdPictures::tiled(const catalog::MaterialRow& material) {
  const auto [entry, is_new] = tiled_.try_emplace(material.id);
  if (!is_new) return entry->second;
  const std::string stem = usd_identifier("material_" + material.id);
  entry->second = {stem + "_color.jpg",
                   stem + "_normal.jpg",
                   stem + "_gloss.png",
                   static_cast<float>(1 - material.transmission)};
  materials_.push_back(material);
  return entry->second;
}

Result<std::vector<BesideFile>> UsdPictures::take() {
  auto drawn = parallel_map(materials_.size(), [&](std::size_t i) {
    return std::optional(material_pictures(materials_[i], MaterialCoding::jpeg));
  });
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    MARKETGEN_TRY(MaterialPictures made, *std::move(drawn[i]));
    const Tiled& named = tiled_.at(materials_[i].id);
    files_.push_back({named.color, std::move(made.color)});
    files_.push_back({named.normal, std::move(made.normal)});
    files_.push_back({named.gloss, std::move(made.gloss)});
  }
  return std::move(files_);
}

int UsdLooks::add(const assets::Surface& surface, const std::string& picture) {
  Row row;
  row.roughness = surface.roughness;
  row.metallic = surface.metallic;
  row.color = picture;
  if (surface.kind == assets::SurfaceKind::emissive)
    row.emissive = surface.color;
  else {
    const auto share = [](float v) { return std::clamp(v, 0.0F, 1.0F); };
    row.diffuse = {share(surface.color.x), share(surface.color.y), share(surface.color.z)};
    if (surface.kind == assets::SurfaceKind::glass) row.opacity = glass_alpha;
  }
  return add_row(std::move(row));
}

Result<int> UsdLooks::add_tiled(const std::string& id) {
  const catalog::MaterialRow* material = scene_material(pictures_.scene(), id);
  return material == nullptr ? add(plain_plaster()) : add_tiled(*material);
}

Result<int> UsdLooks::add_tiled(const catalog::MaterialRow& material) {
  const UsdPictures::Tiled& tiled = pictures_.tiled(material);
  Row row;
  row.diffuse = {1, 1, 1};
  row.opacity = tiled.opacity;
  row.color = tiled.color;
  row.normal = tiled.normal;
  row.gloss = tiled.gloss;
  row.tiled = true;
  return add_row(std::move(row));
}

int UsdLooks::add_row(Row row) {
  const auto known = std::ranges::find(rows_, row);
  const auto index = static_cast<int>(known - rows_.begin());
  if (known == rows_.end()) rows_.push_back(std::move(row));
  return index;
}

void UsdLooks::write(UsdText& out, std::string_view path) const {
  out.open("def Scope \"materials\"");
  write_looks(out, path);
  out.close();
}

void UsdLooks::write(UsdText& out, std::string_view path, double friction) const {
  out.open("def Scope \"materials\"");
  write_looks(out, path);
  write_contact_material(out, friction);
  out.close();
}

void UsdLooks::write_looks(UsdText& out, std::string_view path) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::string name = fmt::format("look_{}", i);
    out.open(fmt::format("def Material \"{}\"", name));
    write_look(out, fmt::format("{}/materials/{}", path, name), rows_[i]);
    out.close();
  }
}

void UsdLooks::write_look(UsdText& out, const std::string& path, const Row& row) {
  out.line("token outputs:surface.connect = <{}/surface.outputs:surface>", path);
  out.open("def Shader \"surface\"");
  out.line("uniform token info:id = \"UsdPreviewSurface\"");
  if (row.color.empty())
    out.line("color3f inputs:diffuseColor = {}", color_value(row.diffuse));
  else
    out.line("color3f inputs:diffuseColor.connect = <{}/color.outputs:rgb>", path);
  if (row.emissive != Vec3f{})
    out.line("color3f inputs:emissiveColor = {}", color_value(row.emissive));
  if (row.gloss.empty()) {
    out.line("float inputs:metallic = {}", row.metallic);
    out.line("float inputs:roughness = {}", row.roughness);
  } else {
    out.line("float inputs:metallic.connect = <{}/gloss.outputs:b>", path);
    out.line("float inputs:roughness.connect = <{}/gloss.outputs:g>", path);
  }
  if (!row.normal.empty())
    out.line("normal3f inputs:normal.connect = <{}/normal.outputs:rgb>", path);
  if (row.opacity < 1) out.line("float inputs:opacity = {}", row.opacity);
  out.line("token outputs:surface");
  out.close();
  if (row.color.empty()) return;
  out.open("def Shader \"st\"");
  out.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
  out.line("string inputs:varname = \"st\"");
  out.line("float2 outputs:result");
  out.close();
  const std::string scale = fmt::format(
      "float4 inputs:scale = ({}, {}, {}, 1)", row.diffuse.x, row.diffuse.y, row.diffuse.z);
  write_picture(out, path, "color", row.color, true, row.tiled, {scale, "float3 outputs:rgb"});
  if (!row.gloss.empty())
    write_picture(
        out, path, "gloss", row.gloss, false, true, {"float outputs:b", "float outputs:g"});
  if (!row.normal.empty())
    write_picture(out,
                  path,
                  "normal",
                  row.normal,
                  false,
                  true,
                  {"float4 inputs:bias = (-1, -1, -1, 0)",
                   "float4 inputs:scale = (2, 2, 2, 1)",
                   "float3 outputs:rgb"});
}

void UsdLooks::write_bindings(UsdText& out,
                              std::string_view path,
                              const UsdShape& shape,
                              const std::vector<int>& looks) {
  for (const UsdShape::Part& part : shape.parts) {
    out.open(fmt::format("over \"{}\"", part.name),
             {"prepend apiSchemas = [\"MaterialBindingAPI\"]"});
    out.line("rel material:binding = <{}/materials/look_{}>", path, looks[part.surface]);
    out.close();
  }
}

std::string usd_contact_material(std::string_view path) {
  return fmt::format("{}/materials/contact", path);
}

}  // namespace marketgen::exporters
