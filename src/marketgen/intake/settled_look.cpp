#include "intake/settled_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace marketgen::intake {
namespace {

using photo::AttributeReading;
using Readings = std::vector<AttributeReading>;

constexpr std::array<std::string_view, 4> surfaces = {"floor", "wall", "ceiling", "fixture"};

AttributeReading* reading_in(Readings& readings, std::string_view attribute) {
  const auto found = std::ranges::find(readings, attribute, &AttributeReading::attribute);
  return found != readings.end() ? &*found : nullptr;
}

bool is_sure(const AttributeReading* reading) {
  return reading != nullptr && reading->confidence >= photo::sure;
}

class Settling {
 public:
  Settling(const std::vector<photo::PhotoReading>& bank,
           const std::vector<photo::PhotoReading>& model)
      : bank_(photo::together(bank)), model_(photo::together(model)) {}

  SettledLook run() {
    look_.readings = bank_;
    for (const AttributeReading& seen : model_)
      settle(seen);
    for (const std::string_view surface : surfaces)
      settle_surface(surface);
    return std::move(look_);
  }

 private:
  void settle(const AttributeReading& seen) {
    if (!is_sure(&seen)) return;
    AttributeReading* known = reading_in(look_.readings, seen.attribute);
    if (!is_sure(known)) {
      if (known == nullptr) known = &look_.readings.emplace_back();
      *known = seen;
      look_.by_model.push_back(seen.attribute);
    } else if (known->value != seen.value) {
      look_.disagreements.push_back(
          fmt::format("{}: {} ({:.2f}) by the bank of renderings, which holds; {} ({:.2f}) by the "
                      "language model",
                      seen.attribute,
                      known->value,
                      known->confidence,
                      seen.value,
                      seen.confidence));
    }
  }

  bool is_the_models(std::string_view attribute) const {
    return std::ranges::find(look_.by_model, attribute) != look_.by_model.end();
  }

  // What the surface is and its colour come from one reader, or agree.
  void settle_surface(std::string_view surface) {
    const std::string kind(surface), color = kind + "_color";
    if (is_the_models(kind) == is_the_models(color)) return;
    const std::string& by_model = is_the_models(kind) ? kind : color;
    const std::string& by_bank = is_the_models(kind) ? color : kind;
    AttributeReading* sure = reading_in(look_.readings, by_bank);
    if (!is_sure(sure)) return;  // one reader alone says all
    AttributeReading* models = reading_in(look_.readings, by_model);
    const AttributeReading* seen = reading_in(model_, by_bank);
    if (seen != nullptr && seen->value == sure->value) {
      sure->material = models->material;
      sure->confidence = models->confidence;
      look_.by_model.push_back(by_bank);
    } else {
      leave_out(*models, *sure);
    }
  }

  void leave_out(AttributeReading& models, const AttributeReading& sure) {
    look_.disagreements.push_back(
        fmt::format("{}: {} ({:.2f}) by the language model is left out: its {} is not {}, as the "
                    "bank of renderings has it ({:.2f})",
                    models.attribute,
                    models.value,
                    models.confidence,
                    sure.attribute,
                    sure.value,
                    sure.confidence));
    const std::string attribute = models.attribute;
    std::erase(look_.by_model, attribute);
    const AttributeReading* banks = reading_in(bank_, attribute);
    if (banks != nullptr) {
      models = *banks;
    } else {
      std::erase_if(look_.readings,
                    [&](const AttributeReading& one) { return one.attribute == attribute; });
    }
  }

  Readings bank_, model_;
  SettledLook look_;
};

}  // namespace

plan::Source SettledLook::source_of(std::string_view attribute) const {
  return std::ranges::find(by_model, attribute) != by_model.end() ? plan::Source::llm
                                                                  : plan::Source::photo;
}

SettledLook settled_look(const std::vector<photo::PhotoReading>& bank,
                         const std::vector<photo::PhotoReading>& model) {
  return Settling(bank, model).run();
}

}  // namespace marketgen::intake
