#include "audit/audit.h"

#include "audit/collisions.h"
#include "audit/egress.h"
#include "audit/item_bounds.h"
#include "audit/metrics.h"
#include "audit/requirements.h"
#include "audit/scene_rules.h"
#include "audit/traffic.h"

namespace marketgen::audit {
namespace {

double share_met(const std::vector<RequirementResult>& results) {
  if (results.empty()) return 1;
  std::size_t met = 0;
  for (const RequirementResult& r : results)
    met += r.met ? 1 : 0;
  return static_cast<double>(met) / static_cast<double>(results.size());
}

void add_stock_metrics(Metrics& metrics, const scene::Scene& scene) {
  const scene::SceneCounts counts = scene::count(scene);
  metrics.gross_area_m2 = area_m2(plan::floor_of(scene.layout.shell));
  metrics.selling_area_m2 = selling_area_m2(scene);
  metrics.fill = shelf_fill(scene);
  if (metrics.selling_area_m2 > 0)
    metrics.DENS = static_cast<double>(counts.products) / metrics.selling_area_m2;
  if (counts.skus > 0)
    metrics.facings_per_sku =
        static_cast<double>(counts.facings) / static_cast<double>(counts.skus);
}

}  // namespace

Result<Audit> audit_store(const scene::Scene& scene,
                          const catalog::Catalog& catalog,
                          const std::vector<plan::Requirement>& requirements) {
  MARKETGEN_TRY(const std::vector<Bounds3> bounds, item_bounds(scene));
  MARKETGEN_TRY(const CollisionCount collisions, count_collisions(scene, bounds));
  const std::vector<std::uint32_t> out_of_place = items_out_of_place(scene, bounds);
  const Traffic traffic = measure_traffic(scene);
  const Egress egress = measure_egress(scene.layout);

  Audit audit;
  Metrics& metrics = audit.metrics;
  metrics.colliding_pairs = collisions.colliding_pairs;
  if (collisions.near_pairs > 0)
    metrics.COL = static_cast<double>(collisions.colliding_pairs) /
                  static_cast<double>(collisions.near_pairs);
  metrics.OOB = out_of_place.size();
  metrics.NAV = traffic.largest_share;
  metrics.reachable_shelves = traffic.reachable_shelves;
  metrics.REACH = traffic.reachable_bays;
  add_stock_metrics(metrics, scene);
  audit.requirements = check_requirements(scene, catalog, requirements);
  metrics.prompt = share_met(audit.requirements);
  audit.rules = scene.layout.violations;
  for (layout::Violation& v :
       check_scene({scene, metrics, collisions, traffic, out_of_place, egress, catalog}))
    audit.rules.push_back(std::move(v));
  return audit;
}

}  // namespace marketgen::audit
