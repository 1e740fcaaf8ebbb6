#include "perception/look_library.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "io/json.h"
#include "perception/kept_looks.h"

namespace marketgen::perception {
namespace {

// Whose pictures are taken together: as many share what is made once, and are in memory at a time.
constexpr std::size_t taken_together = 32;

}  // namespace

Result<Looks> LookLibrary::of(const std::vector<const catalog::Product*>& rows,
                              const agent::KnownProducts& products) {
  const std::scoped_lock lock(guard_);
  const std::string pictures_key = products.pictures_key();
  std::vector<Shelf::iterator> places;
  std::vector<Wanted> missing;
  for (const catalog::Product* row : rows) {
    const auto [place, is_new] = looks_.try_emplace(io::write_json_line(*row));
    places.push_back(place);
    if (place->second) continue;
    Wanted wanted{place, row->sku, {}};
    if (!pictures_key.empty()) wanted.key = look_key(place->first, pictures_key);
    if (auto kept = wanted.key.empty() ? std::nullopt : kept_look(wanted.key, row->sku))
      place->second = std::make_unique<const ProductLook>(*std::move(kept));
    else if (std::ranges::find(missing, place, &Wanted::place) == missing.end())
      missing.push_back(std::move(wanted));
  }
  MARKETGEN_CHECK(learn(missing, products));
  Looks looks;
  for (const Shelf::iterator place : places)
    looks.push_back(place->second.get());
  return looks;
}

Result<void> LookLibrary::learn(const std::vector<Wanted>& wanted,
                                const agent::KnownProducts& products) {
  for (std::size_t from = 0; from < wanted.size(); from += taken_together) {
    const auto some =
        std::span(wanted).subspan(from, std::min(taken_together, wanted.size() - from));
    std::vector<std::string> skus;
    for (const Wanted& each : some)
      skus.push_back(each.sku);
    MARKETGEN_TRY(const std::vector<agent::ProductPictures> pictures, products.pictures(skus));
    for (std::size_t i = 0; i < some.size(); ++i) {
      MARKETGEN_TRY(ProductLook look, ProductLook::make(some[i].sku, pictures[i]));
      if (!some[i].key.empty()) keep_look(some[i].key, look);
      some[i].place->second = std::make_unique<const ProductLook>(std::move(look));
    }
  }
  return {};
}

}  // namespace marketgen::perception
