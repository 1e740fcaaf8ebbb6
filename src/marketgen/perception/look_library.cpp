#include "perception/look_library.h"

#include "io/json.h"

namespace marketgen::perception {

Result<const ProductLook*> LookLibrary::of(const catalog::Product& row,
                                           const agent::KnownProducts& products) {
  Entry* entry = nullptr;
  {
    const std::scoped_lock lock(guard_);
    entry = &entries_[io::write_json_line(row)];
  }
  const std::scoped_lock lock(entry->making);
  if (!entry->look) {
    MARKETGEN_TRY(const auto pictures, products.pictures(row.sku));
    MARKETGEN_TRY(entry->look, ProductLook::make(row.sku, pictures));
  }
  return &*entry->look;
}

}  // namespace marketgen::perception
