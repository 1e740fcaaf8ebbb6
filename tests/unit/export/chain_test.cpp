// The whole chain over every value of market-plan/1: plan, layout, scene, its file, both exports, a
// picture and a world of physics. Made for the sanitizers: what is checked here is that each stage
// takes what the one before it may give.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string_view>

#include "export/export.h"
#include "io/json.h"
#include "layout/layout.h"
#include "physics/world/world.h"
#include "render/render.h"
#include "scene/scene_file.h"
#include "support/plan_sampler.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// Chains that one test runs; with MARKETGEN_CHAINS=all every round of the sampler.
constexpr std::size_t parts = 4, usual_rounds = 6;

std::size_t rounds_of_a_part(const PlanSampler& sampler) {
  const char* wanted = std::getenv("MARKETGEN_CHAINS");
  const bool all = wanted != nullptr && std::string_view(wanted) == "all";
  return all ? (sampler.rounds() + parts - 1) / parts : usual_rounds;
}

class Chain : public testing::TestWithParam<std::size_t> {
 protected:
  Chain() {
    folder_ = fs::temp_directory_path() /
              ("marketgen-chain-" + std::to_string(getpid()) + "-" + std::to_string(GetParam()));
    fs::create_directories(folder_);
  }
  ~Chain() override { fs::remove_all(folder_); }

  void expect_file(const scene::Scene& scene) const {
    const std::string bytes = scene::encode_scene(scene);
    const auto read = scene::decode_scene(std::as_bytes(std::span(bytes)), "scene.bin");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(scene::scene_hash(*read), scene::scene_hash(scene));
    EXPECT_EQ(scene::look_hash(*read), scene::look_hash(scene));
  }

  void expect_exports(const scene::Scene& scene) const {
    exporters::ExportOptions options;
    options.camera_spacing_m = 5, options.picture_px = {64, 36};  // few pixels, for time
    for (const exporters::ExportFormat& format : exporters::export_formats()) {
      const fs::path file = folder_ / ("shop" + std::string(format.extension));
      const auto written = exporters::export_scene(scene, format.name, file, options);
      ASSERT_TRUE(written.ok()) << format.name << ": " << to_string(written.error());
      const auto read = exporters::check_export(scene, format.name, file, options);
      EXPECT_TRUE(read.ok()) << format.name << ": " << to_string(read.error());
    }
  }

  void expect_picture(const scene::Scene& scene) const {
    const auto renderer =
        render::Renderer::create(scene, silent_progress(), {.print = render::PrintDetail::distant});
    ASSERT_TRUE(renderer.ok()) << to_string(renderer.error());
    const auto camera = render::camera_named(scene, "top", 48, 32);
    ASSERT_TRUE(camera.ok()) << to_string(camera.error());
    render::RenderOptions options;
    options.quality = render::Quality::fast;
    options.hide_ceiling = true;
    const auto frame = (*renderer)->render(*camera, options, silent_progress());
    EXPECT_TRUE(frame.ok()) << to_string(frame.error());
  }

  void expect_world(const scene::Scene& scene) const {
    auto world = physics::World::create(scene, {});
    ASSERT_TRUE(world.ok()) << to_string(world.error());
    const auto first = static_cast<std::uint32_t>(scene.products.size() / 2);
    EXPECT_EQ(world->wake(first).ok(), !scene.products.empty());
    EXPECT_TRUE(world->step(20).ok());
  }

  // Whether the plan has a layout; all that follows from one must hold.
  bool run(const plan::Plan& plan, std::uint64_t seed) const {
    const auto layout = layout::make_layout(plan, committed_catalog(), Seed(seed));
    if (!layout.ok()) {  // or a module has measures with which its kind cannot be built
      const bool module = layout.error().where.find("/fixture/") != std::string::npos;
      EXPECT_EQ(layout.error().code, module ? "plan.bad_value" : "layout.impossible")
          << to_string(layout.error());
      return false;
    }
    const auto scene = scene::build_scene(*layout, plan, committed_catalog(), Seed(seed));
    EXPECT_TRUE(scene.ok()) << to_string(scene.error());
    if (!scene.ok()) return false;
    expect_file(*scene);
    expect_exports(*scene);
    expect_picture(*scene);
    expect_world(*scene);
    return true;
  }

  fs::path folder_;
};

TEST_P(Chain, TakesEveryValueOfAPlan) {
  PlanSampler sampler;
  const std::size_t rounds = rounds_of_a_part(sampler);
  // Rounds far apart: each takes other values.
  const std::size_t apart = std::max<std::size_t>(1, sampler.rounds() / (parts * rounds));
  std::size_t made = 0;
  for (std::size_t i = 0; i < rounds; ++i) {
    const std::size_t round = (GetParam() * rounds + i) * apart;
    const plan::Plan plan = sampler.plan(round);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + io::write_json_line(plan));
    made += run(plan, round) ? 1 : 0;
    if (HasFailure()) break;
  }
  EXPECT_GE(6 * made, rounds);  // counts of none, and of more than fit, leave no layout
}

INSTANTIATE_TEST_SUITE_P(, Chain, testing::Range<std::size_t>(0, parts), [](const auto& part) {
  return "Part" + std::to_string(part.param);
});

// Rooms of glass: materials that are rare enough for samples to miss them, four of them a room.
TEST_P(Chain, RoomsOfGlass) {
  const std::vector<catalog::MaterialRow>& rows = committed_catalog().materials;
  std::vector<std::string> clear;
  for (const catalog::MaterialRow& row : rows) {
    if (row.transmission > 0) clear.push_back(row.id);
  }
  ASSERT_GE(clear.size(), 3U);
  plan::Plan plan = sampled_shop();
  const std::array surfaces{
      &plan.look.floor, &plan.look.wall, &plan.look.ceiling, &plan.look.fixture};
  for (std::size_t room = GetParam(); room * surfaces.size() < clear.size(); room += parts) {
    std::string materials;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      *surfaces[i] = clear[(room * surfaces.size() + i) % clear.size()];
      materials += *surfaces[i] + " ";
    }
    SCOPED_TRACE(materials);
    EXPECT_TRUE(run(plan, room));
  }
}

// What the sampler promises: a value that no plan ever takes would be tested by nobody.
TEST(PlanSampler, EveryValueIsPartOfSomePlan) {
  PlanSampler sampler;
  for (std::size_t round = 0; round < sampler.rounds(); ++round)
    sampler.plan(round);
  std::size_t values = 0;
  std::vector<std::string> never;
  for (const PlanSampler::Knob& knob : sampler.knobs()) {
    for (std::size_t i = 0; i < knob.count; ++i) {
      ++values;
      if (knob.taken[i] == 0) never.push_back(knob.path + " #" + std::to_string(i));
    }
  }
  EXPECT_GT(values, 700U);
  std::string list;
  for (const std::string& value : never)
    list += value + "\n";
  EXPECT_LT(20 * never.size(), values) << list;
}

}  // namespace
}  // namespace marketgen
