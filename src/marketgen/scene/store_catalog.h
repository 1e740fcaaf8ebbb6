// The catalogue as a plan's store has it: in its country's money, and with how high goods are
// piled.
#pragma once
#include <optional>

#include "catalog/catalog.h"
#include "catalog/country.h"
#include "plan/plan.h"

namespace marketgen::scene {

// Where boards are fitted to goods (plan::ShelfPitch::fitted), bread in bags and bunches of fruit
// and vegetables lie on one another as shops pile them (Product::stack_max); the rows say that such
// goods stand alone, and so they do in every other store. The user's own rows stay as they are. The
// very catalogue where the plan changes nothing; `rows` must outlive it.
class StoreCatalog {
 public:
  StoreCatalog(const catalog::Catalog& rows, const plan::Plan& plan);
  const catalog::Catalog& get() const { return piled_ ? *piled_ : local_.get(); }

 private:
  catalog::LocalCatalog local_;
  std::optional<catalog::Catalog> piled_;
};

}  // namespace marketgen::scene
