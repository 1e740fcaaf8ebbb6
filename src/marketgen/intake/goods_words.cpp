#include "intake/goods_words.h"

#include "intake/clauses.h"

namespace marketgen::intake {

bool names_any(const std::string& text, std::initializer_list<std::string_view> words) {
  return has_any_word(text, {words.begin(), words.size()});
}

bool names_fish(const std::string& text) {
  return names_any(text,
                   {"fish",
                    "seafood",
                    "salmon",
                    "tuna",
                    "prawns",
                    "shrimps",
                    "鱼",
                    "魚",
                    "水产",
                    "水產",
                    "海鲜",
                    "海鮮",
                    "虾",
                    "蝦"});
}

bool names_meat(const std::string& text) {
  return names_any(
      text,
      {"meat", "butcher", "butchers", "butcher's", "beef", "pork", "poultry", "chicken", "肉"});
}

bool names_counter(const std::string& text) {
  return names_meat(text) || names_fish(text) || names_any(text, {"deli", "cheese", "ham", "熟食"});
}

bool names_plant_drink(const std::string& text) {
  return names_any(text,
                   {"oat",
                    "soy",
                    "soya",
                    "almond",
                    "coconut",
                    "rice",
                    "plant",
                    "燕麦",
                    "燕麥",
                    "豆",
                    "杏仁",
                    "椰"});
}

}  // namespace marketgen::intake
