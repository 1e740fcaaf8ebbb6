#include "store/planogram.h"

#include "io/file.h"

namespace marketgen::store {

Result<scene::PlanogramFile> read_planogram_file(const std::filesystem::path& file,
                                                 const scene::Scene& scene,
                                                 const plan::Plan& plan,
                                                 const catalog::Catalog& catalog) {
  constexpr std::uint64_t max_bytes = 64U << 20;
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_bytes));
  return scene::read_planogram(text, file.string(), scene, plan, catalog);
}

}  // namespace marketgen::store
