#include "server/store_summary.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "catalog/country.h"
#include "render/cameras/camera.h"
#include "render/stage/room.h"
#include "scene/articulation.h"

namespace marketgen::server {
namespace {

constexpr double not_studied = -1;  // a pick rate

std::array<double, 3> numbers(Vec3 v) {
  return {v.x, v.y, v.z};
}

std::string folder_name(const store::Store& store) {
  return store.folder.lexically_normal().filename().empty()
             ? store.folder.lexically_normal().parent_path().filename().string()
             : store.folder.filename().string();
}

std::vector<ViewOpening> openings_in(const render::raytrace::Room& room) {
  std::vector<ViewOpening> openings;
  for (const render::raytrace::WallEdge& wall : room.walls) {
    for (const render::raytrace::WallOpening& o : wall.openings) {
      const Vec3f low = wall.world_from_wall({o.low, 0, o.sill});
      const Vec3f high = wall.world_from_wall({o.high, 0, o.head});
      openings.push_back({o.kind, {low.x, low.y, low.z}, {high.x, high.y, high.z}});
    }
  }
  return openings;
}

std::vector<ViewCamera> cameras_of(const scene::Scene& scene) {
  constexpr int width = 1280, height = 720;
  std::vector<ViewCamera> cameras;
  for (const render::Camera& camera : render::standard_cameras(scene, width, height))
    cameras.push_back({camera.name,
                       numbers(camera.from),
                       numbers(camera.at),
                       camera.fov_deg,
                       camera.ortho_height_m});
  return cameras;
}

double pick_rate(const std::vector<CardGrasp>& grasps) {
  double best = not_studied;
  for (const CardGrasp& grasp : grasps)
    best = std::max(best, grasp.tries == 0 ? 0 : grasp.held / static_cast<double>(grasp.tries));
  return best;
}

std::vector<ViewJoint> joints_of(const scene::Scene& scene) {
  std::vector<ViewJoint> rows;
  for (std::uint32_t i = 0; i < scene.joints.size(); ++i) {
    const scene::SceneJoint& joint = scene.joints[i];
    const Pose world_from_joint =
        scene::world_from_fixture(scene, joint.fixture) * scene::fixture_from_joint(joint);
    rows.push_back({i,
                    joint.fixture,
                    joint.name,
                    joint.kind,
                    joint.parent,
                    numbers(world_from_joint.position),
                    numbers(rotate(world_from_joint.rotation, {0, 0, 1})),
                    joint.lower,
                    joint.upper,
                    joint.states});
  }
  return rows;
}

}  // namespace

std::vector<ViewFixture> fixtures_of(const scene::Scene& scene, const catalog::Catalog& catalog) {
  std::vector<ViewFixture> rows;
  for (std::uint32_t i = 0; i < scene.fixtures.size(); ++i) {
    const layout::Fixture& f = scene.layout.fixtures[i];
    const catalog::FixtureKind* kind = catalog.fixture_kind(f.kind);
    rows.push_back({i,
                    f.id,
                    f.kind,
                    kind != nullptr ? kind->generator : f.kind,
                    f.zone,
                    f.run,
                    numbers(scene::world_from_fixture(scene, i).position),
                    {f.width_mm * 1e-3, f.depth_mm * 1e-3, f.height_mm * 1e-3},
                    f.yaw_deg,
                    f.levels});
  }
  return rows;
}

std::vector<ViewSku> skus_of(const scene::Scene& scene,
                             const std::vector<std::uint32_t>& rows,
                             const GraspFacts& grasps,
                             const std::vector<catalog::FrictionRow>& frictions) {
  std::vector<std::uint64_t> counts(scene.catalog.size(), 0);
  for (const scene::SceneProduct& item : scene.products)
    ++counts[item.sku];
  std::vector<ViewSku> skus;
  for (const std::uint32_t row : rows) {
    const catalog::Product& p = scene.catalog[row];
    skus.push_back({p.sku,
                    p.ean,
                    p.name,
                    p.name_zh,
                    p.brand,
                    p.variant,
                    p.category,
                    p.price,
                    std::string(catalog::country_of(p).currency),
                    {p.width_m(), p.depth_m(), p.height_m()},
                    p.mass_kg,
                    pick_rate(grasps_of(p, grasps, frictions)),
                    p.label.primary,
                    counts[row]});
  }
  return skus;
}

std::vector<ViewOpening> openings_of(const scene::Scene& scene) {
  return openings_in(render::raytrace::room_of(scene.layout.shell));
}

StoreLine line_of(int number, const store::Store& store) {
  return {number,
          store.manifest.name,
          folder_name(store),
          store.manifest.scene_hash,
          store.manifest.brief.prompt,
          store.manifest.seed,
          store.scene.products.size()};
}

StoreSummary summary_of(int number,
                        const store::Store& store,
                        const GraspFacts& grasps,
                        const catalog::Catalog& catalog,
                        const PageRights& rights) {
  const scene::Scene& scene = store.scene;
  const plan::Shell& shell = scene.layout.shell;
  const render::raytrace::Room room = render::raytrace::room_of(shell);
  StoreSummary summary;
  summary.store = number;
  summary.may_edit = rights.edit;
  summary.may_drive = rights.drive;
  summary.name = store.manifest.name;
  summary.folder = folder_name(store);
  summary.seed = store.manifest.seed;
  summary.profile = scene.layout.profile;
  summary.scene_hash = store.manifest.scene_hash;
  summary.look_hash = store.manifest.look_hash;
  summary.prompt = store.manifest.brief.prompt;
  summary.counts = scene::count(scene);
  summary.ceiling_m = shell.ceiling_mm * 1e-3;
  summary.bounds = {{0, 0, 0}, {shell.width_mm * 1e-3, shell.depth_mm * 1e-3, summary.ceiling_m}};
  summary.outline_mm = room.outline;
  summary.openings = openings_in(room);
  summary.cameras = cameras_of(scene);
  summary.zones = scene.layout.zones;
  summary.aisles = scene.layout.aisles;
  summary.violations = scene.layout.violations;
  summary.fixtures = fixtures_of(scene, catalog);
  summary.joints = joints_of(scene);
  std::vector<std::uint32_t> skus(scene.catalog.size());
  std::iota(skus.begin(), skus.end(), 0);
  summary.skus = skus_of(scene, skus, grasps, catalog.frictions);
  return summary;
}

}  // namespace marketgen::server
