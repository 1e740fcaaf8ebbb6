// Looks of products that many policies share: each is learnt from its pictures when it is asked for
// first. Any number of threads may ask.
#pragma once
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "perception/product_look.h"

namespace marketgen::perception {

class LookLibrary {
 public:
  // Of the product of `row`, whose pictures `products` has; rows that are equal to the last letter
  // have one look. Lives as long as the library. Errors: of KnownProducts::pictures,
  // ProductLook::make.
  Result<const ProductLook*> of(const catalog::Product& row, const agent::KnownProducts& products);

 private:
  struct Entry {
    std::mutex making;
    std::optional<ProductLook> look;
  };
  std::mutex guard_;  // of the map, not of what is in it
  std::map<std::string, Entry> entries_;
};

}  // namespace marketgen::perception
