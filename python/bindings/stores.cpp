#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <optional>

#include "assets/usable_catalog.h"
#include "audit/compliance.h"
#include "binding.h"
#include "environments/store_assortment.h"
#include "environments/store_shopping.h"
#include "intake/brief.h"
#include "intake/conflicts.h"
#include "intake/drawn_shell.h"
#include "io/file.h"
#include "io/json.h"
#include "io/png.h"
#include "layout/layout_picture.h"
#include "physics/settle/let_go.h"
#include "plan/patch.h"
#include "planners/make_planner.h"
#include "render/cameras/camera.h"
#include "scene/query.h"
#include "store/edit.h"
#include "store/edit_words.h"
#include "store/open_stores.h"
#include "store/planogram.h"
#include "store_handle.h"
#include "told_progress.h"

namespace marketgen::python {
namespace {

StoreHandle opened(const std::string& folder, catalog::Catalog catalog) {
  store::Store store =
      value_or_raise(without_interpreter([&] { return store::open_store(folder, catalog); }));
  return {std::make_shared<const store::Store>(std::move(store)),
          std::make_shared<const catalog::Catalog>(std::move(catalog))};
}

StoreHandle open(const std::string& folder, const std::vector<std::string>& catalogs) {
  return opened(folder, value_or_raise(assets::usable_catalog({catalogs.begin(), catalogs.end()})));
}

// How a language model is reached, and what it may cost.
planners::PlannerAccess planner_access(
    const std::string& url,
    const std::string& record,
    std::int64_t max_tokens,
    double max_seconds,
    const std::optional<double>& max_usd,
    const std::optional<std::array<double, 2>>& usd_per_million) {
  return {url, record, {max_tokens, max_seconds, max_usd, usd_per_million}};
}

// The keyword arguments of marketgen.generate().
StoreHandle generate(const std::string& prompt,
                     const std::string& folder,
                     std::uint64_t seed,
                     const std::string& size,
                     const std::optional<std::string>& profile,
                     const std::optional<std::string>& style,
                     const std::optional<std::string>& country,
                     const std::optional<std::string>& time,
                     const std::vector<std::string>& vary,
                     const std::optional<std::string>& plan,
                     const std::optional<std::string>& planogram,
                     const std::optional<std::string>& floor_plan,
                     const std::optional<std::string>& floor_plan_scale,
                     const std::vector<std::string>& images,
                     const std::string& planner,
                     const planners::PlannerAccess& access,
                     const std::vector<std::string>& catalogs,
                     bool previews,
                     bool strict,
                     const Callable& progress) {
  store::CreateOptions options;
  options.folder = folder;
  options.seed = seed;
  options.previews = previews;
  options.strict = strict;
  options.brief.prompt = prompt;
  options.brief.planner = planner;
  options.planner = access;
  options.brief.profile = profile;
  options.brief.style = style;
  options.brief.country = country;
  options.brief.time = time;
  for (const std::string& axis : vary) {
    if (!options.brief.vary) options.brief.vary.emplace();
    check_or_raise(plan::add_vary(*options.brief.vary, axis, "brief.bad_vary", "vary"));
  }
  options.brief.floor_plan = floor_plan;
  options.brief.floor_plan_scale = floor_plan_scale;
  options.brief.image_files = images;
  if (plan) options.plan_file = *plan;
  if (planogram) options.planogram_file = *planogram;
  if (!size.empty()) options.brief.size_mm = value_or_raise(intake::parse_size(size, "size"));
  catalog::Catalog catalog =
      value_or_raise(assets::usable_catalog({catalogs.begin(), catalogs.end()}));
  intake::Drawn drawn = value_or_raise(intake::with_drawing(options.brief, catalog));
  options.brief = std::move(drawn.brief);
  for (const std::string& warning : drawn.warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) < 0) throw nb::python_error();
  }
  value_or_raise(telling(
      progress, [&](Progress& told) { return store::create_store(options, catalog, told); }));
  return opened(folder, std::move(catalog));
}

// What Store.patches() and Store.edit() have of words: (market-patch/1, not understood, so already,
// given up: (what, for what, why, whether the words contradict themselves)).
nb::tuple said(const StoreHandle& handle, const std::string& words) {
  const store::SaidPatches said = value_or_raise(without_interpreter(
      [&] { return store::patches_of_words(*handle.store, words, *handle.catalog); }));
  std::vector<std::string> unparsed;
  for (const intake::UnparsedWord& word : said.unparsed)
    unparsed.push_back(word.text);
  nb::list given_up;
  for (const intake::Conflict& conflict : said.conflicts)
    given_up.append(nb::make_tuple(
        conflict.dropped, conflict.kept, conflict.why, intake::is_contradiction(conflict)));
  return nb::make_tuple(io::write_json(said.patches), unparsed, said.so_already, given_up);
}

scene::PlanogramFile planogram_of(const StoreHandle& handle, const std::string& file) {
  scene::PlanogramFile planogram =
      value_or_raise(store::read_planogram_file(file, *handle.store, *handle.catalog));
  if (!planogram.refused.empty()) raise(scene::refusal_of(planogram.refused));
  return planogram;
}

// What Store.edit() has of a planogram: market-patch/1, with no patches when all stands so.
std::string planogram_patches(const StoreHandle& handle, const std::string& file) {
  const scene::PlanogramFile planogram = planogram_of(handle, file);
  return io::write_json(
      scene::changes_by(planogram, handle.store->scene, handle.store->plan, *handle.catalog)
          .patches);
}

std::string compliance(const StoreHandle& handle, const std::string& file) {
  const scene::PlanogramFile planogram = planogram_of(handle, file);
  return io::write_json(audit::compliance_of(handle.store->scene, planogram, *handle.catalog));
}

// The edited store, and the wishes of its prompt that are no longer met.
nb::tuple edit(const StoreHandle& handle,
               const std::string& patches,
               const std::string& words,
               const std::optional<std::string>& folder,
               bool previews,
               const Callable& progress) {
  store::EditOptions options;
  options.folder =
      folder ? std::filesystem::path(*folder) : store::next_edit_folder(handle.store->folder);
  options.step.patches = value_or_raise(plan::read_patches(patches, "patches"));
  options.step.source = words.empty() ? "patches" : "say";
  options.step.words = words;
  options.previews = previews;
  const store::Edited edited = value_or_raise(telling(progress, [&](Progress& told) {
    return store::edit_store(*handle.store, options, *handle.catalog, told);
  }));
  return nb::make_tuple(opened(options.folder.string(), *handle.catalog), edited.lost);
}

// market-shopping/1. The store's own products are known, whatever it was opened with.
std::string shop(const StoreHandle& handle,
                 const std::string& request,
                 const std::vector<std::string>& sold_out,
                 const std::string& planner,
                 const planners::PlannerAccess& access) {
  return io::write_json(value_or_raise(without_interpreter([&] {
    const store::OpenedStores opened = store::opened_stores({handle.store}, *handle.catalog);
    return environments::shop(request,
                              environments::assortment_of(handle.store->scene, sold_out),
                              opened.catalog,
                              {planner, access});
  })));
}

// row, id, pose (x, y, z, qw, qx, qy, qz) and whether it rests, of each product.
using SettledRow = std::tuple<std::uint32_t, std::string, std::array<double, 7>, bool>;
std::vector<SettledRow> settle(const StoreHandle& handle,
                               const std::array<double, 4>& region_m,
                               double seconds,
                               double lift_m,
                               bool soft,
                               const Callable& progress) {
  const scene::Scene& scene = handle.store->scene;
  const physics::LetGoOptions options{region_m, seconds, lift_m, soft, handle.catalog->frictions};
  const auto ends = value_or_raise(
      telling(progress, [&](Progress& told) { return physics::let_go(scene, options, told); }));
  std::vector<SettledRow> rows;
  for (const physics::LetGoProduct& end : ends) {
    const auto& [p, q] = end.world_from_product;
    rows.emplace_back(end.product,
                      scene::product_id(scene, end.product),
                      std::array{p.x, p.y, p.z, q.w, q.x, q.y, q.z},
                      end.rests);
  }
  return rows;
}

std::vector<std::string> camera_names(const StoreHandle& handle) {
  std::vector<std::string> names;
  for (const render::Camera& camera : render::standard_cameras(handle.store->scene, 16, 9))
    names.push_back(camera.name);
  return names;
}

nb::bytes layout_png(const StoreHandle& handle) {
  const std::string png = value_or_raise(without_interpreter([&] {
    return io::encode_png(layout::draw_layout(handle.store->scene.layout, *handle.catalog));
  }));
  return nb::bytes(png.data(), png.size());
}

}  // namespace

void add_stores(nb::module_& module) {
  nb::class_<StoreHandle>(module, "Store")
      .def_prop_ro("folder", [](const StoreHandle& h) { return h.store->folder.string(); })
      .def("_manifest", [](const StoreHandle& h) { return io::write_json(h.store->manifest); })
      .def("_plan", [](const StoreHandle& h) { return io::write_json(h.store->plan); })
      .def("_layout", [](const StoreHandle& h) { return io::write_json(h.store->scene.layout); })
      .def("_layout_png", &layout_png)
      .def("_report",
           [](const StoreHandle& h) {
             return io::write_json(value_or_raise(store::read_report(h.store->folder)));
           })
      .def(
          "_query",
          [](const StoreHandle& h, const std::string& table, const std::string& where) {
            return scene::to_json(value_or_raise(scene::query_scene(h.store->scene, table, where)));
          })
      .def("_said", &said)
      .def("_planogram_patches", &planogram_patches)
      .def("_compliance", &compliance)
      .def("_edit", &edit)
      .def("_shop", &shop)
      .def("_settle", &settle)
      .def("camera_names", &camera_names)
      .def("camera", [](const StoreHandle& h, const std::string& name, int width, int height) {
        return value_or_raise(render::camera_named(h.store->scene, name, width, height));
      });
  module.def("cache_folder", [] { return io::cache_folder().string(); });
  module.def("open_store", &open);
  const nb::class_<planners::PlannerAccess> access(module, "PlannerAccess");
  module.def("planner_access", &planner_access);
  module.def("generate", &generate);
}

}  // namespace marketgen::python
