// The pictures of a product that a catalogue shows an agent: from its six sides, in the light of
// the room in which the episodes play.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "agent/known_products.h"

namespace marketgen {

// Errors: those of Renderer.
Result<std::vector<ProductPicture>> product_pictures(const Product& product);

// Pictures that many episodes share: each is made when it is asked for first. Any number of threads
// may ask.
class PictureLibrary {
 public:
  // Lives as long as the library. Products with the same SKU are taken for the same. Errors: of
  // product_pictures.
  Result<const std::vector<ProductPicture>*> of(const Product& product);

 private:
  std::mutex guard_;
  std::map<std::string, std::unique_ptr<std::vector<ProductPicture>>> pictures_;
};

}  // namespace marketgen
