// The catalogue as an agent knows it.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "agent/known_products.h"
#include "catalog/rows.h"

namespace marketgen::episodes {

// Rows, shapes and pictures; made when they are asked for. Both must outlive it.
class PicturedProducts : public agent::KnownProducts {
 public:
  PicturedProducts(const std::vector<catalog::Product>& products,
                   const std::vector<catalog::FrictionRow>& frictions)
      : products_(products), frictions_(frictions) {}

  const std::vector<catalog::Product>& rows() const override { return products_; }
  // Errors: catalog.unknown_sku.
  Result<const catalog::Product*> row(const std::string& sku) const;
  Result<const agent::KnownProduct*> product(const std::string& sku) override;
  Result<std::vector<agent::ProductPictures>> pictures(
      const std::vector<std::string>& skus) const override;
  std::string pictures_key() const override;

 private:
  const std::vector<catalog::Product>& products_;
  const std::vector<catalog::FrictionRow>& frictions_;
  std::map<std::string, agent::KnownProduct> known_;
};

}  // namespace marketgen::episodes
