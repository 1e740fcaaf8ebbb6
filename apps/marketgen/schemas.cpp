// marketgen schemas: writes the JSON Schemas, the FlatBuffers schema and the field tables of the
// docs from the field lists.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "catalog/asset_file.h"
#include "catalog/fixture_kind.h"
#include "catalog/product.h"
#include "command.h"
#include "environments/told_task.h"
#include "episodes/aisle/aisle_station.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/difficulty.h"
#include "episodes/drive_log.h"
#include "episodes/episode_result.h"
#include "episodes/episode_spec.h"
#include "episodes/motion.h"
#include "episodes/realism.h"
#include "evaluation/differences_table.h"
#include "evaluation/generator_table.h"
#include "evaluation/goals_table.h"
#include "evaluation/leaderboard.h"
#include "evaluation/modules_table.h"
#include "evaluation/shapes_table.h"
#include "evaluation/tracks_table.h"
#include "intake/photos_file.h"
#include "io/flatbuffer.h"
#include "io/json.h"
#include "io/output.h"
#include "render/annotations.h"
#include "robots/robot_row.h"
#include "scene/scene_file.h"
#include "shopping/shopping_plan.h"
#include "store/store.h"

namespace marketgen::app {
namespace {

namespace fs = std::filesystem;

struct Document {
  const char* file;
  const char* title;
  const TypeInfo& type;
};

// Stores, what they are made of, and what to buy in them.
std::vector<Document> store_documents() {
  return {
      {"market-plan-1", "What a store should be", type_of<plan::Plan>()},
      {"market-patch-1", "Changes of a plan", type_of<plan::PatchSet>()},
      {"market-layout-1", "Zones, fixtures, aisles and violations", type_of<layout::Layout>()},
      {"market-store-1", "The manifest of a store folder", type_of<store::Manifest>()},
      {"market-report-1",
       "Requirements, rules and metrics of a store",
       type_of<store::StoreReport>()},
      {"market-photos-1",
       "What photos of a shop say, as a store was made with them",
       type_of<intake::PhotosFile>()},
      {"market-product-1", "A product row of the catalogue", type_of<catalog::Product>()},
      {"market-asset-1", "An outside model taken into a library", type_of<catalog::AssetFile>()},
      {"market-fixture-1", "A fixture row of the catalogue", type_of<catalog::FixtureKind>()},
      {"market-shopping-1",
       "What to buy in a store for a request in words",
       type_of<shopping::ShoppingPlan>()}};
}

// Robots, tasks, and what came of them.
std::vector<Document> task_documents() {
  return {
      {"market-robot-1", "A robot, an arm or a tool", type_of<robots::RobotRow>()},
      {"market-aisle-1",
       "The robot of In-Aisle Item Collection",
       type_of<episodes::AisleStation>()},
      {"market-checkout-1",
       "The place of Checkout Unloading",
       type_of<episodes::CheckoutStation>()},
      {"market-realism-1",
       "What stands between the world and a robot",
       type_of<episodes::Realism>()},
      {"market-difficulty-1",
       "How hard the tasks of a file are drawn",
       type_of<episodes::Difficulty>()},
      {"market-episode-1", "One task for a robot", type_of<episodes::EpisodeSpec>()},
      {"market-episodes-1",
       "The first line of an episodes file",
       type_of<episodes::EpisodeHeader>()},
      {"market-task-1", "What of an episode a policy may know", type_of<environments::ToldTask>()},
      {"market-result-1", "What became of an episode", type_of<episodes::EpisodeResult>()},
      {"market-drive-1", "What a person drove", type_of<episodes::DriveLog>()},
      {"market-run-1",
       "Which episodes a folder of results is of",
       type_of<evaluation::RunRecord>()}};
}

// Tables of many runs or stores, and pictures.
std::vector<Document> table_documents() {
  return {
      {"market-leaderboard-1",
       "Policies side by side on the same episodes",
       type_of<evaluation::Leaderboard>()},
      {"market-tracks-1",
       "Policies on all tracks, beside published scores",
       type_of<evaluation::TracksTable>()},
      {"market-shapes-1",
       "Goals by shape, beside published grasps",
       type_of<evaluation::ShapesTable>()},
      {"market-modules-1",
       "Which modules of a policy were first wrong",
       type_of<evaluation::ModulesTable>()},
      {"market-decisions-1",
       "What a policy decided in an episode, beside the truth",
       type_of<evaluation::EpisodeDecisions>()},
      {"market-differences-1",
       "What a change is worth, on the same episodes",
       type_of<evaluation::DifferencesTable>()},
      {"market-goals-1",
       "How much of what stores offer tasks may ask for",
       type_of<evaluation::GoalsTable>()},
      {"market-generator-1",
       "What generated stores are worth, beside published generators",
       type_of<evaluation::GeneratorTable>()},
      {"market-published-1", "Scores that others have published", type_of<evaluation::Published>()},
      {"market-camera-1",
       "Where a picture is taken from, and its lens",
       type_of<render::CameraFile>()},
      {"market-annotations-1",
       "What is to be seen in a picture",
       type_of<render::PictureAnnotations>()}};
}

std::vector<Document> documents() {
  std::vector<Document> all = store_documents();
  for (const auto& more : {task_documents(), table_documents()})
    std::ranges::copy(more, std::back_inserter(all));
  return all;
}

Result<void> write_schemas(const std::string& root) {
  const fs::path schemas = fs::path(root) / "schemas", docs = fs::path(root) / "docs" / "fields";
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add_folder(schemas));
  MARKETGEN_CHECK(outputs.add_folder(docs));
  for (const Document& d : documents()) {
    const std::string name(d.file);
    MARKETGEN_CHECK(outputs.put(schemas / (name + ".schema.json"),
                                io::json_schema_of(d.type, name + ".schema.json", d.title)));
    MARKETGEN_CHECK(
        outputs.put(docs / (name + ".md"),
                    fmt::format("# {}\n\n{}.\n\n{}", name, d.title, io::markdown_of(d.type))));
  }
  MARKETGEN_CHECK(
      outputs.put(schemas / "market-scene-1.fbs",
                  io::flatbuffer_schema_of(type_of<scene::Scene>(), scene::scene_file_identifier)));
  MARKETGEN_CHECK(outputs.put(
      schemas / "market-motion-1.fbs",
      io::flatbuffer_schema_of(type_of<episodes::Motion>(), episodes::motion_file_identifier)));
  return outputs.commit();
}

}  // namespace

Run add_schemas(CLI::App& app) {
  auto root = std::make_shared<std::string>(".");
  CLI::App* command = app.add_subcommand(
      "schemas", "Write schemas/ and docs/fields/ from the program's own field lists");
  add_output(*command, "-o,--output", *root, "folder that has or gets schemas/ and docs/")
      ->capture_default_str();
  command->footer("Example:  marketgen schemas -o .");
  return [root] {
    const auto done = write_schemas(*root);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
