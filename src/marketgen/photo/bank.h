// The bank of renderings: which shops look like a photo, by the numbers of its parts.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::photo {

// One stage of the reader of parts (photo/parts.h): a perceptron with one hidden layer of rectified
// units, from the numbers of a cell to a score of each part. Probabilities are the softmax of the
// scores.
struct PartModel {
  std::vector<double> mean, scale;  // per number: (number - mean) * scale
  std::vector<double> hidden;       // unit by unit: a weight for each number, and then a constant
  std::vector<double> output;       // part by part: a weight for each unit, and then a constant

  static constexpr auto fields =
      field_list(field("mean", &PartModel::mean, "of each number of a cell"),
                 field("scale", &PartModel::scale, "one over its spread"),
                 field("hidden", &PartModel::hidden, "per unit: one per number, then a constant"),
                 field("output", &PartModel::output, "per part: one per unit, then a constant"));
};

// What is asked of a photo, and how its neighbours in the bank are found.
struct Attribute {
  std::string name;                  // "floor"
  std::vector<std::string> classes;  // "stone", "wood"
  std::vector<std::string> groups;   // of features that it looks at (photo/features.h)
  std::vector<double> mean, scale;   // of those features
  std::vector<double> axes;          // axis by axis, a weight per feature: where classes lie apart
  std::vector<double> places;        // photo by photo, a number per axis
  std::vector<int> votes;            // photo by photo: index of its class
  std::vector<std::string> materials;  // photo by photo: what the shop has there; may be empty
  int voters = 25;
  double sure_vote = 1;  // share of the votes from which it is sure; above 1: never

  static constexpr auto fields = field_list(
      field("name", &Attribute::name, "what it says of a shop", required()),
      field("classes", &Attribute::classes, "its values", required()),
      field("groups", &Attribute::groups, "groups of features that it looks at", required()),
      field("mean", &Attribute::mean, "of each feature"),
      field("scale", &Attribute::scale, "one over its spread"),
      field("axes", &Attribute::axes, "per axis a weight for each feature"),
      field("places", &Attribute::places, "per photo a number for each axis"),
      field("votes", &Attribute::votes, "per photo its class"),
      field("materials", &Attribute::materials, "per photo the material"),
      field("voters", &Attribute::voters, "how many neighbours vote", range(1, 1000)),
      field("sure_vote", &Attribute::sure_vote, "share of votes that counts as sure", range(0, 2)));
};

struct Bank {
  PartModel first_parts, second_parts;
  std::vector<Attribute> attributes;

  static constexpr auto fields =
      field_list(field("first_parts", &Bank::first_parts, "parts by a cell itself"),
                 field("second_parts", &Bank::second_parts, "parts with what stands around it"),
                 field("attributes", &Bank::attributes, "what can be read of a photo"));
};

// data/photo_bank.json of `data`, with every size checked. Errors: of io; photo.bad_bank.
Result<Bank> load_bank(const std::filesystem::path& data);

struct WeighedMaterial {
  std::string material;
  double weight = 0;
};

struct Vote {
  int winner = 0;
  double share = 0;                          // of the votes, by their weight
  std::vector<WeighedMaterial> materials{};  // of those who voted for the winner, nearest first
};
// `features`: those of the attribute's groups, in their order.
Vote vote_on(const Attribute& attribute, const std::vector<double>& features);

// The material with the greatest weight; empty when there is none.
std::string weightiest(const std::vector<WeighedMaterial>& materials);

// Whether any photo of the bank shows that material in a shop of the attribute's class `winner`.
bool is_of_class(const Attribute& attribute, int winner, std::string_view material);

// A share of votes as a confidence: 0.5 at the attribute's sure_vote, 1 when all agree.
double confidence_of(const Attribute& attribute, double share);

}  // namespace marketgen::photo
