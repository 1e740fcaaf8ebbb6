// A store that Python holds: shared, because renderers of it outlive the name that made them.
#pragma once
#include <memory>

#include "store/store.h"

namespace marketgen::python {

struct StoreHandle {
  std::shared_ptr<const Store> store;
};

}  // namespace marketgen::python
