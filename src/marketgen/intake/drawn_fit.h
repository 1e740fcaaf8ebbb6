// How much of a drawing of zones a plan keeps.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "intake/drawn_zones.h"
#include "plan/plan.h"

namespace marketgen::intake {

struct DrawnZoneFit {
  std::string zone;
  double drawn_m2 = 0;
  double iou = 0;
  std::optional<int> drawn_runs, runs;

  static constexpr auto fields = field_list(
      field("zone", &DrawnZoneFit::zone, "zone of the plan; one of that name may be missing there"),
      field("drawn_m2", &DrawnZoneFit::drawn_m2, "its floor on the drawing", range(0.0, 1e6)),
      field("iou",
            &DrawnZoneFit::iou,
            "floor that it has in both, of the floor that it has in either",
            range(0.0, 1.0)),
      field("drawn_runs",
            &DrawnZoneFit::drawn_runs,
            "runs of shelves that are drawn in it; absent: none are",
            range(1, 1000)),
      field(
          "runs", &DrawnZoneFit::runs, "runs in the plan; absent: as many as fit", range(0, 1000)));
};

struct DrawnFit {
  double iou = 0;
  std::vector<DrawnZoneFit> zones;

  static constexpr auto fields =
      field_list(field("iou",
                       &DrawnFit::iou,
                       "over all zones: floor on which drawing and plan have the same zone, of the "
                       "floor on which either has one",
                       range(0.0, 1.0)),
                 field("zones", &DrawnFit::zones, "each zone of the drawing"));
};

// Of the plan as it is, with all that repairs changed. The drawing is stretched to its floor.
DrawnFit drawn_fit(const DrawnZones& drawn, const plan::Plan& plan);

}  // namespace marketgen::intake
