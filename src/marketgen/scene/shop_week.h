// How a shop's sales spread over the week.
#pragma once
#include <string_view>
#include <vector>

#include "plan/store_time.h"

namespace marketgen::scene {

// closed_on_sundays: supermarkets in Germany are open for 76 hours a week, have 21 % of their sales
// on Fridays and 22 % on Saturdays, most between 16 and 18 o'clock on weekdays and between 10 and
// 12 on Saturdays (EHI Retail Institute for HDE, 2017).
//
// every_day: shoppers in the United States. 41 million on Saturdays, 29 million each on Mondays and
// Tuesdays, 32 million on the mean day, Fridays and Sundays in between (The Time Use Institute,
// "Grocery Shopping: Who, Where and When", 2008); most from 11 to 13 and from 15 to 16 o'clock, at
// weekends from 11 to 13 (USDA ERS, Charts of Note, 21 November 2019; both of the American Time Use
// Survey).
//
// What these sources leave open lies evenly between what they say.
enum class ShopWeek { closed_on_sundays, every_day };

struct ShopSales {
  std::string_view profile;
  ShopWeek week = ShopWeek::closed_on_sundays;
  double over_supermarket = 1;
};

// scene/shop_sales.inc. A profile that is not in it is a supermarket.
const std::vector<ShopSales>& shops_sales();
const ShopSales& sales_of_shop(std::string_view profile);

// Share of a week's sales in the `minutes` from `from` on, which may go on into the next week;
// minutes_of_week of them are 1.
double sales_share(ShopWeek week, plan::StoreTime from, int minutes);

bool is_open_on(ShopWeek week, plan::Weekday day);

}  // namespace marketgen::scene
