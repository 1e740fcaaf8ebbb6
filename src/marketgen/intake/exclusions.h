// Which wishes exclude one another: the table of what cannot hold at once.
#pragma once
#include <set>
#include <string>
#include <string_view>

#include "intake/understanding.h"

namespace marketgen::intake {

// What two wishes are judged by besides themselves.
struct Surroundings {
  std::string_view prompt;
  std::string front;  // the wall of the entrance: "south"
  std::set<std::string>
      several;  // zone types and kinds of openings of which two or more are wanted
  std::set<std::string> mentioned;  // zone types that are named, themselves or by their goods
  std::vector<NamedThings> things;  // that relations were said of

  NamedThings things_of(const plan::Requirement& wish) const;
};

Surroundings surroundings_of(const Understanding& found,
                             std::string_view prompt,
                             plan::Wall entrance);

enum class Together { hold, same, first_is_vaguer, second_is_vaguer, exclude };

// How `earlier` and `later` go together. "Warm light" is vaguer than "2700 K", "a supermarket" than
// "a discounter", "a food hall" than "brutalist": then only the other one counts, and nothing is
// contradicted. What is said of
// one zone is an exception to what is said of all, unless that is a limit ("nothing above 1.4 m").
Together together(const plan::Requirement& earlier,
                  const plan::Requirement& later,
                  const Surroundings& around);

// Least and most that the wish's number may be.
std::array<double, 2> bounds_of(const plan::Requirement& wish);

// True for "no beer" and its like: zones, goods, fixtures or doors that there shall be none of.
bool is_negative(const plan::Requirement& wish);

}  // namespace marketgen::intake
