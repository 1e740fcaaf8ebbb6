// Product rows for label tests: every kind of sheet, with food and other goods.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/product.h"

namespace marketgen {

// The check digit of EAN-13 after twelve digits: weights 1 and 3 in turn (ISO/IEC 15420).
inline std::string with_check_digit(const std::string& twelve) {
  int sum = 0;
  for (std::size_t i = 0; i < 12; ++i)
    sum += (twelve[i] - '0') * (i % 2 == 0 ? 1 : 3);
  return twelve + static_cast<char>('0' + (10 - sum % 10) % 10);
}

struct SampleRow {
  std::string_view name, variant, brand, category, archetype;
  std::array<int, 3> size_mm;
  std::string_view net, unit, primary, secondary, motif;
};

constexpr SampleRow sample_rows[] = {
    {"Cola",
     "Zero Sugar",
     "Fizzard",
     "beverages",
     "can",
     {66, 66, 115},
     "330 ml",
     "l",
     "#b3121d",
     "#ffffff",
     "bubbles"},
    {"Lemonade",
     "",
     "Sunbrook",
     "beverages",
     "soda_bottle",
     {90, 90, 320},
     "1.5 l",
     "l",
     "#2f8f3c",
     "#fff6c2",
     "lemon"},
    {"Water",
     "Still",
     "Alpina",
     "beverages",
     "water_bottle",
     {85, 85, 310},
     "1.5 l",
     "l",
     "#1e73be",
     "#e8f4ff",
     "water_drop"},
    {"Riesling",
     "Dry",
     "Castell Noir",
     "beverages",
     "wine_bottle",
     {76, 76, 310},
     "0.75 l",
     "l",
     "#1b3a2b",
     "#f2ead2",
     "grape"},
    {"Pilsner",
     "",
     "Kornfeldt",
     "beverages",
     "beer_bottle",
     {66, 66, 235},
     "0.5 l",
     "l",
     "#0b5134",
     "#f4ecd2",
     "hop"},
    {"Apple Juice",
     "Cloudy",
     "Orchard & Sons",
     "beverages",
     "brick_carton",
     {95, 63, 195},
     "1 l",
     "l",
     "#8aa834",
     "#fdf6dc",
     "apple"},
    {"Whole Milk",
     "3.5 % fat",
     "Meadowlark",
     "dairy",
     "gable_carton",
     {95, 95, 235},
     "1 l",
     "l",
     "#1d5fa8",
     "#ffffff",
     "milk_drop"},
    {"Yogurt",
     "Strawberry",
     "Meadowlark",
     "dairy",
     "tub",
     {95, 95, 80},
     "250 g",
     "kg",
     "#e64a6b",
     "#ffeef2",
     "berry"},
    {"Gouda Slices",
     "Mild",
     "Van der Molen",
     "dairy",
     "tray",
     {190, 140, 40},
     "200 g",
     "kg",
     "#f0a81c",
     "#fff4d0",
     "cheese"},
    {"Potato Crisps",
     "Sea Salt",
     "Crunchero",
     "snacks",
     "pillow_bag",
     {200, 70, 290},
     "175 g",
     "kg",
     "#c8102e",
     "#ffe9b0",
     "potato"},
    {"Cookies",
     "",
     "Grandma Pearl",
     "snacks",
     "box",
     {190, 60, 140},
     "225 g",
     "kg",
     "#7a4a21",
     "#fdf0d8",
     "cookie"},
    {"Fruit Drops",
     "Assorted",
     "Zuckerli",
     "snacks",
     "pouch",
     {140, 50, 200},
     "300 g",
     "kg",
     "#e83a8c",
     "#fff0f7",
     "candy"},
    {"Toast",
     "Wholegrain",
     "Kornfeld",
     "bakery",
     "loaf",
     {110, 105, 260},
     "500 g",
     "kg",
     "#a8641f",
     "#fff3d9",
     "bread"},
    {"Chopped Tomatoes",
     "",
     "Bella Nonna",
     "canned",
     "food_tin",
     {75, 75, 110},
     "400 g",
     "kg",
     "#c8201e",
     "#fff6e0",
     "tomato"},
    {"Tuna Chunks",
     "In Brine",
     "Mareblu",
     "canned",
     "food_tin",
     {85, 85, 40},
     "160 g",
     "kg",
     "#0f4c81",
     "#e6f3fb",
     "fish"},
    {"Basmati Rice",
     "",
     "Himaya",
     "dry_goods",
     "box",
     {120, 55, 190},
     "1 kg",
     "kg",
     "#00695c",
     "#f4efe0",
     "rice"},
    {"Coffee",
     "Dark Roast",
     "Caf\u00e9 Norte",
     "dry_goods",
     "paper_bag",
     {85, 60, 200},
     "500 g",
     "kg",
     "#2b1a12",
     "#e9d8bd",
     "coffee_bean"},
    {"Honey",
     "Flower",
     "Imkerhof",
     "dry_goods",
     "jar",
     {80, 80, 110},
     "500 g",
     "kg",
     "#f0a014",
     "#fff5d6",
     "honey"},
    {"Ketchup",
     "Classic",
     "Red Barn",
     "dry_goods",
     "sauce_bottle",
     {70, 55, 190},
     "450 ml",
     "l",
     "#c8201e",
     "#fff4e0",
     "tomato"},
    {"Pizza",
     "Salami",
     "Bella Nonna",
     "frozen",
     "box",
     {270, 270, 35},
     "350 g",
     "kg",
     "#1d3f72",
     "#fff6e2",
     "pizza"},
    {"Dish Soap",
     "Lemon",
     "Sparklo",
     "household",
     "flask",
     {90, 50, 230},
     "500 ml",
     "l",
     "#f7e13a",
     "#ffffff",
     "bubbles"},
    {"Toilet Paper",
     "3-ply",
     "Softara",
     "household",
     "bundle",
     {230, 120, 240},
     "8 rolls",
     "piece",
     "#6fb7e0",
     "#ffffff",
     "flower"},
    {"Toothpaste",
     "Mint",
     "Dentabright",
     "personal_care",
     "tube",
     {55, 40, 170},
     "75 ml",
     "l",
     "#0a7cc4",
     "#ffffff",
     "tooth"},
    {"Baby Wipes",
     "Sensitive",
     "Pipkin",
     "personal_care",
     "pillow_bag",
     {190, 60, 110},
     "72 pieces",
     "piece",
     "#8fcfd8",
     "#fffdf2",
     "baby"},
};

inline Product product_of(const SampleRow& row, int index) {
  Product product;
  product.sku = std::string(row.category) + "-sample-" + std::to_string(index);
  product.ean = with_check_digit("2000" + std::to_string(10000000 + index * 7919));
  product.name = row.name;
  product.variant = row.variant;
  product.brand = row.brand;
  product.description = "A sample of what this shop sells every day.";
  product.category = row.category;
  product.subcategory = row.name;
  product.archetype = row.archetype;
  product.size_mm = row.size_mm;
  product.net = row.net;
  product.unit_of_measure = row.unit;
  product.unit_amount = 0.5;
  product.price = 2.49;
  product.label.primary = row.primary;
  product.label.secondary = row.secondary;
  product.label.motif = row.motif;
  return product;
}

inline std::vector<Product> sample_products() {
  std::vector<Product> products;
  for (const SampleRow& row : sample_rows) {
    products.push_back(product_of(row, static_cast<int>(products.size())));
  }
  return products;
}

inline Product loose_produce(std::string name, std::string archetype) {
  Product product;
  product.sku = "produce-" + name;
  product.plu = "4011";
  product.name = std::move(name);
  product.category = "produce";
  product.archetype = std::move(archetype);
  product.size_mm = {80, 80, 80};
  return product;
}

}  // namespace marketgen
