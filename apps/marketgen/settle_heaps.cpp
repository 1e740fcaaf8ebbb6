#include "settle_heaps.h"

#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "io/json.h"
#include "io/output.h"
#include "physics/heap.h"
#include "scene/shelf_fill.h"

namespace marketgen::app {
namespace {

// The first product of every shape and size that lies in heaps as balls do.
std::vector<const Product*> kinds_of_pieces(const Catalog& catalog) {
  std::vector<const Product*> kinds;
  for (const Product& product : catalog.products) {
    if (!lies_as_balls(product)) continue;
    const bool known = std::ranges::any_of(kinds, [&](const Product* kind) {
      return kind->archetype == product.archetype && kind->size_mm == product.size_mm;
    });
    if (!known) kinds.push_back(&product);
  }
  return kinds;
}

}  // namespace

Result<void> settle_heaps(const Catalog& catalog,
                          const std::string& file,
                          const CommonFlags& flags) {
  const std::vector<const Product*> kinds = kinds_of_pieces(catalog);
  const ThreadLimit limit(flags.threads);
  Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", file}}));
  Progress& progress = progress_for(flags);
  progress.begin("heaps", kinds.size());
  std::vector<std::string> lines(kinds.size());
  std::vector<std::optional<Error>> errors(kinds.size());
  parallel_for(kinds.size(), [&](std::size_t i) {
    const Result<HeapRow> row = settle_heap(*kinds[i]);
    if (row.ok())
      lines[i] = write_json_line(*row);
    else
      errors[i] = row.error();
    progress.advance();
  });
  progress.end();
  std::string text = "[\n";
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (errors[i]) return *errors[i];
    text += "  " + lines[i] + (i + 1 < kinds.size() ? ",\n" : "\n");
  }
  MARKETGEN_CHECK(outputs.put(file, text + "]\n"));
  return outputs.commit();
}

}  // namespace marketgen::app
