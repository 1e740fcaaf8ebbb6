#include "perception/look_library.h"

#include "io/json.h"

namespace marketgen {

Result<const ProductLook*> LookLibrary::of(const Product& row, const KnownProducts& products) {
  Entry* entry = nullptr;
  {
    const std::scoped_lock lock(guard_);
    entry = &entries_[write_json_line(row)];
  }
  const std::scoped_lock lock(entry->making);
  if (!entry->look) {
    MARKETGEN_TRY(const auto pictures, products.pictures(row.sku));
    MARKETGEN_TRY(entry->look, ProductLook::make(row.sku, pictures));
  }
  return &*entry->look;
}

}  // namespace marketgen
