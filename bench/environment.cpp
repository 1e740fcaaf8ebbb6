// Environments of both tracks without pictures: steps beside bare mj_step, resets, memory.
#include <malloc.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>

#include "bench/bench.h"
#include "bench/sample_store.h"
#include "environments/aisle/shared_aisle.h"
#include "environments/environment_batch.h"
#include "physics/mujoco_guard.h"

namespace marketgen::bench {
namespace {

constexpr int step_rounds = 9, steps_a_round = 20, substeps = 25;
constexpr int reset_runs = 5;
constexpr int resets_before = 100, resets_counted = 1000;

// One environment and memory for what it says.
class Bench {
 public:
  static Result<Bench> begin(const std::shared_ptr<environments::EpisodeGround>& ground,
                             episodes::EpisodeSpec spec) {
    Bench bench;
    MARKETGEN_TRY(bench.environment_, environments::Environment::create(ground, spec.track, {}));
    bench.seen_.resize(bench.environment_->observation_size());
    bench.action_.assign(bench.environment_->action_numbers().size(), 0);
    bench.action_.back() = -1;  // go on
    bench.spec_ = std::move(spec);
    return bench;
  }

  Result<void> reset() {
    environments::Environment* const one = environment_.get();
    return environments::reset_all({&one, 1}, {&spec_, 1}, seen_);
  }

  // Steps a second with arms that sway.
  Result<double> steps_per_s(int round) {
    environments::Environment* const one = environment_.get();
    double reward = 0;
    bool terminated = false, truncated = false;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < steps_a_round; ++i) {
      std::fill(action_.begin(), action_.begin() + joints, (i + round) % 8 < 4 ? sway : -sway);
      MARKETGEN_CHECK(environments::step_all(
          {&one, 1}, action_, {seen_, {&reward, 1}, {&terminated, 1}, {&truncated, 1}}));
    }
    return steps_a_round / seconds_since(start);
  }

  // The same number of steps of physics from the same moment by MuJoCo alone, its commands held.
  Result<double> bare_steps_per_s() const {
    const mjModel& model = environment_->model();
    MARKETGEN_TRY(const physics::MujocoData data, physics::make_data(model, "bench"));
    mj_copyData(data.get(), &model, &environment_->data());
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < steps_a_round * substeps; ++i)
      mj_step(&model, data.get());
    return steps_a_round / seconds_since(start);
  }

 private:
  static constexpr int joints = 7;
  static constexpr double sway = 0.1;
  static double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::unique_ptr<environments::Environment> environment_;
  episodes::EpisodeSpec spec_;
  std::vector<float> seen_;
  std::vector<double> action_;
};

// In the middle of an aisle; to fetch what stands within reach.
Result<episodes::EpisodeSpec> aisle_episode(environments::EpisodeGround& ground,
                                            const store::Store& store) {
  episodes::EpisodeSpec spec;
  spec.id = "bench";
  spec.track = episodes::Track::aisle;
  spec.scene_hash = store.manifest.scene_hash;
  spec.plan_hash = episodes::plan_hash(store.plan);
  spec.limit_s = 900;
  MARKETGEN_TRY(const auto aisles,
                environments::shared_aisle_store(ground.arena(), spec.scene_hash));
  spec.robot = aisles->station.robot;
  for (const catalog::Product& product : store.scene.catalog) {
    const auto places = aisles->standing_places(product.sku);
    if (places.empty()) continue;
    spec.goals = {{product.sku, 1}};
    spec.start.x_m = places.front()[0] / 1e3;
    spec.start.y_m = places.front()[1] / 1e3;
    return spec;
  }
  return Error{"episode.impossible", "bench", "nothing stands within reach"};
}

Figure figure(std::string name, double value, std::string unit, int n) {
  return {std::move(name), value, std::move(unit), n, std::nullopt, std::nullopt, machine_name()};
}

Result<void> add_steps(const std::string& track, Bench& bench, std::vector<Figure>& figures) {
  std::vector<double> ours, bare;
  for (int round = 0; round < step_rounds; ++round) {
    MARKETGEN_TRY(const double stepped, bench.steps_per_s(round));
    MARKETGEN_TRY(const double alone, bench.bare_steps_per_s());
    ours.push_back(stepped);
    bare.push_back(alone);
  }
  Figure made = figure("environment_" + track + "_steps", median(ours), "steps/s", step_rounds);
  made.rival = "mj_step alone, 25 a step, from the same moment";
  made.ratio = median(ours) / median(bare);
  figures.push_back(made);
  return {};
}

Result<void> add_resets(const std::string& track, Bench& bench, std::vector<Figure>& figures) {
  Result<void> done;
  const auto reset = [&] { done = bench.reset(); };
  const double seconds = median_seconds(reset_runs, reset);
  figures.push_back(figure("environment_" + track + "_reset_s", seconds, "s", reset_runs));
  return done;
}

// How much more memory is in use after many resets, as a share.
Result<void> add_memory(Bench& bench, std::vector<Figure>& figures) {
  for (int i = 0; i < resets_before; ++i)
    MARKETGEN_CHECK(bench.reset());
  malloc_trim(0);
  const double before = resident_mb();
  for (int i = 0; i < resets_counted; ++i)
    MARKETGEN_CHECK(bench.reset());
  malloc_trim(0);
  const double growth = resident_mb() / before - 1;
  figures.push_back(figure("environment_memory_growth", growth, "share", resets_counted));
  return {};
}

// From nothing but the episode: the store is opened from its folder first.
Result<void> add_first_reset(const std::filesystem::path& folder,
                             const std::shared_ptr<const catalog::Catalog>& catalog,
                             const episodes::EpisodeSpec& spec,
                             std::vector<Figure>& figures) {
  Result<void> done;
  const auto open_and_reset = [&]() -> Result<void> {
    MARKETGEN_TRY(store::Store store, store::open_store(folder, *catalog));
    MARKETGEN_TRY(auto ground,
                  environments::EpisodeGround::of_store(
                      std::make_shared<const store::Store>(std::move(store)), catalog));
    MARKETGEN_TRY(Bench bench, Bench::begin(ground, spec));
    return bench.reset();
  };
  const double seconds = median_seconds(reset_runs, [&] { done = open_and_reset(); });
  figures.push_back(figure("environment_aisle_first_reset_s", seconds, "s", reset_runs));
  return done;
}

}  // namespace

Figures run_environment(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch / "store";
  const auto rows = std::make_shared<const catalog::Catalog>(catalog);
  MARKETGEN_TRY(const store::Created created,
                store::create_store(neighbourhood_store(folder, false), catalog));
  MARKETGEN_TRY(store::Store opened, store::open_store(folder, catalog));
  const auto store = std::make_shared<const store::Store>(std::move(opened));
  MARKETGEN_TRY(const auto ground, environments::EpisodeGround::of_store(store, rows));
  std::vector<Figure> figures;
  MARKETGEN_TRY(episodes::EpisodeSpec basket, ground->draw(episodes::Track::checkout, 1));
  MARKETGEN_TRY(Bench counter, Bench::begin(ground, std::move(basket)));
  MARKETGEN_CHECK(add_resets("checkout", counter, figures));
  MARKETGEN_CHECK(add_steps("checkout", counter, figures));
  MARKETGEN_CHECK(add_memory(counter, figures));
  MARKETGEN_TRY(const episodes::EpisodeSpec errand, aisle_episode(*ground, *store));
  MARKETGEN_TRY(Bench aisles, Bench::begin(ground, errand));
  MARKETGEN_CHECK(add_resets("aisle", aisles, figures));
  MARKETGEN_CHECK(add_steps("aisle", aisles, figures));
  MARKETGEN_CHECK(add_first_reset(folder, rows, errand, figures));
  return figures;
}

}  // namespace marketgen::bench
