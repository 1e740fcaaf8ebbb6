// The addresses below /api/stores/N/edit: one page edits a store, others see that somebody does.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "base/result.h"
#include "server/cards.h"
#include "server/edit_delta.h"
#include "server/edit_session.h"
#include "server/show_saved.h"
#include "web/edit_lease.h"
#include "web/http_message.h"

namespace marketgen::server {

class Editor {
 public:
  // `catalog`: the rows that the store was made of. `grasps` must outlive it.
  Editor(std::shared_ptr<const store::Store> base,
         std::shared_ptr<const catalog::Catalog> catalog,
         const GraspFacts& grasps,
         ShowSaved show)
      : base_(std::move(base)),
        catalog_(std::move(catalog)),
        grasps_(grasps),
        show_(std::move(show)) {}

  // What `verb` (the address after /edit/) is answered. Errors: server.not_found,
  // server.edit_taken for a token that has not (or no longer) the lease, json.* of the body, those
  // of EditSession. Thread-safe.
  Result<web::HttpReply> post(const std::string& verb, const web::HttpAsk& ask);
  Result<web::HttpReply> status();

  // As it is now; nothing while no page has begun.
  EditSession::Now now();

 private:
  Result<web::HttpReply> change(const std::string& verb, const web::HttpAsk& ask);
  Result<web::HttpReply> begin(const web::HttpAsk& ask);
  Result<web::HttpReply> save(const web::HttpAsk& ask);
  Result<EditSession*> session();
  Result<void> require_lease(const std::string& token);
  web::HttpReply picture(EditSnapshot at) const;

  std::shared_ptr<const store::Store> base_;
  std::shared_ptr<const catalog::Catalog> catalog_;
  const GraspFacts& grasps_;
  ShowSaved show_;
  std::mutex mutex_;  // of what follows; not held while a store is made
  web::EditLease lease_;
  std::unique_ptr<EditSession> session_;
  std::unique_ptr<DeltaBase> delta_;
};

// Whether it says why the core does not do an edit. That is an answer like others: a person tries
// out what fits, and browsers complain of every status that is none of success.
bool is_refused_edit(const Error& error);

}  // namespace marketgen::server
