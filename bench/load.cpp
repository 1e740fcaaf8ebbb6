#include "bench/bench.h"
#include "bench/sample_store.h"
#include "io/file.h"
#include "io/json.h"
#include "scene/scene_file.h"

namespace marketgen::bench {

Figures run_load(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const store::Created created,
                store::create_store(large_store(scratch / "store"), catalog));
  const std::filesystem::path file = scratch / "store" / "scene.bin";
  MARKETGEN_TRY(const scene::Scene scene, scene::open_scene(file));
  const std::filesystem::path json_file = scratch / "scene.json";
  MARKETGEN_CHECK(io::write_file(json_file, io::write_json_line(scene)));

  constexpr int runs = 9;
  const double ours = median_seconds(runs, [&] { (void)scene::open_scene(file).ok(); });
  const double json = median_seconds(3, [&] {
    const auto text = io::read_file(json_file);
    scene::Scene read;
    if (text.ok())
      (void)io::read_json_into(*text, "scene.json", type_of<scene::Scene>(), &read).ok();
  });
  const std::string machine = machine_name();
  return std::vector<Figure>{{"load_40x25m_s",
                              ours,
                              "s",
                              runs,
                              "the same scene as JSON, nlohmann 3.11",
                              ours / json,
                              machine},
                             {"load_40x25m_products",
                              static_cast<double>(scene.products.size()),
                              "items",
                              1,
                              std::nullopt,
                              std::nullopt,
                              machine}};
}

}  // namespace marketgen::bench
