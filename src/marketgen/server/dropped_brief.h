// What somebody asked for on a page, as `marketgen generate` takes it.
#pragma once
#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/drawn_shell.h"
#include "server/make_documents.h"

namespace marketgen::server {

// Dropped files are read and gone again: the brief names them as they were called. Errors:
// server.bad_request for a file's name, net.* for its bytes; brief.bad_size; those of
// intake::with_drawing.
Result<intake::Drawn> brief_asked(const TryAsk& ask, const catalog::Catalog& catalog);

}  // namespace marketgen::server
