// What the words of an edit ask for beside wishes: how something that is there shall change.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"

namespace marketgen::intake {

enum class ChangeAction { swap, resize, more, fewer, set };

//   swap    subject and object, zone types, change places
//   resize  subject, a zone type: value m2, or value times its floor when `relative`
//   more    value more fixtures of the kind `object` in zones of type `subject`; without a kind,
//           another zone of the type
//   fewer   the same, less; without a kind, none of the type any more
//   set     the field `object` of fixture or stock in zones of type `subject` gets `value`
struct WordedChange {
  ChangeAction action = ChangeAction::set;
  std::string subject, object;
  double value = 1;
  bool relative = false;
  std::string text;  // the words it came from
  IntRange span{0, 0};
};

}  // namespace marketgen::intake
