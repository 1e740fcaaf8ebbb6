#include "intake/conflicts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "intake/clauses.h"
#include "intake/exclusions.h"
#include "plan/store_time.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;
using plan::Requirement;

// What the two wishes are about.
std::string topic(const Requirement& wish) {
  std::string text(name_of(wish.kind));
  if (!wish.subject.empty()) text += " " + wish.subject;
  return text;
}

constexpr std::string_view contradict = " contradict each other; ";

// A piece of the prompt.
struct Said {
  std::string text;
  IntRange span{0, 0};
};

// Both clauses, and which of them holds.
Conflict contradiction(std::string_view prompt,
                       std::string what,
                       const Said& kept,
                       const Said& dropped,
                       std::string_view rule) {
  const bool in_order = kept.span[0] < dropped.span[0];
  const IntRange first = clause_of(prompt, in_order ? kept.span : dropped.span);
  const IntRange second = clause_of(prompt, in_order ? dropped.span : kept.span);
  const auto quoted = [&](IntRange clause) {
    return '"' + std::string(text_at(prompt, clause)) + '"';
  };
  std::string why = first == second ? "the two" : quoted(first) + " and " + quoted(second);
  Conflict conflict{std::move(what), kept.text, dropped.text, {}, {}};
  conflict.why = std::move(why) + std::string(contradict) + std::string(rule);
  conflict.where = in_order ? std::vector{first, second} : std::vector{second, first};
  return conflict;
}

constexpr std::string_view last_holds = "what was said last holds";
constexpr std::string_view must_holds = "what must be wins over what is preferred";

class Settlement {
 public:
  Settlement(Understanding& understanding, std::string_view prompt, plan::Wall entrance)
      : found_(understanding),
        wishes_(understanding.requirements),
        prompt_(prompt),
        around_(surroundings_of(understanding, prompt, entrance)),
        lost_(wishes_.size(), false) {}

  void run() {
    drop_denied();
    drop_parts();
    for (std::size_t later = 1; later < wishes_.size(); ++later)
      for (std::size_t earlier = 0; earlier < later && !lost_[later]; ++earlier)
        if (!lost_[earlier]) settle(earlier, later);
    for (std::size_t total = 0; total < wishes_.size(); ++total)
      settle_total(total);
    std::vector<Requirement> left;
    for (std::size_t i = 0; i < wishes_.size(); ++i)
      if (!lost_[i]) left.push_back(std::move(wishes_[i]));
    found_.requirements = std::move(left);
  }

 private:
  // "No carpet" asks for no material: what the floor shall be is not said. "Not on a Saturday" is
  // no time either.
  void drop_denied() {
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      const Kind kind = wishes_[i].kind;
      const bool choice = kind == Kind::material || kind == Kind::color || kind == Kind::style ||
                          kind == Kind::time;
      lost_[i] = choice && is_denied(prompt_, wishes_[i].span);
    }
  }

  void settle(std::size_t earlier, std::size_t later) {
    switch (together(wishes_[earlier], wishes_[later], around_)) {
      case Together::hold:
        return;
      case Together::same:
      case Together::second_is_vaguer:
        lost_[later] = true;
        return;
      case Together::first_is_vaguer:
        lost_[earlier] = true;
        return;
      case Together::exclude:
        decide(earlier, later);
    }
  }

  void decide(std::size_t earlier, std::size_t later) {
    const Requirement& first = wishes_[earlier];
    const Requirement& second = wishes_[later];
    const bool first_outdated = is_outdated(prompt_, first.span);
    const bool second_outdated = is_outdated(prompt_, second.span);
    const bool moved = is_moved(prompt_, first.span, second.span);
    if (!moved && (is_fallback(prompt_, second.span) || (second_outdated && !first_outdated))) {
      lost_[later] = true;
    } else if (moved || (first_outdated && !second_outdated) || is_mere_topic(earlier, later) ||
               takes_its_place(prompt_, first.span, second.span)) {
      lost_[earlier] = true;
    } else {
      const bool weaker =
          first.strength == plan::Strength::must && second.strength == plan::Strength::prefer;
      note(weaker ? earlier : later, weaker ? later : earlier);
    }
  }

  // "Chest freezers only ever caused us trouble, so no chest freezers": what is only named, and
  // then in the same sentence not wanted.
  bool is_mere_topic(std::size_t earlier, std::size_t later) const {
    const Requirement& named = wishes_[earlier];
    const Requirement& none = wishes_[later];
    const bool bare = named.kind == Kind::zone_present || named.kind == Kind::product_present ||
                      ((named.kind == Kind::fixture_count || named.kind == Kind::endcaps) &&
                       named.comparison == plan::Comparison::at_least && named.value == 1);
    if (!bare || !is_negative(none) || named.subject != none.subject ||
        named.strength != none.strength)
      return false;
    const bool said_of = std::ranges::any_of(wishes_, [&](const Requirement& other) {
      return &other != &named && !is_negative(other) && other.span[0] <= named.span[0] &&
             other.span[1] >= named.span[1];
    });
    return !said_of && in_one_sentence(prompt_, named.span, none.span);
  }

  // Reported once for each pair of clauses: what is said of a zone that goes, goes with it.
  void note(std::size_t kept, std::size_t dropped) {
    lost_[dropped] = true;
    const Requirement& winner = wishes_[kept];
    const Requirement& loser = wishes_[dropped];
    const IntRange clause = clause_of(prompt_, loser.span);
    const std::pair pair{winner.span, clause};
    if (std::ranges::find(noted_, pair) != noted_.end()) return;
    noted_.push_back(pair);
    found_.conflicts.push_back(
        contradiction(prompt_,
                      topic(loser),
                      {winner.text, winner.span},
                      {loser.text, loser.span},
                      winner.strength == loser.strength ? last_holds : must_holds));
  }

  static bool is_counted(const Requirement& wish) {
    return wish.kind == Kind::zone_count || wish.kind == Kind::fixture_count ||
           wish.kind == Kind::run_count;
  }

  // "Six lanes: two self-checkouts, four staffed ones": both are lanes.
  static bool is_part_by_name(const Requirement& part, const Requirement& whole) {
    return part.subject == whole.subject ||
           (whole.subject == "checkout_lane" && part.subject == "self_checkout");
  }

  // "Two bakeries: one bakery by the entrance, one bakery at the back" and its like: later numbers
  // of one sentence that add up to the first one are its parts.
  void drop_parts() {
    for (std::size_t total = 0; total < wishes_.size(); ++total) {
      const Requirement& whole = wishes_[total];
      if (!is_counted(whole) || whole.comparison != plan::Comparison::equal) continue;
      std::vector<std::size_t> parts;
      double sum = 0;
      for (std::size_t i = total + 1; i < wishes_.size() && sum < whole.value; ++i) {
        const Requirement& part = wishes_[i];
        const bool same = part.kind == whole.kind && is_part_by_name(part, whole) &&
                          part.second_object == whole.second_object && part.value < whole.value &&
                          part.comparison == plan::Comparison::equal;
        if (!same || !in_one_sentence(prompt_, whole.span, part.span)) continue;
        parts.push_back(i);
        sum += part.value;
      }
      if (parts.size() < 2 || sum != whole.value) continue;
      const bool of_one_kind = std::ranges::all_of(
          parts, [&](std::size_t part) { return wishes_[part].subject == whole.subject; });
      if (!of_one_kind) lost_[total] = true;
      for (const std::size_t part : parts)
        if (of_one_kind) lost_[part] = true;
    }
  }

  // What belongs to a total: doors in walls to doors, fixtures in zones to those of the store.
  static bool is_part_of(const Requirement& part, const Requirement& whole) {
    if (part.kind != whole.kind || part.subject != whole.subject) return false;
    if (whole.kind == Kind::opening)
      return whole.object.empty() && !part.object.empty() && !is_negative(part);
    return is_counted(whole) && whole.second_object.empty() && !part.second_object.empty();
  }

  // "Only one entrance; one in the north wall and one in the east wall": more parts than there are
  // to be in all. The earlier of total and last part gives way.
  void settle_total(std::size_t total) {
    const Requirement& whole = wishes_[total];
    const bool counts = whole.kind == Kind::opening || is_counted(whole);
    if (lost_[total] || !counts || whole.value < 1 ||
        whole.comparison == plan::Comparison::at_least)
      return;
    std::vector<std::size_t> parts;
    double sum = 0;
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      if (lost_[i] || !is_part_of(wishes_[i], whole)) continue;
      const double least = bounds_of(wishes_[i])[0];
      parts.push_back(i);
      sum += whole.kind == Kind::opening ? std::max(1.0, least) : least;
    }
    if (parts.empty() || sum <= whole.value) return;
    if (whole.value == 1 && !is_no_more(prompt_, whole.span)) return;  // "one in the north wall"
    const std::size_t last = parts.back();
    const bool taken_back = takes_its_place(prompt_, whole.span, wishes_[last].span);
    if (last > total && taken_back)
      lost_[total] = true;
    else if (last > total)
      note(last, total);
    else
      note(total, last);
  }

  Understanding& found_;
  std::vector<Requirement>& wishes_;
  std::string_view prompt_;
  Surroundings around_;
  std::vector<bool> lost_;
  std::vector<std::pair<IntRange, IntRange>> noted_;  // span of what was kept, clause of the other
};

// What is said again otherwise: the last one holds.
template <typename Item, typename Clash>
void keep_last(std::vector<Item>& items,
               std::string_view prompt,
               std::string_view what,
               std::vector<Conflict>& conflicts,
               const Clash& clash) {
  std::vector<Item> kept;
  for (Item& item : items) {
    std::erase_if(kept, [&](const Item& before) {
      if (!clash(before, item)) return false;
      const bool mended =
          is_outdated(prompt, before.span) || takes_its_place(prompt, before.span, item.span);
      if (!mended)
        conflicts.push_back(contradiction(prompt,
                                          std::string(what),
                                          {std::string(text_at(prompt, item.span)), item.span},
                                          {std::string(text_at(prompt, before.span)), before.span},
                                          last_holds));
      return true;
    });
    kept.push_back(std::move(item));
  }
  items = std::move(kept);
}

// More of it than usual, or less.
bool pull_apart(double a, double b) {
  return (a > 1 && b < 1) || (a < 1 && b > 1);
}

void settle_words(Understanding& found, std::string_view prompt) {
  std::vector<Conflict>& conflicts = found.conflicts;
  keep_last(found.names, prompt, "name", conflicts, [](const StoreName& a, const StoreName& b) {
    return a.text != b.text;
  });
  keep_last(found.sizes, prompt, "size", conflicts, [](const SizeWord& a, const SizeWord& b) {
    return a.of_shop && b.of_shop && pull_apart(a.factor, b.factor);
  });
  keep_last(found.emphases, prompt, "amount", conflicts, [](const Emphasis& a, const Emphasis& b) {
    return a.named == b.named && pull_apart(a.factor, b.factor);
  });
  keep_last(found.rows, prompt, "rows", conflicts, [](const WantedRows& a, const WantedRows& b) {
    return a.zone == b.zone && a.rows != b.rows;
  });
  if (!found.names.empty()) found.name = found.names.back();
  for (const SizeWord& size : found.sizes)
    found.size_factor *= size.factor;
}

void note_loss(Understanding& understanding,
               const plan::Requirement& loser,
               const plan::Requirement& kept,
               std::string why) {
  understanding.conflicts.push_back({topic(loser), kept.text, loser.text, std::move(why), {}});
}

std::string describe_flag(const Brief& brief, Kind kind) {
  if (kind == Kind::profile) return "--profile " + *brief.profile;
  if (kind == Kind::style) return "--style " + *brief.style;
  if (kind == Kind::time) return "--time " + *brief.time;
  return "--size " + std::to_string((*brief.size_mm)[0]) + " x " +
         std::to_string((*brief.size_mm)[1]) + " mm";
}

// Precondition: what --time says is a time.
bool is_at(const std::string& flag, const std::string& said) {
  const auto time = plan::parse_store_time(flag, "brief.bad_time", "--time");
  return time.ok() && plan::text_of(*time) == said;
}

bool flag_contradicts(const Brief& brief, const plan::Requirement& wish) {
  constexpr double rounding_mm = 1;
  switch (wish.kind) {
    case Kind::profile:
      return brief.profile && *brief.profile != wish.object;
    case Kind::style:
      return brief.style && *brief.style != wish.object;
    case Kind::time:
      return brief.time && !is_at(*brief.time, wish.object);
    case Kind::size: {
      const auto differ = [](double said, int flag) {  // 0: that side was not said
        return said > 0 && std::abs(flag - said) > rounding_mm;
      };
      return brief.size_mm && (differ(wish.value, (*brief.size_mm)[0]) ||
                               differ(wish.second_value, (*brief.size_mm)[1]));
    }
    default:
      return false;
  }
}

}  // namespace

void settle_conflicts(Understanding& understanding, std::string_view prompt, plan::Wall entrance) {
  Settlement(understanding, prompt, entrance).run();
  settle_words(understanding, prompt);
}

bool is_contradiction(const Conflict& conflict) {
  return !conflict.where.empty() && conflict.why.ends_with(last_holds);
}

void apply_flags(const Brief& brief, Understanding& understanding) {
  for (std::size_t i = 0; i < understanding.requirements.size();) {
    const plan::Requirement wish = understanding.requirements[i];
    if (!flag_contradicts(brief, wish)) {
      ++i;
      continue;
    }
    plan::Requirement flag = wish;
    flag.text = describe_flag(brief, wish.kind);
    note_loss(understanding, wish, flag, "a flag wins over the text");
    understanding.requirements.erase(understanding.requirements.begin() +
                                     static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace marketgen::intake
