#include "evaluation/decision_recorder.h"

#include <utility>

#include "evaluation/decision_judge.h"
#include "evaluation/decisions_page.h"
#include "evaluation/true_things.h"
#include "io/file.h"
#include "io/gzip.h"
#include "io/jpeg.h"
#include "io/json.h"
#include "net/http.h"

namespace marketgen::evaluation {
namespace {

std::array<double, 3> numbers_of(Vec3 at) {
  return {at.x, at.y, at.z};
}

Result<PictureRecord> record_of(const agent::LookedAt& looked) {
  PictureRecord record{looked.camera, {}, looked.marks};
  MARKETGEN_TRY(const std::string jpeg, io::encode_jpeg(looked.picture, io::JpegUse::texture));
  record.jpeg = net::base64_of(jpeg);
  return record;
}

}  // namespace

Result<void> DecisionRecorder::begin(const episodes::TrackWorld& world) {
  world_ = &world;
  log_ = nullptr;
  taken_ = 0;
  state_ = {};
  made_ = {};
  made_.instruction = world.spec().instruction;
  return {};
}

void DecisionRecorder::meets(agent::Policy& policy) {
  log_ = policy.decisions();
  if (log_ != nullptr) log_->keep();
}

Result<DecisionRecord> DecisionRecorder::record_of(const agent::Decision& decision) const {
  DecisionRecord record;
  record.kind = decision.kind;
  record.time_s = decision.time_s, record.computed_s = decision.computed_s;
  record.goal = decision.goal, record.sku = decision.sku, record.outcome = decision.outcome;
  record.readings = decision.readings, record.tried = decision.tried;
  if (decision.middle) {
    record.middle_m = numbers_of(*decision.middle);
    record.truth = truth_at(*world_, decision.sku, *decision.middle);
  }
  if (decision.kind == agent::DecisionKind::hold)
    record.truth = TruthThere{held_sku(*world_), 0, {}};
  for (const agent::FoundGoal& found : decision.found)
    record.found.push_back({static_cast<int>(found.goal),
                            found.sku,
                            numbers_of(found.middle),
                            found.score,
                            truth_at(*world_, found.sku, found.middle)});
  for (const agent::LookedAt& looked : decision.pictures) {
    MARKETGEN_TRY(PictureRecord picture, evaluation::record_of(looked));
    record.pictures.push_back(std::move(picture));
  }
  return record;
}

void DecisionRecorder::answered() {
  if (log_ != nullptr && state_.ok()) state_ = take_new();
}

Result<void> DecisionRecorder::take_new() {
  const std::vector<agent::Decision>& all = log_->decisions();
  for (; taken_ < all.size(); ++taken_) {
    MARKETGEN_TRY(DecisionRecord record, record_of(all[taken_]));
    made_.decisions.push_back(std::move(record));
  }
  return {};
}

Result<EpisodeDecisions> DecisionRecorder::decided(const episodes::EpisodeResult& result,
                                                   const std::string& episode_hash) {
  MARKETGEN_CHECK(state_);
  made_.episode = result.episode, made_.episode_hash = episode_hash;
  made_.policy = result.policy, made_.realism = result.realism;
  made_.goals = judged_goals(made_.decisions, result);
  return std::move(made_);
}

Result<void> write_decisions(const std::filesystem::path& results,
                             const EpisodeDecisions& decisions) {
  std::filesystem::path page = decisions_file(results, decisions.episode);
  MARKETGEN_CHECK(io::write_file(page, io::gzip(io::write_json_line(decisions))));
  page.replace_extension().replace_extension(".html");
  return io::write_file(page, decisions_html(decisions));
}

}  // namespace marketgen::evaluation
