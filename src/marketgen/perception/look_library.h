// Looks of products that many policies share: each is learnt from its pictures when it is asked for
// first, in this process or in one before (kept_looks.h). Any number of threads may ask; while one
// learns, others wait.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "perception/product_look.h"

namespace marketgen::perception {

using Looks = std::vector<const ProductLook*>;

class LookLibrary {
 public:
  // Of the products of `rows`, whose pictures `products` has, in their order; rows that are equal
  // to the last letter have one look. They live as long as the library. Errors: of
  // KnownProducts::pictures, ProductLook::make.
  Result<Looks> of(const std::vector<const catalog::Product*>& rows,
                   const agent::KnownProducts& products);

 private:
  // Of a row as text; null: not learnt yet. None moves.
  using Shelf = std::map<std::string, std::unique_ptr<const ProductLook>>;
  struct Wanted {
    Shelf::iterator place;
    std::string sku, key;  // on disk; empty: it is not kept
  };
  static Result<void> learn(const std::vector<Wanted>& wanted,
                            const agent::KnownProducts& products);

  std::mutex guard_;
  Shelf looks_;
};

}  // namespace marketgen::perception
