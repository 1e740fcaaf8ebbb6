// One task as data: market-episode/1, and the file that holds many of them.
//
// An episodes file is JSON Lines. The first line is its header (market-episodes/1) with the stores'
// plans and the rows of every product that lies in a basket; each further line is one episode. With
// the program's own data nothing else is needed to run it.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/product.h"
#include "episodes/certificate.h"
#include "episodes/track.h"
#include "geometry/pose.h"
#include "plan/plan.h"

namespace marketgen::episodes {

// An item of the basket. The pose is basket_from_product, as it lies when the episode begins; the
// basket's frame is that of its inner floor (physics/settle/bulk_settle.h).
struct EpisodeItem {
  std::string sku;
  std::array<double, 3> position_m{};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};

  static constexpr auto fields = field_list(
      field("sku", &EpisodeItem::sku, "product", identifier()),
      field("position_m", &EpisodeItem::position_m, "in the basket's frame", range(-2, 2)),
      field("rotation_wxyz", &EpisodeItem::rotation_wxyz, "unit quaternion", range(-1.001, 1.001)));
  static EpisodeItem at(std::string sku, const Pose& pose) {
    const Vec3& p = pose.position;
    const Quaternion& q = pose.rotation;
    return {std::move(sku), {p.x, p.y, p.z}, {q.w, q.x, q.y, q.z}};
  }
  Pose pose() const {
    return {{position_m[0], position_m[1], position_m[2]},
            {rotation_wxyz[0], rotation_wxyz[1], rotation_wxyz[2], rotation_wxyz[3]}};
  }
};

// How an agent is told what is asked for. ids: by SKU. words: by words that fit one product on
// offer; of SKUs it is told nothing.
enum class Instructions { ids, words };
constexpr std::array<std::string_view, 2> names_of(Instructions) {
  return {"ids", "words"};
}

// Where goals of In-Aisle Item Collection stand. none: before them is no door. hinged: behind doors
// on upright hinges, which the agent opens and shuts again.
enum class Doors { none, hinged };
constexpr std::array<std::string_view, 2> names_of(Doors) {
  return {"none", "hinged"};
}

// So many of this product, whichever of them.
struct EpisodeGoal {
  std::string sku;
  int count = 1;
  std::optional<std::string> text = {};  // instructions in words: what the agent is told of it
  static constexpr auto fields =
      field_list(field("sku", &EpisodeGoal::sku, "product", identifier()),
                 field("count", &EpisodeGoal::count, "how many", range(1, 100)),
                 field("text",
                       &EpisodeGoal::text,
                       "with instructions in words: how it is named to the agent",
                       at_most_bytes(400)));
};

// Where products of a goal's category stand: what the agent knows beforehand.
struct CategoryPlace {
  std::string sku, category;
  double x_m = 0, y_m = 0;
  static constexpr auto fields =
      field_list(field("sku", &CategoryPlace::sku, "of the goal", identifier()),
                 field("category", &CategoryPlace::category, "of that product"),
                 field("x_m", &CategoryPlace::x_m, "middle of its products in the store, east"),
                 field("y_m", &CategoryPlace::y_m, "north"));
};

struct EpisodeSpec {
  std::string schema = "market-episode/1";
  std::string id;
  Track track = Track::checkout;
  std::string store, scene_hash, plan_hash;
  std::string robot, tools;
  std::optional<std::string> station;     // the counter of Checkout Unloading when absent
  std::optional<std::string> lane;        // a room of its own when absent
  std::optional<Doors> doors;             // none when absent
  std::optional<std::string> difficulty;  // standard when absent
  std::uint64_t seed = 0;
  std::string instruction;
  Instructions instructions = Instructions::ids;
  std::vector<EpisodeItem> items;
  std::vector<EpisodeGoal> goals;
  bool look_alikes = false;
  FloorPlaceRow start;
  std::vector<CategoryPlace> categories;
  std::vector<std::string> cameras;
  double limit_s = 180;
  EpisodeCertificate certificate;

  static constexpr auto fields = field_list(
      field("schema", &EpisodeSpec::schema, "schema tag", constant("market-episode/1")),
      field("id", &EpisodeSpec::id, "unique in its file", identifier()),
      field("track", &EpisodeSpec::track, "what kind of task"),
      field("store", &EpisodeSpec::store, "its name", required()),
      field("scene_hash", &EpisodeSpec::scene_hash, "of the store's scene", required()),
      field("plan_hash", &EpisodeSpec::plan_hash, "SHA-256 of the store's plan", required()),
      field("robot", &EpisodeSpec::robot, "row in data/robots", required()),
      field("tools",
            &EpisodeSpec::tools,
            "a tool set of market-checkout/1 or market-aisle/1, the first when empty",
            reference()),
      field("station",
            &EpisodeSpec::station,
            "checkout: a row of data/benchmark, that of Checkout Unloading when absent",
            reference()),
      field("lane",
            &EpisodeSpec::lane,
            "checkout: the fixture of the store where it happens; a room of its own when absent",
            reference()),
      field("doors",
            &EpisodeSpec::doors,
            "aisle: what goals stand behind, and is to be opened and shut again; none when absent"),
      field("difficulty",
            &EpisodeSpec::difficulty,
            "with which dials it was drawn: a row of data/benchmark/difficulty, or own- and the "
            "hash of a user's own; standard when absent",
            reference()),
      field("seed", &EpisodeSpec::seed, "of what the policy draws"),
      field("instruction", &EpisodeSpec::instruction, "what the agent is told", required()),
      field("instructions", &EpisodeSpec::instructions, "how goals are told: by SKU or in words"),
      field("items", &EpisodeSpec::items, "checkout: what lies in the basket", at_most_items(64)),
      field("goals", &EpisodeSpec::goals, "what is to be done", required(), at_most_items(16)),
      field(
          "look_alikes",
          &EpisodeSpec::look_alikes,
          "something in the basket, or on the shelf within a metre of a goal, is easily taken for "
          "a goal (not told of aisles by files of before)"),
      field("start", &EpisodeSpec::start, "aisle: where the robot stands"),
      field("categories",
            &EpisodeSpec::categories,
            "aisle: where products of the goals' categories are",
            at_most_items(16)),
      field("cameras", &EpisodeSpec::cameras, "that the agent has", at_most_items(16)),
      field("limit_s", &EpisodeSpec::limit_s, "simulated seconds", range(1, 3600)),
      field("certificate", &EpisodeSpec::certificate, "what is known to be possible"));
};

inline Doors doors_of(const EpisodeSpec& spec) {
  return spec.doors.value_or(Doors::none);
}

struct EpisodeExclusion {
  std::string reason;
  int products = 0;
  static constexpr auto fields =
      field_list(field("reason", &EpisodeExclusion::reason, "why no task asks for them"),
                 field("products", &EpisodeExclusion::products, "how many", range(0, 1e6)));
};

// A checkout lane at which no task happens.
struct LaneExclusion {
  std::string lane, reason;
  static constexpr auto fields =
      field_list(field("lane", &LaneExclusion::lane, "id of its fixture", required()),
                 field("reason", &LaneExclusion::reason, "what stands in the way", required()));
};

// What of a store no task is about.
struct EpisodeExclusions {
  int on_offer = 0;
  std::vector<EpisodeExclusion> left_out;
  std::optional<std::vector<LaneExclusion>> lanes = {};  // of a track that happens at lanes
  static constexpr auto fields = field_list(
      field("on_offer", &EpisodeExclusions::on_offer, "products on its shelves", range(0, 1e6)),
      field("left_out", &EpisodeExclusions::left_out, "of these, by reason", at_most_items(64)),
      field("lanes",
            &EpisodeExclusions::lanes,
            "checkout: lanes where the robot has no room",
            at_most_items(1000)));
};

// The store's scene as a file beside the episodes (episodes/frozen_store.h).
struct FrozenScene {
  std::string file, sha256;
  static constexpr auto fields = field_list(
      field("file", &FrozenScene::file, "below the folder of the episodes' file", required()),
      field("sha256", &FrozenScene::sha256, "of its bytes", required()));
};

struct EpisodeStore {
  std::string name, scene_hash, plan_hash;
  std::uint64_t seed = 0;
  plan::Plan plan;
  EpisodeExclusions exclusions = {};
  std::optional<std::vector<catalog::Product>> own =
      {};                                 // rows of the user's own that it was made with
  std::optional<FrozenScene> scene = {};  // of frozen episodes; read: with the file's whole path
  static constexpr auto fields =
      field_list(field("name", &EpisodeStore::name, "the store's name", required()),
                 field("scene_hash", &EpisodeStore::scene_hash, "of its scene", required()),
                 field("plan_hash", &EpisodeStore::plan_hash, "SHA-256 of the plan", required()),
                 field("seed", &EpisodeStore::seed, "with which it was made"),
                 field("plan", &EpisodeStore::plan, "what the store is", required()),
                 field("exclusions", &EpisodeStore::exclusions, "what no task asks for"),
                 field("own", &EpisodeStore::own, "rows of the user's own that it was made with"),
                 field("scene",
                       &EpisodeStore::scene,
                       "of frozen episodes: it is opened rather than made again from the plan"));
};

// What of the episodes a policy has not seen that was trained on other files of episodes
// (episodes/training_set.h). products: no goal is one of theirs, or easily taken for one.
enum class Unseen { products, layouts, looks };
constexpr std::array<std::string_view, 3> names_of(Unseen) {
  return {"products", "layouts", "looks"};
}

struct UnseenRow {
  std::vector<Unseen> what;
  std::string training;
  static constexpr auto fields = field_list(
      field("what", &UnseenRow::what, "products, layouts, looks", required(), at_most_items(3)),
      field("training", &UnseenRow::training, "hash of what is in the training files", required()));
};

struct EpisodeHeader {
  std::string schema = "market-episodes/1";
  std::uint64_t seed = 0;
  int episodes = 0;
  Split split = Split::planned;
  std::optional<DrawShares> drawn = {};
  std::vector<EpisodeStore> stores;
  std::vector<catalog::Product> products;
  std::optional<std::string> rows_hash = {};  // of frozen episodes
  std::optional<UnseenRow> unseen = {};
  static constexpr auto fields = field_list(
      field("schema", &EpisodeHeader::schema, "schema tag", constant("market-episodes/1")),
      field("seed", &EpisodeHeader::seed, "with which they were drawn"),
      field("episodes", &EpisodeHeader::episodes, "lines that follow", range(0, 1e6)),
      field("split", &EpisodeHeader::split, "what every episode of the file was shown to be"),
      field("drawn", &EpisodeHeader::drawn, "how many were drawn for these, and why others not"),
      field("stores", &EpisodeHeader::stores, "where the goods are from"),
      field("products", &EpisodeHeader::products, "rows of what lies in the baskets"),
      field("rows_hash",
            &EpisodeHeader::rows_hash,
            "of frozen episodes: over the rows of stations, robots and friction that they were "
            "drawn with"),
      field("unseen",
            &EpisodeHeader::unseen,
            "what of them a policy has not seen that was trained on other episodes"));
};

struct EpisodeFile {
  EpisodeHeader header;
  std::vector<EpisodeSpec> episodes;
  std::string set = {};  // that comes with the program, by its name; empty: it is none of them
};

// Of all that their certificates say.
DrawShares draw_shares(const std::vector<EpisodeSpec>& episodes);

// Of what lies in its basket and of what it asks for, each once.
std::set<std::string> skus_of(const EpisodeSpec& spec);

std::string plan_hash(const plan::Plan& plan);  // SHA-256 of its JSON
// 32 hex digits over all that decides what becomes of the episode: itself and the rows of its
// products.
std::string episode_hash(const EpisodeHeader& header, const EpisodeSpec& spec);

// Errors: of read_json, at "FILE:LINE"; episode.truncated when lines are missing or the last one
// breaks off; those of check_episodes (episodes/check_episodes.h).
Result<EpisodeFile> read_episodes(std::string_view text, const std::string& source);
// A file, packed with gzip or not, or a set by its name (episodes/episode_sets.h); "-": standard
// input. Errors: those of find_episode_file, check_set_file, read_file, gunzip, read_episodes,
// data_folder, check_robots and check_frozen.
Result<EpisodeFile> read_episode_file(const std::filesystem::path& file);
std::string write_episodes(const EpisodeFile& file);

// Error: episode.other_store when the store is not the one that the episode was drawn from.
Result<void> check_store(const EpisodeSpec& spec,
                         const std::string& scene_hash,
                         const std::string& plan_hash);

}  // namespace marketgen::episodes
