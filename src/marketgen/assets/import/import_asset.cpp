#include "assets/import/import_asset.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "assets/import/asset_row.h"
#include "assets/import/model_look.h"
#include "assets/shapes/convex_worker.h"
#include "assets/shapes/outer_hull.h"
#include "geometry/convex_hull.h"
#include "io/file.h"
#include "io/json.h"
#include "io/model_glb.h"

namespace marketgen::assets {
namespace fs = std::filesystem;
namespace {

constexpr double min_m = 0.005, max_m = 1.5;  // of a side, as product rows allow
constexpr std::string_view model_name = "model.glb";

bool plausible(Vec3f size, double factor) {
  for (const float side : {size.x, size.y, size.z}) {
    if (side * factor < min_m || side * factor > max_m) return false;
  }
  return true;
}

// The scale error, with the unit that would make a pack of it: the one whose longest side is
// nearest to an ordinary pack's.
Error bad_scale(const fs::path& file, Vec3f size, catalog::LengthUnit given) {
  constexpr double ordinary_m = 0.2;
  std::string remedy = "give a model whose sides are 5 mm to 1.5 m";
  double nearest = 1e9;
  for (const std::string_view name : catalog::names_of(catalog::LengthUnit{})) {
    const catalog::LengthUnit unit = *value_named<catalog::LengthUnit>(name);
    const double factor = catalog::metres_in(unit) / catalog::metres_in(given);
    const double away =
        std::abs(std::log(std::max({size.x, size.y, size.z}) * factor / ordinary_m));
    if (unit == given || !plausible(size, factor) || away >= nearest) continue;
    nearest = away;
    remedy = fmt::format("it looks as if it was made in {}: run again with --unit {}", name, name);
  }
  return {"model.bad_scale",
          file.string(),
          fmt::format("is {:.4g} x {:.4g} x {:.4g} m as read in {}; {}",
                      size.x,
                      size.z,
                      size.y,
                      name_of(given),
                      remedy)};
}

void turn_up(io::OutsideModel& model) {  // Z up, front -Y: to Y up, front +Z
  for (std::vector<Vec3f>* list : {&model.mesh.positions, &model.mesh.normals}) {
    for (Vec3f& v : *list)
      v = {v.x, v.z, -v.y};
  }
}

// One import on its way.
class Importer {
 public:
  Importer(fs::path file, const ImportOptions& options, const catalog::Catalog& catalog)
      : file_(std::move(file)), options_(options), catalog_(catalog) {}

  Result<ImportedAsset> run(const AssetAnnotator& annotator) {
    MARKETGEN_CHECK(check_stated(options_.row));
    MARKETGEN_CHECK(read());
    MARKETGEN_CHECK(annotate(annotator));
    MARKETGEN_CHECK(make_row());
    MARKETGEN_CHECK(catalog::fit_model(model_, row().size_mm, file_.string()));
    MARKETGEN_CHECK(make_pieces());
    estimate();
    asset_.file.product.mesh = model_name;
    MARKETGEN_CHECK(check_asset(asset_.file, catalog_));
    MARKETGEN_TRY(asset_.model, io::encode_glb(model_, row().sku));
    return std::move(asset_);
  }

 private:
  catalog::Product& row() { return asset_.file.product; }
  void note(std::string text) { asset_.file.notes.push_back(std::move(text)); }

  Result<void> read() {
    MARKETGEN_TRY(model_, io::read_model_file(file_));
    if (options_.up == UpAxis::z) turn_up(model_);
    catalog::scale_model(model_, catalog::metres_in(options_.unit));
    const Vec3f size = marketgen::bounds_of(model_.mesh).size();
    if (!plausible(size, 1)) return bad_scale(file_, size, options_.unit);
    io::merge_pictures(model_);
    catalog::AssetSource& source = asset_.file.source;
    source.file = file_.filename().string();
    MARKETGEN_TRY(source.sha256, io::sha256_of_file(file_));
    source.unit = options_.unit;
    source.triangles = static_cast<int>(model_.mesh.triangles.size());
    MARKETGEN_TRY(source.open_edges, open_edges_of(model_.mesh, file_.string()));
    source.watertight = source.open_edges == 0 && marketgen::volume_of(model_.mesh) > 0;
    source.parts = model_.names;
    for (const io::ModelMaterial& material : model_.materials) {
      if (!material.name.empty()) source.parts.push_back(material.name);
    }
    asset_.file.notes = model_.remarks;
    if (!source.watertight)
      note(
          fmt::format("the mesh is not closed ({} open edges): mass, inertia and contact are "
                      "those of its hull",
                      source.open_edges));
    return {};
  }

  Result<void> annotate(const AssetAnnotator& annotator) {
    asset_.file.look = look_of(model_);
    const Vec3f size = marketgen::bounds_of(model_.mesh).size();
    AssetEvidence evidence;
    evidence.file_name = asset_.file.source.file;
    evidence.parts = asset_.file.source.parts;
    evidence.size_mm = size_in_mm(size);
    evidence.look = asset_.file.look;
    evidence.pictures = &model_.pictures;
    MARKETGEN_TRY(asset_.file.annotation, annotator(evidence));
    return {};
  }

  static std::array<int, 3> size_in_mm(Vec3f size) {
    const auto mm = [](float v) { return static_cast<int>(std::lround(1000 * v)); };
    return {mm(size.x), mm(size.z), mm(size.y)};
  }

  // The row, as far as it does not depend on the volume.
  Result<void> make_row() {
    row().archetype = catalog::mesh_archetype;
    row().size_mm = size_in_mm(marketgen::bounds_of(model_.mesh).size());
    return name_row(
        asset_.file, options_.row, asset_.file.annotation.archetype, catalog_, file_.string());
  }

  // Contact pieces into the model, in its frame: by CoACD, else one hull.
  Result<void> make_pieces() {
    catalog::AssetEstimates& estimates = asset_.file.estimates;
    hull_ = outer_hull(model_.mesh.positions);
    if (hull_.triangles.empty())
      return Error{"model.bad_file", file_.string(), "is flat: it encloses no volume"};
    model_.pieces.clear();
    if (options_.coacd) {
      Result<std::vector<std::vector<Vec3f>>> pieces = convex_pieces(model_.mesh);
      if (pieces.ok()) {
        model_.pieces = std::move(pieces).value();
        estimates.contact_from = "coacd";
      } else {
        note("CoACD was not used: " + to_string(pieces.error()));
      }
    }
    if (model_.pieces.empty()) {
      model_.pieces = {hull_.positions};
      estimates.contact_from = "hull";
    }
    estimates.pieces = static_cast<int>(model_.pieces.size());
    for (const std::vector<Vec3f>& piece : model_.pieces)
      estimates.pieces_volume_m3 += convex_hull(piece).volume;
    return {};
  }

  void estimate() {
    const double volume_m3 = asset_.file.source.watertight ? marketgen::volume_of(model_.mesh)
                                                           : marketgen::volume_of(hull_);
    estimate_row(asset_.file, options_.row, volume_m3, catalog_);
  }

  fs::path file_;
  const ImportOptions& options_;
  const catalog::Catalog& catalog_;
  io::OutsideModel model_;  // glTF frame, metres
  Mesh hull_;               // of the whole model
  ImportedAsset asset_;
};

}  // namespace

Result<ImportedAsset> import_asset(const fs::path& file,
                                   const ImportOptions& options,
                                   const catalog::Catalog& catalog,
                                   const AssetAnnotator& annotator) {
  return Importer(file, options, catalog).run(annotator);
}

Result<void> write_asset(const ImportedAsset& asset, const fs::path& folder) {
  MARKETGEN_TRY(io::FolderDraft draft, io::FolderDraft::begin(folder));
  MARKETGEN_CHECK(io::write_file(draft.folder() / model_name, asset.model));
  MARKETGEN_CHECK(io::write_file(draft.folder() / asset_file_name, io::write_json(asset.file)));
  return draft.commit();
}

}  // namespace marketgen::assets
