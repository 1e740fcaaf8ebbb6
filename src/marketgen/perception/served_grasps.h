// Grasps of a grasp server: AnyGrasp, GraspNet, or any other that answers in the form of
// perception/grasp_answer.h.
//
// It is sent the part of the picture and of the depth that shows the product and what is round it,
// as GenManip's client sends whole ones: {"colors": rows, "depths": rows, "fx", "fy", "cx", "cy",
// "scale", "dense_mode"}; depth in units of which `scale` are a metre, 0 for none. Of what it
// proposes those are taken that hold the product, as it was found, by the judgement that the
// program's own grasps pass, in the server's order; the program's own stand behind them, and in
// their place when it fails.
#pragma once
#include <memory>

#include "perception/part_server.h"
#include "perception/shelf_grasps.h"

namespace marketgen::perception {

// Where such servers are published: GenManip's.
constexpr const char* grasp_server_path = "/process";

// At a counter.
class ServedGrasps : public GraspSource {
 public:
  // `tool` and `place` must outlive it.
  ServedGrasps(const robots::GraspTool& tool,
               const agent::Workplace& place,
               std::shared_ptr<PartServer> server)
      : tool_(tool), place_(place), server_(std::move(server)), offline_(tool, place) {}
  Result<std::vector<SeenGrasp>> grasps(const GraspQuestion& question) const override;

 private:
  const robots::GraspTool& tool_;
  const agent::Workplace& place_;
  std::shared_ptr<PartServer> server_;
  FittedGrasps offline_;
};

// At shelves.
class ServedShelfGrasps : public ShelfGraspSource {
 public:
  // `tool` must outlive it.
  ServedShelfGrasps(const robots::GraspTool& tool, std::shared_ptr<PartServer> server)
      : tool_(tool), server_(std::move(server)), offline_(tool) {}
  Result<std::vector<SeenGrasp>> grasps(const ShelfGraspQuestion& question) const override;

 private:
  const robots::GraspTool& tool_;
  std::shared_ptr<PartServer> server_;
  FrontGrasps offline_;
};

}  // namespace marketgen::perception
