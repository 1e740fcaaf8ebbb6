// What stands between the world and the robot: sensors that err, commands that come late, a place
// that is not quite as its row says. An episode is the same task at any realism; whoever runs it
// chooses one, and results say which.
//
// Five are rows, data/benchmark/realism/NAME.json: `ideal` (nothing), `standard` (a robot that was
// calibrated and maintained), `hard` (one that was not), `crowded` (standard, with people in the
// aisles) and `randomized` (for learning: the goods themselves are other in each episode, too). All
// that is drawn comes from named streams of the episode's seed and the number of the control step,
// so the same actions give the same bytes by any door, on any number of threads. What is drawn once
// an episode: the lamps' light, each camera's error of calibration, how late commands, pictures and
// readings are, the odometry's errors of scale, where the map has fixtures, where the basket
// stands.
//
// Sources are named at each field; "assumed" is our own estimate, which nobody has measured.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"
#include "episodes/perturbation_sizes.h"

namespace marketgen::episodes {

// Depth as a stereo camera measures it (render/sensor/depth_noise.h, which has the sources).
struct DepthDials {
  bool stereo = false;
  double disparity_noise_px = 0;
  double edge_shift_px = 0;
  double glass_holes = 0, clear_holes = 0;
  static constexpr auto fields = field_list(
      field("stereo",
            &DepthDials::stereo,
            "as two eyes 50 mm apart measure it: steps of 1/32 px of disparity, shadows beside "
            "near things, no depth of what is too near, overexposed or metal at a glance; false: "
            "exact, and the other dials of depth do nothing"),
      field("disparity_noise_px",
            &DepthDials::disparity_noise_px,
            "pixels, one sigma, alike within windows of 7 px; at z metres z^2 / (fx 0.05 m) times "
            "as many metres; Grunnet-Jepsen et al., Intel: 0.08 is usual for a D435",
            range(0, 2)),
      field("edge_shift_px",
            &DepthDials::edge_shift_px,
            "pixels, one sigma, by which edges are measured aside; Handa et al. 2014",
            range(0, 5)),
      field("glass_holes",
            &DepthDials::glass_holes,
            "share of panes of glass without depth, in patches; assumed, after Sajjan et al. 2020",
            range(0, 1)),
      field("clear_holes",
            &DepthDials::clear_holes,
            "share of clear packs without depth, in patches; the rest has three times the noise; "
            "assumed, after Sajjan et al. 2020",
            range(0, 1)));
};

// Colour as a small sensor records it (render/sensor/color_noise.h).
struct ColorDials {
  double full_well_e = 0;
  static constexpr auto fields =
      field_list(field("full_well_e",
                       &ColorDials::full_well_e,
                       "electrons of a pixel at white, which make its shot noise; fewer are "
                       "noisier; 0: no noise. EMVA 1288; 4,500 assumed for pixels of 1.4 um",
                       range(0, 1e6)));
};

// The lamps of the place against what cameras are set to, alike for all cameras
// (render/sensor/lamp_light.h). Drawn evenly, once an episode.
struct LightDials {
  double stops = 0, mired = 0;
  static constexpr auto fields = field_list(
      field("stops",
            &LightDials::stops,
            "brighter or darker by so much at most, a stop being twice; assumed: lamps that are "
            "cleaned and replaced at 0.8 of what they gave as new, their maintenance factor after "
            "CIE 97, are 0.3 stops",
            range(0, 3)),
      field("mired",
            &LightDials::mired,
            "warmer or colder by so much at most, in millionths of a reciprocal kelvin (250 are "
            "4000 K); ANSI C78.377: lamps sold as 4000 K have 3985 +- 275 K, which is 17",
            range(0, 100)));
};

// Where a camera is, against what the agent is told. About as much along and about each axis.
struct CalibrationDials {
  double camera_m = 0, camera_deg = 0;
  static constexpr auto fields = field_list(
      field("camera_m",
            &CalibrationDials::camera_m,
            "metres, one sigma along each axis, of each camera, once an episode; assumed: what "
            "hand-eye calibration with a printed board leaves",
            range(0, 0.2)),
      field(
          "camera_deg",
          &CalibrationDials::camera_deg,
          "degrees, one sigma about each axis, of each camera, once an episode; assumed, likewise",
          range(0, 20)));
};

// What the robot reads of its own joints, each control step anew.
struct JointDials {
  double turn_deg = 0, turn_deg_s = 0, slide_m = 0, slide_m_s = 0, external_force_n = 0;
  static constexpr auto fields = field_list(
      field("turn_deg",
            &JointDials::turn_deg,
            "degrees, one sigma, of each joint that turns; assumed: play of a geared joint whose "
            "encoder is on the motor",
            range(0, 10)),
      field("turn_deg_s",
            &JointDials::turn_deg_s,
            "degrees a second, one sigma, of their speeds; assumed",
            range(0, 100)),
      field("slide_m",
            &JointDials::slide_m,
            "metres, one sigma, of each joint that slides (the lift); assumed",
            range(0, 0.1)),
      field("slide_m_s",
            &JointDials::slide_m_s,
            "metres a second, one sigma, of their speeds; assumed",
            range(0, 1)),
      field("external_force_n",
            &JointDials::external_force_n,
            "newton, one sigma, of what presses on an arm by the torques of its joints; assumed: "
            "what noise and friction in the joints leave of it",
            range(0, 100)));
};

// How late something is. Drawn evenly once an episode: a bus or a camera with a fixed cycle.
struct LatenessDials {
  double min_s = 0, max_s = 0;
  static constexpr auto fields = field_list(
      field("min_s", &LatenessDials::min_s, "seconds, rounded to steps of physics", range(0, 0.5)),
      field("max_s", &LatenessDials::max_s, "seconds, no less", range(0, 0.5)));
};

// What stands between the robot and its policy. Until something older is there than the episode,
// its beginning is told.
struct LatencyDials {
  LatenessDials commands, images, readings;
  static constexpr auto fields = field_list(
      field("commands",
            &LatencyDials::commands,
            "from an action until the robot's drives hear of it, who go on with the one before "
            "meanwhile; assumed: 20 to 60 ms from a policy's answer over a network and a robot's "
            "own interpolation"),
      field("images",
            &LatencyDials::images,
            "from what a camera sees until its picture is there; assumed: 30 to 80 ms, exposure, "
            "readout, transfer and alignment of an RGB-D camera of 30 pictures a second"),
      field("readings",
            &LatencyDials::readings,
            "from what joints and tools are until their readings are there; what a robot that "
            "drives believes of its place is not among them. Assumed: 2 to 10 ms, a bus"));
};

// What the robot reads of its tools.
struct ToolDials {
  double opening_m = 0, vacuum_s = 0;
  static constexpr auto fields = field_list(
      field("opening_m",
            &ToolDials::opening_m,
            "metres, one sigma, of the openings of grippers, each control step; assumed: play of "
            "fingers whose encoder is on the motor",
            range(0, 0.02)),
      field("vacuum_s",
            &ToolDials::vacuum_s,
            "seconds after which the vacuum sensor of a cup tells of a change, beside the latency "
            "of readings; assumed: a cup and its hose that are evacuated and aired",
            range(0, 0.5)));
};

// The map that an agent is given, against the store.
struct MapDials {
  double place_m = 0;
  static constexpr auto fields = field_list(
      field("place_m",
            &MapDials::place_m,
            "metres by which each run of fixtures stands elsewhere than the map says, to each side "
            "at most, drawn evenly once an episode; assumed: shelves set up by hand after a plan",
            range(0, 0.2)));
};

// Where a robot that drives believes it is. Dead reckoning by its wheels, which a localisation in
// the map corrects every so often; each correction is off, slowly changing.
struct LocalisationDials {
  double distance_share = 0, turn_share = 0;
  double period_s = 0, off_m = 0, off_deg = 0, memory_s = 2;
  static constexpr auto fields = field_list(
      field("distance_share",
            &LocalisationDials::distance_share,
            "one sigma of the share by which distances are reckoned wrong, once an episode: the "
            "wheels' size. Borenstein and Feng 1996 (UMBmark): about 1 % uncalibrated",
            range(0, 0.5)),
      field("turn_share",
            &LocalisationDials::turn_share,
            "one sigma of the share by which turns are reckoned wrong, once an episode: the "
            "wheels' distance; as above",
            range(0, 0.5)),
      field("period_s",
            &LocalisationDials::period_s,
            "seconds between corrections, rounded up to control steps; 0: none, the robot reckons. "
            "AMCL with a lidar of 10 Hz: 0.1",
            range(0, 60)),
      field("off_m",
            &LocalisationDials::off_m,
            "metres, one sigma along each axis, by which corrections are off; Realman, RMC-AIDA-L: "
            "positions to 10 mm",
            range(0, 1)),
      field("off_deg",
            &LocalisationDials::off_deg,
            "degrees, one sigma; Realman, RMC-AIDA-L: headings to 1 degree refined, 3 by itself",
            range(0, 45)),
      field("memory_s",
            &LocalisationDials::memory_s,
            "seconds after which corrections are off by something else (to 1/e); assumed",
            range(0.01, 1000)));
};

// Where the basket at a counter stands with all that lies in it, against the station's row. It
// comes no nearer to the unloading area than the row allows: less of what is drawn then.
struct BasketDials {
  double place_m = 0, turn_deg = 0;
  static constexpr auto fields = field_list(
      field("place_m",
            &BasketDials::place_m,
            "metres to each side at most, drawn evenly once an episode; assumed: set down by hand "
            "on a mark",
            range(0, 0.1)),
      field("turn_deg",
            &BasketDials::turn_deg,
            "degrees about its upright at most, drawn evenly once an episode; assumed, likewise",
            range(0, 45)));
};

// Who else is in the store (episodes/aisle/people_around.h). They walk from shelf to shelf, stop
// before the robot and make room for it.
struct PeopleDials {
  // Shops are reckoned to hold a person on 300 square feet of their floor: 0.036 a square metre
  // (Energy Code for New Federal Buildings, 10 CFR 434.513, table 513.2.a, "Retail").
  double per_m2 = 0.036;
  static constexpr auto fields = field_list(
      field("per_m2",
            &PeopleDials::per_m2,
            "shoppers and staff who walk about in the aisles, on a square metre of the floor that "
            "nothing stands on; rounded down to whole people, 60 at most, and fewer where no more "
            "find room",
            range(0, 0.5)));
};

struct Realism {
  std::string schema = "market-realism/1";
  std::string name = "ideal";
  DepthDials depth;
  ColorDials color;
  LightDials light;
  CalibrationDials calibration;
  JointDials joints;
  ToolDials tools;
  LatencyDials latency;
  LocalisationDials localisation;
  MapDials map;
  BasketDials basket;
  PerturbationSizes goods{.place_m = 0, .turn_deg = 0, .friction = 0, .mass = 0};
  std::optional<PeopleDials> people = {};  // optional: names of one's own dials are their hash

  static constexpr auto fields = field_list(
      field("schema", &Realism::schema, "schema tag", constant("market-realism/1")),
      field("name",
            &Realism::name,
            "of a row: its file's; results name a file of one's own by the hash of its dials",
            identifier()),
      field("depth", &Realism::depth, "what depth cameras measure"),
      field("color", &Realism::color, "what colour cameras record"),
      field("light", &Realism::light, "the lamps of the place"),
      field("calibration", &Realism::calibration, "where cameras are"),
      field("joints", &Realism::joints, "what the robot reads of its joints"),
      field("tools", &Realism::tools, "what the robot reads of its tools"),
      field("latency", &Realism::latency, "how late commands, pictures and readings are"),
      field("localisation", &Realism::localisation, "where a robot that drives believes it is"),
      field("map", &Realism::map, "where fixtures are on the map"),
      field("basket", &Realism::basket, "where the basket at a counter stands"),
      field("goods",
            &Realism::goods,
            "where goods lie or stand, how they rub and what they weigh, once an episode; none of "
            "it is told"),
      field("people", &Realism::people, "who else is in the aisles; nobody when left out"));
};

// A row by its name, or a file of one's own (load_named_dials). Errors: those of it;
// catalog.bad_row for dials that contradict themselves.
Result<Realism> load_realism(const std::filesystem::path& data, const std::string& asked);

// Of all that is drawn for an episode of that seed.
inline Seed realism_seed(std::uint64_t episode_seed) {
  return Seed(episode_seed).child("realism");
}

// Of what is drawn for its goods.
inline Seed goods_seed(std::uint64_t episode_seed) {
  return realism_seed(episode_seed).child("goods");
}

}  // namespace marketgen::episodes
