#include "server/edit_session.h"

#include <algorithm>
#include <utility>

#include "web/folder_name.h"

namespace marketgen::server {
namespace {

constexpr std::string_view patches_source = "patches", words_source = "say";

std::filesystem::path beside(const std::filesystem::path& store, const std::string& name) {
  std::filesystem::path folder = std::filesystem::absolute(store).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();  // "shop/"
  return folder.parent_path() / name;
}

EditLine line_of(const store::EditedStore& edited) {
  const store::StoreEdit& last = edited.store.manifest.edits->back();
  return {last.words, last.patches, edited.changes, edited.lost};
}

}  // namespace

Result<std::unique_ptr<EditSession>> EditSession::open(
    std::shared_ptr<const store::Store> base, std::shared_ptr<const catalog::Catalog> catalog) {
  std::unique_ptr<EditSession> session(new EditSession(std::move(base), std::move(catalog)));
  auto first = std::make_shared<store::EditedStore>();
  first->store = *session->base_;
  MARKETGEN_TRY(first->report, store::report_before(*session->base_, *session->catalog_));
  session->held_.push_back(std::move(first));
  return session;
}

EditSnapshot EditSession::snapshot() const {
  const std::scoped_lock lock(mutex_);
  EditState state;
  state.revision = revision_;
  for (std::size_t i = 1; i < held_.size(); ++i)
    state.lines.push_back(line_of(*held_[i]));
  state.done = at_;
  state.save_as = store::next_edit_folder(base_->folder).filename().string();
  return {std::move(state), held_[at_]};
}

Result<void> EditSession::step(const std::vector<plan::Patch>& patches,
                               std::string_view source,
                               const std::string& words) {
  store::EditStep step;
  step.patches.patches = patches;
  step.source = source;
  step.words = words;
  const store::EditedStore& before = *held_[at_];
  MARKETGEN_TRY(store::EditedStore after,
                store::edited_store(before.store, before.report, step, *catalog_));
  held_.resize(at_ + 1);  // what was undone is gone
  held_.push_back(std::make_shared<const store::EditedStore>(std::move(after)));
  if (held_.size() > max_undo + 1) held_.pop_front();
  at_ = held_.size() - 1;
  ++revision_;
  return {};
}

Result<void> EditSession::apply(const std::vector<plan::Patch>& patches) {
  if (patches.empty())
    return Error{"server.bad_request", "patches", "name at least one operation of market-patch/1"};
  const std::scoped_lock lock(mutex_);
  return step(patches, patches_source, "");
}

Result<store::SaidPatches> EditSession::say(const std::string& words) {
  const std::scoped_lock lock(mutex_);
  MARKETGEN_TRY(store::SaidPatches said,
                store::patches_of_words(held_[at_]->store, words, *catalog_));
  if (!said.patches.patches.empty())
    MARKETGEN_CHECK(step(said.patches.patches, words_source, words));
  return said;
}

Result<void> EditSession::undo() {
  const std::scoped_lock lock(mutex_);
  if (at_ == 0) return Error{"server.bad_request", "undo", "there is nothing to undo"};
  --at_;
  ++revision_;
  return {};
}

Result<void> EditSession::redo() {
  const std::scoped_lock lock(mutex_);
  if (at_ + 1 == held_.size())
    return Error{"server.bad_request", "redo", "there is nothing to do again"};
  ++at_;
  ++revision_;
  return {};
}

Result<EditPreview> EditSession::preview(const std::vector<plan::Patch>& patches) const {
  const Now before = snapshot().now;
  plan::PatchSet set;
  set.patches = patches;
  MARKETGEN_TRY(store::Replanned then,
                store::replan(before->store, set, std::string(patches_source), *catalog_));
  EditPreview preview{std::move(then.layout.zones),
                      std::move(then.offences),
                      std::move(then.layout.violations),
                      {}};
  for (const layout::Fixture& fixture : then.layout.fixtures) {
    const RectMm at = layout::footprint_of(fixture);
    preview.fixtures.push_back({fixture.run, {at.x0, at.y0, at.x1, at.y1}});
  }
  return preview;
}

Result<std::filesystem::path> EditSession::save(const std::string& name, const Now& what) const {
  MARKETGEN_CHECK(web::check_folder_name(name));
  const std::filesystem::path folder = beside(base_->folder, name);
  constexpr bool previews = false;  // whoever saves here has the viewer
  MARKETGEN_CHECK(store::save_edited(*what, folder, previews, *catalog_));
  return folder;
}

}  // namespace marketgen::server
