#include "server/maker.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "base/call_interrupt.h"
#include "base/interrupt.h"
#include "catalog/country.h"
#include "io/json.h"
#include "io/png.h"
#include "plan/vary.h"
#include "render/render.h"
#include "server/answering.h"
#include "web/folder_name.h"

namespace marketgen::server {
namespace {

constexpr int picture_width_px = 480, picture_height_px = 270;
constexpr std::size_t max_name_bytes = 40;  // of a folder that is proposed
constexpr const char* offline = "offline";  // who plans by itself

SaidError said(const Error& error) {
  return {error.code, error.where, error.message};
}

Result<std::string> entrance_picture(const scene::Scene& scene) {
  MARKETGEN_TRY(
      const std::unique_ptr<render::Renderer> renderer,
      render::Renderer::create(scene, silent_progress(), {.print = render::PrintDetail::distant}));
  MARKETGEN_TRY(const render::Camera camera,
                render::camera_named(scene, "entrance", picture_width_px, picture_height_px));
  render::RenderOptions options;
  options.quality = render::Quality::fast;
  MARKETGEN_TRY(const render::Frame frame, renderer->render(camera, options));
  return io::encode_png(frame.color);
}

// "Corner shop!" -> "corner-shop"
std::string plain(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0)
      text += static_cast<char>(std::tolower(letter));
    else if (!text.empty() && text.back() != '-')
      text += '-';
    if (text.size() == max_name_bytes) break;
  }
  while (!text.empty() && text.back() == '-')
    text.pop_back();
  return text.empty() ? "shop" : text;
}

template <class Rows>
std::vector<std::string> ids_in(const Rows& rows) {
  std::vector<std::string> ids;
  for (const auto& row : rows)
    ids.emplace_back(row.id);
  return ids;
}

}  // namespace

bool is_refused_keeping(const Error& error) {
  return error.code.starts_with("store.") || error.code.starts_with("io.");
}

Maker::Maker(std::shared_ptr<const catalog::Catalog> catalog,
             std::filesystem::path folder,
             ShowSaved show,
             OfferedPlanner planner)
    : catalog_(std::move(catalog)),
      folder_(std::move(folder)),
      show_(std::move(show)),
      planner_(std::move(planner)),
      worker_([this] { work(); }) {}

Maker::~Maker() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
    *batch_.given_up = true;
  }
  called_.notify_all();
  worker_.join();
}

// ---- What pages ask ----

Result<web::HttpReply> Maker::get(const web::HttpAsk& ask, const std::vector<std::string>& words) {
  if (words.empty()) return options();
  if (words.size() == 1 && words[0] == "tries") return state();
  if (words.size() == 2 && words[0] == "pictures") return picture(ask, words[1]);
  return no_address(ask);
}

Result<web::HttpReply> Maker::post(const std::string& verb, const web::HttpAsk& ask) {
  if (verb == "try") return begin(ask);
  if (verb == "keep") return keep(ask);
  return no_address(ask);
}

web::HttpReply Maker::options() const {
  MakeOptions options;
  options.folder = folder_.string();
  options.profiles = ids_in(catalog_->profiles);
  options.styles = ids_in(catalog_->styles);
  options.countries = ids_in(catalog::countries());
  for (const std::string_view axis : plan::vary_axes())
    options.vary.emplace_back(axis);
  options.planners = planners();
  return web::json_reply(io::write_json_line(options));
}

std::vector<std::string> Maker::planners() const {
  std::vector<std::string> names{offline};
  if (planner_.name != offline) names.push_back(planner_.name);
  return names;
}

web::HttpReply Maker::state() {
  const std::scoped_lock lock(mutex_);
  TriesState state{batch_.number, false, batch_.warnings, batch_.error, {}};
  for (const Try& one : batch_.tries) {
    state.tries.push_back(one.line);
    const bool to_come = one.line.state == TryState::waiting || one.line.state == TryState::working;
    state.working = state.working || (to_come && !batch_.error);
  }
  return web::json_reply(io::write_json_line(state));
}

Result<void> Maker::check(const TryAsk& ask) const {
  if (ask.words.empty() && !ask.floor_plan && ask.images.empty())
    return Error{"server.bad_request",
                 "words",
                 "say what the store should be, as \"a 24 x 15 m supermarket with a bakery\""};
  const std::vector<std::string> offered = planners();
  if (ask.planner.empty() || std::ranges::find(offered, ask.planner) != offered.end()) return {};
  return Error{"server.bad_request",
               "planner",
               fmt::format("\"{}\" does not plan here: start `marketgen view` with --planner {}",
                           ask.planner,
                           ask.planner)};
}

Result<web::HttpReply> Maker::begin(const web::HttpAsk& ask) {
  MARKETGEN_TRY(TryAsk body, io::read_json<TryAsk>(ask.body, body_name));
  MARKETGEN_CHECK(check(body));
  {
    const std::scoped_lock lock(mutex_);
    *batch_.given_up = true;
    const int number = batch_.number + 1;
    batch_ = {};
    batch_.number = number;
    batch_.tries.resize(static_cast<std::size_t>(body.count));
    for (std::size_t i = 0; i < batch_.tries.size(); ++i)
      batch_.tries[i].line.seed = body.seed + i;
    batch_.ask = std::move(body);
    waiting_ = true;
  }
  called_.notify_all();
  return state();
}

Result<Maker::Try> Maker::made(const web::HttpAsk& ask, int batch, std::uint64_t seed) {
  const std::scoped_lock lock(mutex_);
  if (batch == batch_.number)
    for (const Try& one : batch_.tries)
      if (one.line.seed == seed && one.made) return one;
  return Error{"server.not_found",
               ask.path,
               "no store of that brief and seed is ready; a new brief has taken its place"};
}

Result<web::HttpReply> Maker::keep(const web::HttpAsk& ask) {
  MARKETGEN_TRY(const KeepAsk body, io::read_json<KeepAsk>(ask.body, body_name));
  MARKETGEN_CHECK(web::check_folder_name(body.name));
  MARKETGEN_TRY(const Try one, made(ask, body.batch, body.seed));
  const std::filesystem::path folder = folder_ / body.name;
  constexpr bool previews = false;  // whoever keeps it here has the viewer
  MARKETGEN_CHECK(store::save_made(*one.made, folder, previews, *one.catalog));
  KeptStore kept{0, body.name, one.made->store.manifest.scene_hash};
  MARKETGEN_TRY(kept.store, show_(folder));
  return web::json_reply(io::write_json_line(kept));
}

// "3-7.png": of brief 3, with seed 7.
Result<web::HttpReply> Maker::picture(const web::HttpAsk& ask, const std::string& name) {
  int batch = 0;
  std::uint64_t seed = 0;
  const char* const end = name.data() + name.size();
  const auto number = std::from_chars(name.data(), end, batch);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '-') return no_address(ask);
  const auto rest = std::from_chars(number.ptr + 1, end, seed);
  if (rest.ec != std::errc() || std::string_view(rest.ptr, end) != ".png") return no_address(ask);
  MARKETGEN_TRY(const Try asked, made(ask, batch, seed));
  const std::scoped_lock alone(drawing_);
  std::shared_ptr<const web::HttpBody> drawn;
  note(batch, [&](Batch& now) {
    for (const Try& one : now.tries)
      if (one.line.seed == seed) drawn = one.picture;
  });
  if (!drawn) {
    MARKETGEN_TRY(std::string bytes, entrance_picture(asked.made->store.scene));
    drawn = web::make_body("image/png", std::move(bytes));
    note(batch, [&](Batch& now) {
      for (Try& one : now.tries)
        if (one.line.seed == seed) one.picture = drawn;
    });
  }
  return web::HttpReply{.body = drawn};
}

// ---- The work ----

template <class Change>
bool Maker::note(int batch, const Change& change) {
  const std::scoped_lock lock(mutex_);
  if (batch != batch_.number) return false;
  change(batch_);
  return true;
}

void Maker::work() {
  while (true) {
    int batch = 0;
    TryAsk ask;
    std::shared_ptr<std::atomic<bool>> given_up;
    {
      std::unique_lock lock(mutex_);
      called_.wait(lock, [&] { return waiting_ || ends_; });
      if (ends_) return;
      waiting_ = false;
      batch = batch_.number;
      ask = batch_.ask;
      given_up = batch_.given_up;
    }
    const CallInterrupt breaks_off(given_up.get());
    const Result<void> done = until_interrupted([&]() -> Result<void> {
      make(batch, ask);
      return {};
    });
    if (!done.ok()) note(batch, [&](Batch& now) { now.error = said(done.error()); });
  }
}

void Maker::make(int batch, const TryAsk& ask) {
  const Result<AskedStore> asked = store_asked(ask, catalog_);
  if (!asked.ok()) {
    note(batch, [&](Batch& now) { now.error = said(asked.error()); });
    return;
  }
  note(batch, [&](Batch& now) { now.warnings = asked->drawn.warnings; });
  for (int i = 0; i < ask.count; ++i)
    make_one(batch, static_cast<std::size_t>(i), *asked, ask.seed + static_cast<std::uint64_t>(i));
}

void Maker::make_one(int batch, std::size_t row, const AskedStore& asked, std::uint64_t seed) {
  if (!note(batch, [&](Batch& now) { now.tries[row].line.state = TryState::working; })) return;
  store::CreateOptions options;
  options.brief = asked.drawn.brief;
  if (options.brief.planner != offline) options.planner = planner_.access;
  options.seed = seed;
  Result<store::MadeStore> made = store::made_store(options, *asked.catalog);
  if (!made.ok()) {
    note(batch, [&](Batch& now) {
      now.tries[row].line.state = TryState::failed;
      now.tries[row].line.error = said(made.error());
    });
    return;
  }
  const auto kept = std::make_shared<const store::MadeStore>(std::move(*made));
  TriedStore store = described(*kept);
  note(batch, [&](Batch& now) {
    now.tries[row].made = kept;
    now.tries[row].catalog = asked.catalog;
    now.tries[row].line.store = std::move(store);
    now.tries[row].line.state = TryState::ready;
  });
}

TriedStore Maker::described(const store::MadeStore& made) const {
  const scene::Scene& scene = made.store.scene;
  TriedStore store;
  store.name = made.store.manifest.name;
  store.save_as = free_name(store.name, made.store.manifest.seed);
  store.scene_hash = made.store.manifest.scene_hash;
  store.counts = made.store.manifest.counts;
  store.report = made.report;
  store.outline_mm = plan::floor_of(scene.layout.shell);
  store.openings = openings_of(scene);
  store.zones = scene.layout.zones;
  for (const layout::Fixture& fixture : scene.layout.fixtures) {
    const RectMm r = layout::footprint_of(fixture);
    store.fixtures.push_back({fixture.zone, {r.x0, r.y0, r.x1, r.y1}});
  }
  return store;
}

std::string Maker::free_name(const std::string& name, std::uint64_t seed) const {
  const std::string wanted = fmt::format("{}-{}", plain(name), seed);
  std::string free = wanted;
  std::error_code ignored;
  for (int i = 2; std::filesystem::exists(folder_ / free, ignored); ++i)
    free = fmt::format("{}-{}", wanted, i);
  return free;
}

}  // namespace marketgen::server
