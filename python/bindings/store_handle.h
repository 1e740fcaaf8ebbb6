// A store that Python holds: shared, because renderers of it outlive the name that made them.
#pragma once
#include <memory>
#include <vector>

#include "store/store.h"

namespace marketgen::python {

struct StoreHandle {
  std::shared_ptr<const Store> store;
  std::vector<FrictionRow> frictions;  // of the rows it was opened with
};

}  // namespace marketgen::python
