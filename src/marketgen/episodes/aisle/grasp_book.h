// Which products a tool can take off a stocked shelf: looked up, or tried in physics when asked.
// One book serves the samplers of all stores.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "grasping/grasp_study.h"
#include "grasping/grasp_table.h"

namespace marketgen::episodes {

struct StudiedProduct {
  std::vector<int> grasps;  // numbers of the study's candidates that hold it; none when it is not
                            // to be fetched
  std::string why_not;      // then, a word
};

// Any number of threads may ask at once.
class GraspBook {
 public:
  // The study that it makes: a product's candidates until two held or two cannot hold any more.
  static grasping::StudyOptions options();

  // `known`: rates of earlier studies of the same kind, by this program; `shipped`: those that it
  // came with. Neither are made again.
  GraspBook(robots::GraspTool tool,
            std::vector<catalog::FrictionRow> frictions,
            const std::vector<grasping::GraspRate>& known = {},
            grasping::GraspTable shipped = {});

  // A product is fetched when the study holds it in two of three tries, by those of the grasps that
  // also keep it from turning between the pads, or from peeling off the cup, while the arm turns it
  // over. One that no grasp keeps so is not tried. A cup must also seal on the pack as a store has
  // it: one solid, plainer than the study's pieces. Errors: those of study_grasps().
  Result<StudiedProduct> study(const catalog::Product& product);
  // Rates that were not known before, and are not kept yet.
  std::vector<grasping::GraspRate> studied() const;
  // Puts them into the grasp database, once: the next book need not try the same grasps again.
  // Where that cannot be, the log says so. Errors: those of grasp_study_key().
  Result<void> keep(const std::filesystem::path& data, const std::string& catalog_hash);

  const robots::GraspTool& tool() const { return tool_; }
  const std::vector<catalog::FrictionRow>& frictions() const { return frictions_; }

 private:
  Result<grasping::GraspRate> rate(const catalog::Product& product);
  Result<void> leave_sealed(const catalog::Product& product,
                            const std::vector<motion::GraspCandidate>& candidates,
                            std::vector<int>& numbers) const;

  robots::GraspTool tool_;
  std::vector<catalog::FrictionRow> frictions_;
  grasping::GraspTable shipped_;
  mutable std::mutex mutex_;
  std::map<std::string, grasping::GraspRate> rates_;  // by SKU
  std::set<std::string> new_;                         // SKUs
};

// For the tool with which the robot in aisles fetches, with what the grasp database and the shipped
// table know of it.
// `tools`: a tool set of the station, the first when empty. Errors: those of load_aisle_station,
// load_grasp_tool, grasp_study_key, GraspTable::read.
Result<std::shared_ptr<GraspBook>> open_aisle_book(const std::filesystem::path& data,
                                                   const catalog::Catalog& catalog,
                                                   const std::string& tools = {});

}  // namespace marketgen::episodes
