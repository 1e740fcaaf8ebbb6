// A row for every shape of fruit, vegetable and unwrapped bakery goods, in its usual sizes.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/product.h"

namespace marketgen {

struct ProduceRow {
  std::string_view archetype, name;
  std::array<int, 3> size_mm;
  bool bunch = false;  // many pieces: may spend 10,000 triangles instead of 4,000
};

constexpr ProduceRow produce_rows[] = {
    {"apple", "Apple Gala", {75, 75, 70}},
    {"pear", "Pear Conference", {68, 68, 110}},
    {"pear", "Pear Williams", {110, 75, 75}},
    {"citrus", "Orange", {80, 80, 78}},
    {"citrus", "Lemon", {75, 58, 58}},
    {"peach", "Peach", {72, 72, 68}},
    {"plum", "Plum", {55, 45, 45}},
    {"mango", "Mango", {120, 85, 80}},
    {"avocado", "Avocado", {105, 70, 68}},
    {"kiwi", "Kiwi", {68, 52, 50}},
    {"melon", "Galia Melon", {150, 150, 145}},
    {"melon", "Honeydew Melon", {190, 145, 145}},
    {"watermelon", "Watermelon", {260, 220, 220}},
    {"coconut", "Coconut", {130, 110, 110}},
    {"tomato", "Tomato", {68, 68, 60}},
    {"tomato", "Plum Tomato", {75, 48, 48}},
    {"tomato", "Beef Tomato", {95, 95, 70}},
    {"bell_pepper", "Red Pepper", {85, 85, 95}},
    {"bell_pepper", "Pointed Pepper", {190, 55, 50}},
    {"chili", "Chili", {120, 22, 18}},
    {"cucumber", "Cucumber", {330, 48, 45}},
    {"courgette", "Courgette", {210, 50, 48}},
    {"aubergine", "Aubergine", {220, 85, 82}},
    {"carrot", "Carrot", {190, 32, 32}},
    {"potato", "Potato", {95, 70, 60}},
    {"sweet_potato", "Sweet Potato", {170, 75, 70}},
    {"onion", "Onion", {75, 75, 80}},
    {"garlic", "Garlic", {58, 58, 60}},
    {"pumpkin", "Pumpkin", {240, 240, 180}},
    {"pumpkin", "Butternut Squash", {240, 110, 110}},
    {"beetroot", "Beetroot", {100, 70, 70}},
    {"banana_bunch", "Bananas", {210, 150, 110}},
    {"pineapple", "Pineapple", {115, 115, 290}},
    {"grapes", "Grapes", {210, 130, 90}, true},
    {"strawberry_punnet", "Strawberries", {190, 120, 90}, true},
    {"mushroom_punnet", "Mushrooms", {190, 130, 80}, true},
    {"leek", "Leek", {420, 70, 50}},
    {"spring_onions", "Spring Onions", {320, 80, 40}, true},
    {"celery", "Celery", {340, 100, 90}, true},
    {"broccoli", "Broccoli", {140, 140, 150}},
    {"cauliflower", "Cauliflower", {190, 190, 150}},
    {"cabbage", "Cabbage", {190, 190, 170}},
    {"lettuce_head", "Lettuce", {230, 230, 150}},
    {"corn_cob", "Corn Cob", {230, 60, 55}},
    {"radish_bunch", "Radishes", {220, 110, 70}, true},
    {"asparagus_bunch", "Asparagus", {230, 75, 75}, true},
    {"ginger", "Ginger", {130, 90, 45}},
    {"fennel", "Fennel", {220, 100, 80}},
    {"herb_bunch", "Parsley", {240, 110, 50}, true},
    {"herb_bunch", "Basil", {110, 110, 220}, true},
    {"herb_bunch", "Rosemary", {220, 60, 40}, true},
    {"herb_bunch", "Chives", {200, 50, 40}, true},
    {"bread_roll", "Roll", {90, 80, 55}},
    {"croissant", "Croissant", {150, 75, 55}},
    {"pretzel", "Pretzel", {140, 120, 35}},
    {"donut", "Donut", {95, 95, 35}},
    {"muffin", "Muffin", {75, 75, 70}},
    {"round_bread", "Farmhouse Bread", {240, 240, 100}},
};

inline catalog::Product product_of(const ProduceRow& row, int index = 0) {
  catalog::Product product;
  product.sku = "produce-" + std::string(row.name) + "-" + std::to_string(index);
  product.plu = "4011";
  product.name = row.name;
  product.category = "produce";
  product.subcategory = "produce";
  product.archetype = row.archetype;
  product.size_mm = row.size_mm;
  return product;
}

}  // namespace marketgen
