#include "photo/bank.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/file.h"
#include "io/json.h"
#include "photo/features.h"
#include "photo/parts.h"

namespace marketgen::photo {
namespace {

constexpr std::uint64_t max_bank_bytes = 64U << 20;
// Squared distance, in spreads within a class, at which a weight is halved; as in make_bank.py.
constexpr double nearness = 1;
constexpr double almost_sure = 0.49;  // the most that one who is not sure says

class BankCheck {
 public:
  explicit BankCheck(std::string file) : file_(std::move(file)) {}

  Result<void> check(const Bank& bank) const {
    MARKETGEN_CHECK(check_model(bank.first_parts, first_number_count(), "first_parts"));
    MARKETGEN_CHECK(check_model(bank.second_parts, second_number_count(), "second_parts"));
    for (const Attribute& attribute : bank.attributes)
      MARKETGEN_CHECK(check_attribute(attribute));
    return {};
  }

 private:
  Error bad(const std::string& where, std::string message) const {
    return {"photo.bad_bank", file_ + ":" + where, std::move(message)};
  }

  Result<void> check_model(const PartModel& model, std::size_t numbers, const char* where) const {
    const std::size_t units = model.hidden.size() / (numbers + 1);
    const bool fits = model.mean.size() == numbers && model.scale.size() == numbers && units > 0 &&
                      model.hidden.size() == units * (numbers + 1) &&
                      model.output.size() == part_count * (units + 1);
    if (fits) return {};
    return bad(where,
               fmt::format("its sizes do not fit {} numbers and {} parts; make the bank anew with "
                           "tools/shop_photos/make_bank.py",
                           numbers,
                           part_count));
  }

  Result<void> check_attribute(const Attribute& attribute) const {
    std::size_t features = 0;
    for (const std::string& group : attribute.groups) {
      if (feature_count(group) == 0) return bad(attribute.name, "no group of features: " + group);
      features += feature_count(group);
    }
    const std::size_t axes = features > 0 ? attribute.axes.size() / features : 0;
    const std::size_t photos = attribute.votes.size();
    const bool sizes = attribute.mean.size() == features && attribute.scale.size() == features &&
                       axes > 0 && attribute.axes.size() == axes * features && photos > 0 &&
                       attribute.places.size() == photos * axes &&
                       (attribute.materials.empty() || attribute.materials.size() == photos);
    const bool classes = std::ranges::all_of(attribute.votes, [&](int vote) {
      return vote >= 0 && static_cast<std::size_t>(vote) < attribute.classes.size();
    });
    if (sizes && classes) return {};
    return bad(
        attribute.name,
        fmt::format("its sizes do not fit {} features and {} photos; make the bank anew with "
                    "tools/shop_photos/make_bank.py",
                    features,
                    photos));
  }

  std::string file_;
};

struct Neighbour {
  double distance2 = 0;
  std::size_t photo = 0;
};

// The nearest photos of the bank, nearest first.
std::vector<Neighbour> neighbours(const Attribute& attribute, const std::vector<double>& place) {
  const std::size_t axes = place.size();
  std::vector<Neighbour> all(attribute.votes.size());
  for (std::size_t photo = 0; photo < all.size(); ++photo) {
    all[photo].photo = photo;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double apart = attribute.places[photo * axes + axis] - place[axis];
      all[photo].distance2 += apart * apart;
    }
  }
  const auto nearer = [](const Neighbour& a, const Neighbour& b) {
    return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : a.photo < b.photo;
  };
  const auto count = std::min(all.size(), static_cast<std::size_t>(attribute.voters));
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(count);
  std::ranges::partial_sort(all, end, nearer);
  all.erase(end, all.end());
  return all;
}

}  // namespace

Result<Bank> load_bank(const std::filesystem::path& data) {
  const std::filesystem::path file = data / "photo_bank.json";
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_bank_bytes));
  MARKETGEN_TRY(Bank bank, io::read_json<Bank>(text, file.string()));
  MARKETGEN_CHECK(BankCheck(file.string()).check(bank));
  return bank;
}

Vote vote_on(const Attribute& attribute, const std::vector<double>& features) {
  const std::size_t count = features.size();
  std::vector<double> place(attribute.axes.size() / count);
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    for (std::size_t i = 0; i < count; ++i)
      place[axis] +=
          attribute.axes[axis * count + i] * (features[i] - attribute.mean[i]) * attribute.scale[i];
  }
  const std::vector<Neighbour> voters = neighbours(attribute, place);
  std::vector<double> votes(attribute.classes.size());
  double all = 0;
  const auto weight_of = [&](const Neighbour& one) {
    return nearness / (nearness + one.distance2);
  };
  for (const Neighbour& one : voters) {
    votes[attribute.votes[one.photo]] += weight_of(one);
    all += weight_of(one);
  }
  Vote vote;
  vote.winner = static_cast<int>(std::ranges::max_element(votes) - votes.begin());
  vote.share = std::min(1.0, votes[vote.winner] / all);
  for (const Neighbour& one : voters) {
    if (!attribute.materials.empty() && attribute.votes[one.photo] == vote.winner)
      vote.materials.push_back({attribute.materials[one.photo], weight_of(one)});
  }
  return vote;
}

std::string weightiest(const std::vector<WeighedMaterial>& materials) {
  std::string best;
  double most = 0;
  for (const WeighedMaterial& one : materials) {
    double sum = 0;
    for (const WeighedMaterial& other : materials)
      sum += other.material == one.material ? other.weight : 0;
    if (sum <= most) continue;
    most = sum;
    best = one.material;
  }
  return best;
}

bool is_of_class(const Attribute& attribute, int winner, std::string_view material) {
  for (std::size_t photo = 0; photo < attribute.materials.size(); ++photo) {
    if (attribute.votes[photo] == winner && attribute.materials[photo] == material) return true;
  }
  return false;
}

double confidence_of(const Attribute& attribute, double share) {
  if (share < attribute.sure_vote) return almost_sure * share / std::max(1.0, attribute.sure_vote);
  const double above = 1 - attribute.sure_vote;
  return above > 0 ? 0.5 + 0.5 * (share - attribute.sure_vote) / above : 1;
}

}  // namespace marketgen::photo
