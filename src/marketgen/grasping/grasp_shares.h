// Shares of a grasp study: of how many products a tool took hold, by shape and in all.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "grasping/grasp_study.h"

namespace marketgen::grasping {

// A share with its 95 % interval (Wilson, "Probable inference", JASA 1927).
struct Share {
  int of = 0, number = 0;
  double share = 0, low = 0, high = 0;  // 0..1; 0 of nothing

  static constexpr auto fields = field_list(field("of", &Share::of, "of how many"),
                                            field("number", &Share::number, "how many"),
                                            field("share", &Share::share, "0..1"),
                                            field("low", &Share::low, "95 % interval, Wilson"),
                                            field("high", &Share::high, "95 % interval, Wilson"));
};
Share share_of(int number, int of);

struct ExclusionCount {
  GraspExclusion why = GraspExclusion::none;
  int products = 0;
  static constexpr auto fields =
      field_list(field("why", &ExclusionCount::why, "reason"),
                 field("products", &ExclusionCount::products, "how many"));
};

// One tool in one setting with the products of one shape; all of them where `archetype` is empty.
struct GraspShare {
  std::string tool;
  GraspSetting setting = GraspSetting::free;
  std::string archetype;
  int products = 0;
  Share fit;               // had a candidate, of all products
  Share first, any;        // of those that fit: the best candidate held; one of the tries did
  double slip_p99_mm = 0;  // over best candidates that kept hold, held or slipped
  std::vector<ExclusionCount> excluded;  // reasons that occur
  std::vector<std::string> lost;         // ends of best candidates that did not hold: "slipped 3"

  static constexpr auto fields = field_list(
      field("tool", &GraspShare::tool, "row of the tool"),
      field("setting", &GraspShare::setting, "free, stocked, spaced or basket"),
      field("archetype", &GraspShare::archetype, "container shape; empty = all"),
      field("products", &GraspShare::products, "products of the shape"),
      field("fit", &GraspShare::fit, "products with a candidate"),
      field("first", &GraspShare::first, "of those: the best candidate held"),
      field("any", &GraspShare::any, "of those: one of the tries held"),
      field("slip_p99_mm", &GraspShare::slip_p99_mm, "99th percentile where hold was kept"),
      field("excluded", &GraspShare::excluded, "products without a candidate, by reason"),
      field("lost", &GraspShare::lost, "what became of best candidates that did not hold"));
};

// By tool and setting in the order of `rates`: all shapes together, then each shape by name.
std::vector<GraspShare> grasp_shares(const std::vector<GraspRate>& rates);

}  // namespace marketgen::grasping
