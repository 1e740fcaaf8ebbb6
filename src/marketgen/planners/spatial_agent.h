// The agent for the floor: from words and pictures to openings, a BSP tree, zones and relations.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/brief.h"
#include "llm/structured_answer.h"
#include "plan/plan.h"
#include "planners/shown_pictures.h"

namespace marketgen::planners {

// What the spatial agent answers.
struct FloorProposal {
  struct ProposedZone {
    std::string id, type, label;
    double area_m2 = 20;

    static constexpr auto fields = field_list(
        field("id",
              &ProposedZone::id,
              "short id, unique among zones and openings",
              required(),
              identifier()),
        field("type", &ProposedZone::type, "one of the listed zone types", required()),
        field("label", &ProposedZone::label, "sign over the zone", at_most_bytes(80)),
        field(
            "area_m2", &ProposedZone::area_m2, "floor area wanted", range(0.5, 40000), required()));
  };

  std::string profile, style;  // of the catalogue
  int width_mm = 24000, depth_mm = 15000;
  std::vector<plan::Opening> openings;
  std::vector<plan::Node> nodes;
  std::vector<ProposedZone> zones;
  std::vector<plan::Relation> relations;
  std::string reason;

  static constexpr auto fields = field_list(
      field("profile", &FloorProposal::profile, "one of the listed profiles", required()),
      field("style", &FloorProposal::style, "one of the listed styles", required()),
      field(
          "width_mm", &FloorProposal::width_mm, "room, east-west", range(4000, 200000), required()),
      field("depth_mm",
            &FloorProposal::depth_mm,
            "room, north-south",
            range(4000, 200000),
            required()),
      field(
          "openings", &FloorProposal::openings, "doors and windows", required(), at_most_items(40)),
      field("nodes",
            &FloorProposal::nodes,
            "BSP tree, the root first",
            required(),
            at_most_items(64)),
      field("zones", &FloorProposal::zones, "what is where", required(), at_most_items(24)),
      field("relations",
            &FloorProposal::relations,
            "places that the words ask for",
            required(),
            at_most_items(200)),
      field("reason",
            &FloorProposal::reason,
            "two sentences: why this floor",
            required(),
            at_most_bytes(1200)));
};

// What agents are told: the words, the offline planner's plan of them, and the pictures, which the
// spatial agent sees.
struct Assignment {
  const intake::Brief& brief;
  const intake::Planned& offline;
  const catalog::Catalog& catalog;
  const std::vector<ShownPicture>& pictures;
};

// A whole plan: its floor is the model's, each zone has its type's usual fixtures and goods until a
// semantic agent says otherwise. Size, name, profile and look stay as the offline planner has them
// where flags, words or photos said so, and so does the whole floor of a drawing of zones, with the
// doors of any drawing; whatever is the model's has the source `llm`. An answer that makes
// no valid plan goes back once with what is wrong. Errors: llm.bad_answer; those of LanguageModel.
Result<plan::Plan> plan_floor(const llm::LanguageModel& model, const Assignment& assignment);

// The same from an answer that has come. Errors: those of validate_plan.
Result<plan::Plan> plan_of(const FloorProposal& proposal, const Assignment& assignment);

// The words of a person within marks that they cannot forge, for a model to read as wishes.
std::string quoted_wishes(const intake::Brief& brief);

}  // namespace marketgen::planners
