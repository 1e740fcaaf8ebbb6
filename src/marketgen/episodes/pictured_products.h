// The catalogue as an agent knows it.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "agent/known_products.h"
#include "catalog/rows.h"

namespace marketgen {

// Rows, shapes and pictures; made when they are asked for. Both must outlive it.
class PicturedProducts : public KnownProducts {
 public:
  PicturedProducts(const std::vector<Product>& products, const std::vector<FrictionRow>& frictions)
      : products_(products), frictions_(frictions) {}

  const std::vector<Product>& rows() const override { return products_; }
  Result<const KnownProduct*> product(const std::string& sku) override;
  Result<std::vector<ProductPicture>> pictures(const std::string& sku) const override;

 private:
  Result<const Product*> row(const std::string& sku) const;

  const std::vector<Product>& products_;
  const std::vector<FrictionRow>& frictions_;
  std::map<std::string, KnownProduct> known_;
};

}  // namespace marketgen
