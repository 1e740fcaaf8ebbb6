#include "io/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "base/interrupt.h"
#include "io/file.h"
#include "io/part_name.h"

namespace marketgen::io {
namespace fs = std::filesystem;

Outputs::~Outputs() {
  for (Draft& draft : drafts_) {
    if (draft.part.empty()) continue;
    unlink(draft.part.c_str());
    drop_leftover(draft.part);
  }
}

Result<void> Outputs::add(const std::vector<std::pair<std::string, fs::path>>& files) {
  for (const auto& [flag, file] : files) {
    if (file.empty()) continue;
    MARKETGEN_TRY(Destination to, destination_of(file, made_));
    const bool twice = std::ranges::any_of(drafts_, [&](const Draft& draft) {
      return to.reach == Reach::replaced && draft.to.target == to.target;
    });
    if (twice)
      return Error{
          "usage.bad_flag", flag, file.string() + " is to be written already; name another file"};
    add_draft(std::move(to));
  }
  return {};
}

void Outputs::add_draft(Destination to) {
  by_shown_.try_emplace(to.shown, drafts_.size());
  drafts_.push_back({std::move(to), {}, false, false});
}

Result<void> Outputs::add_folder(const fs::path& folder) {
  MARKETGEN_TRY(const fs::path target, followed(folder));
  std::error_code failed;
  const int fault = fs::exists(target, failed) ? 0 : made_.make(target);
  if (fault != 0) return cannot_write(folder, "cannot be made", fault);
  if (!fs::is_directory(target, failed))
    return Error{"io.cannot_write", folder.string(), "is a file; name a folder"};
  MadeFolders none;
  const auto probed = destination_of(part_in(target, "probe"), none);
  if (!probed.ok()) return Error{"io.cannot_write", folder.string(), probed.error().message};
  return {};
}

Result<Outputs::Draft*> Outputs::draft_of(const fs::path& file) {
  if (const auto found = by_shown_.find(file); found != by_shown_.end())
    return &drafts_[found->second];
  MARKETGEN_TRY(Destination to, destination_of(file, made_));
  add_draft(std::move(to));
  return &drafts_.back();
}

void Outputs::begin_part(Draft& draft) {
  if (draft.part.empty())
    draft.part = part_in(draft.to.target.parent_path(), draft.to.target.filename().string());
  add_leftover(draft.part);
}

Result<void> Outputs::put(const fs::path& file, const Writer& write) {
  MARKETGEN_TRY(Draft * draft, draft_of(file));
  const bool beside = draft->to.reach == Reach::replaced;
  if (beside) begin_part(*draft);
  draft->on_disk = true;
  const fs::path place = beside ? draft->part : draft->to.shown;
  Result<void> written = write(place);
  if (written.ok() || written.error().where != place.string()) return written;
  return Error{written.error().code, file.string(), written.error().message};
}

Result<void> Outputs::put(const fs::path& file, std::string_view bytes) {
  MARKETGEN_TRY(Draft * draft, draft_of(file));
  if (draft->to.reach != Reach::replaced) return write_to(draft->to, bytes);
  begin_part(*draft);
  unlink(draft->part.c_str());  // what was put before
  MARKETGEN_CHECK(write_new(draft->part, bytes, Durable::begun, file));
  begin_part(*draft);
  draft->on_disk = false;
  return {};
}

// Together, at last: the disk writes many files side by side.
Result<void> Outputs::carry_all_through() {
  for (Draft& draft : drafts_) {
    if (draft.part.empty() || draft.on_disk) continue;
    MARKETGEN_CHECK(carry_through(draft.part, draft.to.shown));
    draft.on_disk = true;
  }
  return {};
}

Result<void> Outputs::put_in_place(Draft& draft) {
  const Destination& to = draft.to;
  if (to.mode && chmod(draft.part.c_str(), *to.mode) != 0)
    return cannot_write(to.shown, "cannot be put in place", errno);
  const char *part = draft.part.c_str(), *target = to.target.c_str();
  std::error_code failed;
  if (fs::is_directory(to.target, failed))  // since it was probed; it would be exchanged, too
    return cannot_write(to.shown, "cannot be put in place", EISDIR);
  if (renameat2(AT_FDCWD, part, AT_FDCWD, target, RENAME_EXCHANGE) == 0) {
    draft.swapped = true;
    return {};
  }
  if (rename(part, target) != 0) return cannot_write(to.shown, "cannot be put in place", errno);
  drop_leftover(draft.part);
  draft.part.clear();
  return {};
}

// The old file again, or none.
void Outputs::take_back(Draft& draft) {
  if (draft.swapped)
    renameat2(AT_FDCWD, draft.part.c_str(), AT_FDCWD, draft.to.target.c_str(), RENAME_EXCHANGE);
  else if (draft.part.empty() && draft.to.reach == Reach::replaced && !draft.to.mode)
    unlink(draft.to.target.c_str());
}

Result<void> Outputs::commit() {
  MARKETGEN_CHECK(carry_all_through());
  const NoForcedEnd together;
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    if (drafts_[i].part.empty()) continue;
    Result<void> placed = put_in_place(drafts_[i]);
    if (placed.ok()) continue;
    for (std::size_t k = 0; k < i; ++k)
      take_back(drafts_[k]);
    return placed;
  }
  made_.keep();
  return {};
}

}  // namespace marketgen::io
