// A store while it is edited: patch after patch on its plan, each with the store that it leads to.
//
// Every change goes through store::edited_store, as `marketgen edit` does it: what is saved at last
// is what that command makes of the same patches, one folder after another. Nothing is written
// before that, and never into the store's own folder. Thread-safe.
#pragma once
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/patch.h"
#include "server/edit_documents.h"
#include "store/edit.h"

namespace marketgen::server {

// So many steps can be undone; each keeps a store in memory.
constexpr std::size_t max_undo = 40;

// A store as it is at one moment of its edit. Of the state: revision, lines, done, save_as.
struct EditSnapshot {
  EditState state;
  std::shared_ptr<const store::EditedStore> now;
};

class EditSession {
 public:
  using Now = std::shared_ptr<const store::EditedStore>;

  // `catalog`: the rows that the store was made of. Errors: of store::report_before.
  static Result<std::unique_ptr<EditSession>> open(std::shared_ptr<const store::Store> base,
                                                   std::shared_ptr<const catalog::Catalog> catalog);

  EditSnapshot snapshot() const;

  // Errors of these: of store::edited_store, patches_of_words; server.bad_request where there is
  // nothing to undo or redo. The store stays as it was then.
  Result<void> apply(const std::vector<plan::Patch>& patches);
  Result<store::SaidPatches> say(const std::string& words);
  Result<void> undo();
  Result<void> redo();

  // What the patches would lead to, without stocking anything. Errors: of store::replan.
  Result<EditPreview> preview(const std::vector<plan::Patch>& patches) const;
  // Writes what a snapshot has beside the one that is edited. Errors: server.bad_request for a
  // name that is none; io.*. Its folder.
  Result<std::filesystem::path> save(const std::string& name, const Now& what) const;

 private:
  EditSession(std::shared_ptr<const store::Store> base,
              std::shared_ptr<const catalog::Catalog> catalog)
      : base_(std::move(base)), catalog_(std::move(catalog)) {}
  Result<void> step(const std::vector<plan::Patch>& patches,
                    std::string_view source,
                    const std::string& words);

  std::shared_ptr<const store::Store> base_;
  std::shared_ptr<const catalog::Catalog> catalog_;
  mutable std::mutex mutex_;
  std::deque<Now> held_;  // the first: before the oldest step that can be undone
  std::size_t at_ = 0;    // in held_
  int revision_ = 0;
};

}  // namespace marketgen::server
