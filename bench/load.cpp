#include "bench/bench.h"
#include "bench/sample_store.h"
#include "io/file.h"
#include "io/json.h"
#include "scene/scene_file.h"

namespace marketgen::bench {

Figures run_load(const Catalog& catalog) {
  const ScratchFolder scratch;
  MARKETGEN_TRY(const Created created, create_store(large_store(scratch / "store"), catalog));
  const std::filesystem::path file = scratch / "store" / "scene.bin";
  MARKETGEN_TRY(const Scene scene, open_scene(file));
  const std::filesystem::path json_file = scratch / "scene.json";
  MARKETGEN_CHECK(write_file(json_file, write_json_line(scene)));

  constexpr int runs = 9;
  const double ours = median_seconds(runs, [&] { (void)open_scene(file).ok(); });
  const double json = median_seconds(3, [&] {
    const auto text = read_file(json_file);
    Scene read;
    if (text.ok()) (void)read_json_into(*text, "scene.json", type_of<Scene>(), &read).ok();
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
