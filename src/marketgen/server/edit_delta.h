// What of a store's picture an edit changes: against the store as a page has opened it.
//
// Told against that one store, not against the step before: a page that was loaded anew, or whose
// answers overtook one another, needs no other state than the last answer, and what is undone is
// drawn with its own light again.
#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"
#include "server/packed_sections.h"

namespace marketgen::server {

class DeltaBase {
 public:
  // `scene` must outlive it.
  explicit DeltaBase(const scene::Scene& scene);

  // Adds the tables that docs/viewer.md has for edit.bin: which rows of the base stay and under
  // which numbers, the rows that do not come from it, and the shapes of fixtures that are new or
  // stand otherwise. Rows of the SKUs that the base does not have: the page has them after its own.
  std::vector<std::uint32_t> describe(const scene::Scene& now, PackedSections& sections) const;

 private:
  class Goods;
  // Hashes over how a fixture stands and what it is made of, and over its price tags.
  struct FixtureLook {
    std::uint64_t shape = 0, tags = 0;
  };
  static std::vector<FixtureLook> looks_of(const scene::Scene& scene);
  struct SkuRows {
    std::vector<std::uint32_t> page;   // the page's numbers of the scene's SKUs
    std::vector<std::uint32_t> fresh;  // rows of those that the base does not have
  };
  SkuRows sku_rows(const scene::Scene& now) const;
  std::vector<bool> describe_fixtures(const scene::Scene& now, PackedSections& sections) const;

  const scene::Scene& base_;
  std::unordered_map<std::string, std::uint32_t> skus_, fixtures_;  // rows by SKU, by id
  std::vector<FixtureLook> looks_;                                  // by fixture
  std::unordered_map<std::uint64_t, std::uint32_t> products_;       // rows by hash
};

// The shapes of some of a scene's fixtures, each once, and where they stand: in plain colours,
// without price tags. Lamps have their light, all else has none yet.
void pack_fixture_shapes(const scene::Scene& scene,
                         const std::vector<std::uint32_t>& rows,
                         PackedSections& sections);

}  // namespace marketgen::server
