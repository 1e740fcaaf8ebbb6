// The store as the map has it that an agent is given, which is not quite as it stands.
#pragma once
#include <memory>

#include "episodes/aisle/aisle_store.h"
#include "episodes/realism.h"

namespace marketgen::episodes {

// Each run of fixtures, with what closes its ends, stands elsewhere by what is drawn for it by its
// name, and so do the ways between them; less of all that when the robot, its axle at `start`,
// would begin where the map leaves it no room. Goods stand as they do: no map has them. With no
// dial on it is `store`. Errors: those of drive_graph.
Result<std::shared_ptr<const AisleStore>> mapped_store(std::shared_ptr<const AisleStore> store,
                                                       const MapDials& dials,
                                                       Seed seed,
                                                       PointMm start);

}  // namespace marketgen::episodes
