// A store that Python holds: shared, because renderers of it outlive the name that made them.
#pragma once
#include <memory>

#include "environments/episode_ground.h"
#include "store/store.h"

namespace marketgen::python {

struct StoreHandle {
  std::shared_ptr<const store::Store> store;
  std::shared_ptr<const catalog::Catalog> catalog;  // the rows that it was opened with
  std::shared_ptr<environments::EpisodeGround> ground =
      {};  // of its environments, once there was one
};

}  // namespace marketgen::python
