#include <algorithm>
#include <array>

#include "base/text.h"
#include "drawing/sketch.h"

namespace marketgen::drawing {
namespace {

struct Word {
  std::string_view text;
  Role role;
};

// Beginnings of words, the ones that decide first at the front: the dimensions of a wall are no
// wall. AIA CAD Layer Guidelines, DIN-style German office names, GB/T 18112 Chinese ones.
constexpr std::array beginnings = {
    Word{"dim", Role::ignored},       Word{"anno", Role::ignored},
    Word{"text", Role::ignored},      Word{"iden", Role::ignored},
    Word{"patt", Role::ignored},      Word{"hatch", Role::ignored},
    Word{"schraff", Role::ignored},   Word{"label", Role::ignored},
    Word{"titl", Role::ignored},      Word{"frame", Role::ignored},
    Word{"border", Role::ignored},    Word{"grid", Role::ignored},
    Word{"axis", Role::ignored},      Word{"axes", Role::ignored},
    Word{"furn", Role::ignored},      Word{"equip", Role::ignored},
    Word{"fixture", Role::ignored},   Word{"legend", Role::ignored},
    Word{"defpoints", Role::ignored}, Word{"viewport", Role::ignored},
    Word{"bemass", Role::ignored},    Word{"mass", Role::ignored},
    Word{"beschrift", Role::ignored}, Word{"achs", Role::ignored},
    Word{"moebel", Role::ignored},    Word{"rahmen", Role::ignored},
    Word{"symb", Role::ignored},      Word{"door", Role::door},
    Word{"tuer", Role::door},         Word{"entrance", Role::door},
    Word{"exit", Role::door},         Word{"eingang", Role::door},
    Word{"ausgang", Role::door},      Word{"notausgang", Role::door},
    Word{"gate", Role::door},         Word{"opening", Role::door},
    Word{"glaz", Role::window},       Word{"window", Role::window},
    Word{"wndw", Role::window},       Word{"fenster", Role::window},
    Word{"column", Role::column},     Word{"cols", Role::column},
    Word{"colu", Role::column},       Word{"pillar", Role::column},
    Word{"stuetze", Role::column},    Word{"outline", Role::outline},
    Word{"boundary", Role::outline},  Word{"grundriss", Role::outline},
    Word{"wall", Role::wall},         Word{"waende", Role::wall},
    Word{"wand", Role::wall},         Word{"aussenwand", Role::wall},
};

// Chinese has no blanks between words: anywhere in the name.
constexpr std::array parts = {
    Word{"尺寸", Role::ignored},  Word{"标注", Role::ignored}, Word{"文字", Role::ignored},
    Word{"轴", Role::ignored},    Word{"家具", Role::ignored}, Word{"图框", Role::ignored},
    Word{"填充", Role::ignored},  Word{"设备", Role::ignored}, Word{"门", Role::door},
    Word{"入口", Role::door},     Word{"出口", Role::door},    Word{"窗", Role::window},
    Word{"柱", Role::column},     Word{"轮廓", Role::outline}, Word{"墙", Role::wall},
    Word{"tür", Role::door},      Word{"wänd", Role::wall},    Word{"stütze", Role::column},
    Word{"möbel", Role::ignored}, Word{"maß", Role::ignored},
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

// The beginning stands at the start of a word of letters.
bool has_word(std::string_view name, std::string_view beginning) {
  for (std::size_t at = name.find(beginning); at != std::string_view::npos;
       at = name.find(beginning, at + 1)) {
    if (at == 0 || !is_letter(name[at - 1])) return true;
  }
  return false;
}

}  // namespace

Role role_of(std::string_view name) {
  const std::string lower = lower_ascii(name);
  for (const Word& word : beginnings)
    if (has_word(lower, word.text)) return word.role;
  for (const Word& word : parts)
    if (lower.find(word.text) != std::string::npos) return word.role;
  return Role::unknown;
}

}  // namespace marketgen::drawing
