#include "settle_heaps.h"

#include <algorithm>
#include <map>
#include <memory>

#include "base/build_info.h"
#include "base/hash.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "io/json.h"
#include "io/line_journal.h"
#include "io/output.h"
#include "physics/settle/heap.h"
#include "scene/shelf_fill.h"

namespace marketgen::app {
namespace {

// The first product of every shape and size that lies in heaps as balls do.
std::vector<const catalog::Product*> kinds_of_pieces(const catalog::Catalog& catalog) {
  std::vector<const catalog::Product*> kinds;
  for (const catalog::Product& product : catalog.products) {
    if (!scene::lies_as_balls(product)) continue;
    const bool known = std::ranges::any_of(kinds, [&](const catalog::Product* kind) {
      return kind->archetype == product.archetype && kind->size_mm == product.size_mm;
    });
    if (!known) kinds.push_back(&product);
  }
  return kinds;
}

// A line of the journal.
struct SettledHeap {
  int number = 0;
  catalog::HeapRow heap;
  static constexpr auto fields =
      field_list(field("number", &SettledHeap::number, "of its kind, from 0", range(0, 1e6)),
                 field("heap", &SettledHeap::heap, "as it will stand in its file", required()));
};

using Heaps = std::map<std::size_t, catalog::HeapRow>;  // by number of their kind

Result<Heaps> heaps_in(const io::LineJournal& journal) {
  Heaps heaps;
  for (const std::string& line : journal.before()) {
    MARKETGEN_TRY(SettledHeap kept, io::read_json<SettledHeap>(line, journal.file().string()));
    heaps[static_cast<std::size_t>(kept.number)] = std::move(kept.heap);
  }
  return heaps;
}

// Beside the output, as long as not all are settled; none when the output is a device or pipe.
Result<std::unique_ptr<io::LineJournal>> heap_journal(const catalog::Catalog& catalog,
                                                      const std::string& output,
                                                      bool resume) {
  MARKETGEN_TRY(const auto file, io::LineJournal::place_beside(output));
  if (!file) return std::unique_ptr<io::LineJournal>();
  const std::string work =
      Hasher().add("heaps").add(program_version).add(catalog.content_hash).hex();
  return io::LineJournal::begin(*file, work, resume);
}

Result<catalog::HeapRow> settle_and_keep(const catalog::Product& kind,
                                         std::size_t number,
                                         io::LineJournal* journal) {
  MARKETGEN_TRY(catalog::HeapRow row, physics::settle_heap(kind));
  if (journal != nullptr)
    MARKETGEN_CHECK(journal->keep(io::write_json_line(SettledHeap{static_cast<int>(number), row})));
  return row;
}

// The rows in the order of their kinds, but for those that are there already.
Result<std::string> settled_text(const std::vector<const catalog::Product*>& kinds,
                                 const Heaps& before,
                                 io::LineJournal* journal,
                                 Progress& progress) {
  progress.begin("heaps", kinds.size());
  const auto rows = parallel_map(kinds.size(), [&](std::size_t i) {
    const auto known = before.find(i);
    auto row = known == before.end() ? settle_and_keep(*kinds[i], i, journal)
                                     : Result<catalog::HeapRow>(known->second);
    progress.advance();
    return std::make_shared<Result<catalog::HeapRow>>(std::move(row));
  });
  progress.end();
  std::string text = "[\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i]->ok()) return rows[i]->error();
    text += "  " + io::write_json_line(rows[i]->value()) + (i + 1 < rows.size() ? ",\n" : "\n");
  }
  return text + "]\n";
}

}  // namespace

Result<void> settle_heaps(const catalog::Catalog& catalog,
                          const std::string& file,
                          bool resume,
                          const CommonFlags& flags) {
  const std::vector<const catalog::Product*> kinds = kinds_of_pieces(catalog);
  const ThreadLimit limit(flags.threads);
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", file}}));
  MARKETGEN_TRY(const auto journal, heap_journal(catalog, file, resume));
  Heaps before;
  if (journal) {
    MARKETGEN_TRY(before, heaps_in(*journal));
  }
  const auto text = until_interrupted(
      [&] { return settled_text(kinds, before, journal.get(), progress_for(flags)); });
  if (!text.ok()) {
    if (journal && text.error().code == interrupted_error().code)
      return io::interrupted_with(*journal, file, kinds.size(), "heaps");
    if (journal) journal->remove();  // it would end so again
    return text.error();
  }
  MARKETGEN_CHECK(outputs.put(file, *text));
  MARKETGEN_CHECK(outputs.commit());
  if (journal) journal->remove();
  return {};
}

}  // namespace marketgen::app
