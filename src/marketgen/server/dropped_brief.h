// What somebody asked for on a page, as `marketgen generate` takes it.
#pragma once
#include <memory>

#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/drawn_shell.h"
#include "server/make_documents.h"

namespace marketgen::server {

struct AskedStore {
  intake::Drawn drawn;
  std::shared_ptr<const catalog::Catalog> catalog;  // with what is the user's own
};

// Dropped files are read and gone again: the brief names them as they were called. `catalog`: the
// program's. Errors: server.bad_request for a file's name, net.* for its bytes; brief.bad_size,
// brief.bad_time, brief.bad_vary; those of assets::usable_catalog and intake::with_drawing.
Result<AskedStore> store_asked(const TryAsk& ask, std::shared_ptr<const catalog::Catalog> catalog);

}  // namespace marketgen::server
