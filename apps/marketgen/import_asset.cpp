#include "import_asset.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "assets/import/import_asset.h"
#include "assets/import/import_pictures.h"
#include "assets/import/vlm_annotator.h"
#include "base/text.h"
#include "catalog/asset_database.h"
#include "io/field_check.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "llm/language_model.h"
#include "named_flag.h"
#include "number_flags.h"
#include "say.h"

namespace marketgen::app {
namespace {

namespace fs = std::filesystem;

bool has_faces(const ImportFlags& flags) {
  return std::ranges::any_of(flags.faces, [](const std::string& file) { return !file.empty(); });
}

assets::StatedRow stated(const ImportFlags& flags) {
  assets::StatedRow row{flags.name, flags.category, flags.subcategory, flags.material, {}};
  if (flags.mass_kg > 0) row.mass_kg = flags.mass_kg;
  return row;
}

// "66x66x115": width, depth, height.
Result<std::array<int, 3>> size_of_flag(const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  std::array<int, 3> size_mm{};
  bool good = parts.size() == size_mm.size();
  for (std::size_t i = 0; good && i < size_mm.size(); ++i) {
    const std::string_view digits = trimmed(parts[i]);
    const auto [end, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), size_mm[i]);
    good = fault == std::errc() && end == digits.data() + digits.size() &&
           !io::fault_of_field<catalog::Product>("size_mm", size_mm[i]);
  }
  if (good) return size_mm;
  return Error{"usage.bad_flag",
               "--size-mm",
               fmt::format("\"{}\" is no size of a pack; write width x depth x height in whole "
                           "millimetres, each 5 to 1500: 66x66x115",
                           text)};
}

// What `import` gives by the annotator that the flags name.
template <class Import>
auto annotated(const ImportFlags& flags, const catalog::Catalog& catalog, Import import)
    -> decltype(import(assets::AssetAnnotator())) {
  if (!flags.vlm.empty()) {
    const llm::ModelChoice choice{.model = flags.vlm,
                                  .url = flags.vlm_url,
                                  .record = flags.vlm_record,
                                  .replay = flags.vlm_replay};
    MARKETGEN_TRY(llm::LanguageModel model, llm::open_language_model(choice));
    return import(assets::vlm_annotator(catalog, std::move(model)));
  }
  MARKETGEN_TRY(const catalog::AssetDatabase database, catalog::AssetDatabase::open(catalog));
  return import(assets::offline_annotator(catalog, database));
}

void print_shape(const catalog::AssetFile& asset) {
  if (!asset.product.faces) {
    say("mesh        {} triangles, {}; {} contact pieces by {}\n",
        asset.source.triangles,
        asset.source.watertight ? "closed" : "not closed",
        asset.estimates.pieces,
        asset.estimates.contact_from);
    return;
  }
  std::string files;
  for (const catalog::FaceSlot& slot : catalog::face_slots) {
    const std::string& file = (*asset.product.faces).*slot.file;
    if (!file.empty()) files += (files.empty() ? "" : ", ") + file;
  }
  say("shape       {} with {}\n", asset.product.archetype, files);
}

void print_import(const catalog::AssetFile& asset, const fs::path& folder) {
  const catalog::Product& p = asset.product;
  say("asset       {}  \"{}\"\n", p.sku, p.name);
  say("taken for   {} / {}, {} ({:.0f} % sure, {})\n",
      p.category,
      p.subcategory,
      p.material,
      100 * asset.annotation.confidence,
      asset.annotation.annotator);
  say("size        {} x {} x {} mm, {:.3f} kg: {}\n",
      p.size_mm[0],
      p.size_mm[1],
      p.size_mm[2],
      p.mass_kg,
      asset.estimates.mass_from);
  print_shape(asset);
  for (const std::string& note : asset.notes)
    say("note        {}\n", note);
  say("use it      marketgen generate ... --catalog {}\n", (folder / "asset.json").string());
}

// Writes the asset, of either kind, and says what it is.
template <class Asset>
Result<void> put_asset(const Asset& asset, const ImportFlags& flags, const CommonFlags& common) {
  const fs::path folder =
      flags.folder.empty() ? fs::path("assets") / asset.file.product.sku : fs::path(flags.folder);
  MARKETGEN_CHECK(assets::write_asset(asset, folder));
  if (common.json)
    fmt::print("{}", io::write_json(asset.file));
  else
    print_import(asset.file, folder);
  return {};
}

Result<void> import_model(const ImportFlags& flags,
                          const catalog::Catalog& catalog,
                          const CommonFlags& common) {
  assets::ImportOptions options;
  MARKETGEN_TRY(options.unit,
                value_of_flag<catalog::LengthUnit>("--unit", "there is no unit", flags.unit));
  MARKETGEN_TRY(options.up, value_of_flag<assets::UpAxis>("--up", "there is no axis", flags.up));
  options.row = stated(flags);
  options.coacd = flags.coacd;
  MARKETGEN_TRY(const assets::ImportedAsset asset,
                annotated(flags, catalog, [&](const assets::AssetAnnotator& annotator) {
                  return assets::import_asset(flags.model, options, catalog, annotator);
                }));
  return put_asset(asset, flags, common);
}

Result<void> import_faces(const ImportFlags& flags,
                          const catalog::Catalog& catalog,
                          const CommonFlags& common) {
  assets::PictureImport import;
  for (std::size_t i = 0; i < flags.faces.size(); ++i) {
    if (!flags.faces[i].empty())
      import.pictures.push_back({std::string(catalog::face_slots[i].name), flags.faces[i]});
  }
  import.archetype = flags.archetype;
  MARKETGEN_TRY(import.size_mm, size_of_flag(flags.size_mm));
  import.row = stated(flags);
  MARKETGEN_TRY(const assets::PicturedAsset asset,
                annotated(flags, catalog, [&](const assets::AssetAnnotator& annotator) {
                  return assets::import_pictures(import, catalog, annotator);
                }));
  return put_asset(asset, flags, common);
}

// What is imported: one of the two, with what belongs to it.
Result<void> check_subject(const ImportFlags& flags) {
  const bool faces = has_faces(flags);
  if (faces && !flags.model.empty())
    return Error{"usage.bad_flag",
                 flags.model,
                 "a model has pictures of its own: give it, or pictures of a pack's sides"};
  if (!faces && flags.model.empty())
    return Error{"usage.bad_flag",
                 "model",
                 "name a GLB or OBJ file, or pictures of a pack's sides: --front FILE"};
  for (const auto& [flag, value] :
       {std::pair{"--archetype", &flags.archetype}, std::pair{"--size-mm", &flags.size_mm}}) {
    if (faces == value->empty())
      return Error{"usage.bad_flag",
                   flag,
                   faces ? "is needed with pictures of a pack's sides"
                         : "is for pictures of a pack's sides only"};
  }
  return {};
}

void add_face_flags(CLI::App& sub, ImportFlags& flags) {
  for (std::size_t i = 0; i < flags.faces.size(); ++i) {
    const std::string side(catalog::face_slots[i].name);
    sub.add_option("--" + side,
                   flags.faces[i],
                   side == "wrap" ? "PNG or JPEG: the unrolled label of a round pack"
                                  : "PNG or JPEG: the " + side + " of a pack, cropped to it")
        ->type_name("FILE");
  }
  sub.add_option("--archetype", flags.archetype, "container shape of a pack given by pictures")
      ->type_name("SHAPE");
  sub.add_option("--size-mm", flags.size_mm, "its width x depth x height, e.g. 66x66x115")
      ->type_name("SIZE");
}

void add_vlm(CLI::App& sub, ImportFlags& flags) {
  CLI::Option* model =
      sub.add_option("--vlm",
                     flags.vlm,
                     "PROVIDER:MODEL that says what it is (" + llm::provider_names() +
                         "); the key comes from the environment. Default: offline")
          ->type_name("MODEL");
  sub.add_option("--vlm-url", flags.vlm_url, "base URL of another server of that kind")
      ->type_name("URL")
      ->needs(model);
  CLI::Option* record =
      add_output(sub, "--vlm-record", flags.vlm_record, "folder to keep the exchange in")
          ->needs(model);
  sub.add_option("--vlm-replay", flags.vlm_replay, "answer from that folder; nothing is sent")
      ->type_name("FOLDER")
      ->needs(model)
      ->excludes(record);
}

}  // namespace

Result<void> probe_import(const ImportFlags& flags) {
  MARKETGEN_CHECK(check_subject(flags));
  io::Outputs record;
  if (!flags.vlm_record.empty()) MARKETGEN_CHECK(record.add_folder(flags.vlm_record));
  if (flags.folder.empty()) return {};
  const Result<io::FolderDraft> draft = io::FolderDraft::begin(flags.folder);
  return draft.ok() ? Result<void>{} : draft.error();
}

Result<void> import_one(const ImportFlags& flags,
                        const catalog::Catalog& catalog,
                        const CommonFlags& common) {
  return has_faces(flags) ? import_faces(flags, catalog, common)
                          : import_model(flags, catalog, common);
}

void add_import_flags(CLI::App& sub, ImportFlags& flags) {
  CLI::Option* model = sub.add_option("model", flags.model, "GLB or OBJ file")->type_name("FILE");
  add_output(sub, "-o,--output", flags.folder, "new folder; default assets/<sku>");
  sub.add_option("--unit", flags.unit, "length unit of the file")
      ->type_name(choice_of(names_of(catalog::LengthUnit{})))
      ->capture_default_str()
      ->needs(model);
  sub.add_option("--up", flags.up, "its axis that points up")
      ->type_name(choice_of(names_of(assets::UpAxis{})))
      ->capture_default_str()
      ->needs(model);
  sub.add_flag("!--no-coacd", flags.coacd, "one hull as contact shape, without CoACD")
      ->needs(model);
  add_face_flags(sub, flags);
  sub.add_option("--name", flags.name, "what it is");
  sub.add_option("--category", flags.category, "category id")->type_name("CATEGORY");
  sub.add_option("--subcategory", flags.subcategory, "shelf group");
  sub.add_option("--material", flags.material, "contact material")->type_name("MATERIAL");
  sub.add_option("--mass-kg", flags.mass_kg, "gross mass; estimated otherwise")
      ->check(real_number(1e-6, 1e4));
  add_vlm(sub, flags);
}

}  // namespace marketgen::app
