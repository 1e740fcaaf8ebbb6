#include <algorithm>

#include "intake/place_nouns.h"
#include "intake/reading.h"

namespace marketgen::intake {
namespace {

// A relation that was opened by its words and waits for what it relates to.
struct OpenRelation {
  std::size_t phrase;
  std::string value;  // of the lexicon row
  bool negated = false;
  bool fronted = false;  // its subject follows: "along the back wall put dairy"
  std::vector<PlaceNoun> objects;
};

// Goes over the phrases of one sentence from left to right, holding the nouns that a relation could
// be about.
class PlaceReader {
 public:
  PlaceReader(Sentence& sentence, Reading& reading) : sentence_(sentence), reading_(reading) {}

  void run() {
    for (at_ = 0; at_ < sentence_.phrases.size(); ++at_)
      step();
    drop_open_relation();
  }

 private:
  void step() {
    const Phrase& phrase = sentence_.phrases[at_];
    if (phrase.used && !phrase.counted) return forget_modifiers();
    switch (phrase.sense) {
      case Sense::filler:
      case Sense::strength:
      case Sense::shop:
        return;
      case Sense::separator:
        return see_separator(phrase.value);
      case Sense::negation:
        return see_negation(phrase.value);
      case Sense::amount:
      case Sense::size:
        modifier_ = at_;
        return;
      case Sense::relation:
        return open_relation(phrase.value);
      case Sense::times:
        if (phrase.value == "by") open_relation("near");
        return;
      case Sense::place:
        return see_place();
      default:
        if (names_a_place(phrase)) return see_noun();
        forget_modifiers();
        drop_weak_relation();
    }
  }

  void forget_modifiers() { modifier_.reset(); }

  void see_separator(const std::string& value) {
    separator_ = value;
    forget_modifiers();
    drop_weak_relation();
    if (value != "but") return;
    noun_negation_.reset();
    verb_negation_.reset();
    list_negated_ = false;
  }

  void see_negation(const std::string& value) {
    (value == "no" ? noun_negation_ : verb_negation_) = at_;
    separator_.clear();
  }

  // ---- Relations ----

  void open_relation(const std::string& value) {
    const bool after_separator = !separator_.empty();
    drop_open_relation();
    OpenRelation relation{at_, value, verb_negation_.has_value(), false, {}};
    relation.fronted = subjects_.empty() || (after_separator && related_ && subject_follows());
    if (verb_negation_) sentence_.use(*verb_negation_, *verb_negation_);
    open_ = std::move(relation);
    extended_.reset();
    separator_.clear();
  }

  // "…, on the left a bakery": the noun right after the relation's object has no relation of its
  // own.
  bool subject_follows() const {
    const std::size_t object = sentence_.skip_fillers(at_ + 1);
    const std::size_t noun = sentence_.skip_fillers(object + 1);
    if (!sentence_.is(object, Sense::place) || noun >= sentence_.phrases.size()) return false;
    const std::size_t next = sentence_.skip_fillers(noun + 1);
    return names_a_place(sentence_.at(noun)) && !sentence_.is(next, Sense::relation) &&
           !sentence_.is(next, Sense::place);
  }

  bool open_is_weak() const { return open_ && (open_->value == "at" || open_->value == "in"); }

  // "in" and "at" mean a place only when it comes right after them.
  void drop_weak_relation() {
    if (open_is_weak()) open_.reset();
  }

  void drop_open_relation() {
    if (open_ && !open_->objects.empty()) close_relation();
    open_.reset();
  }

  void take_object(PlaceNoun object) {
    open_->objects.push_back(std::move(object));
    const bool needs_second = open_->value == "between" && open_->objects.size() < 2;
    if (!needs_second) close_relation();
    separator_.clear();
  }

  void close_relation() {
    OpenRelation relation = *open_;
    open_.reset();
    if (relation.fronted) {
      subjects_.clear();
      sentence_.use(relation.phrase, relation.phrase);
      fronted_ = relation;
      return;
    }
    for (const PlaceNoun& subject : subjects_)
      emit(relation, subject);
    related_ = true;
    extended_ = relation;
  }

  void emit(const OpenRelation& relation, const PlaceNoun& subject) {
    if (add_relation(reading_, {relation.value, relation.negated, subject, relation.objects})) {
      sentence_.use(relation.phrase, relation.phrase);
      for (const PlaceNoun& object : relation.objects)
        sentence_.use(object.phrase, object.phrase);
    }
  }

  // ---- Nouns ----

  void see_place() {
    const PlaceNoun place = noun_at(sentence_, at_);
    if (!open_) open_relation("at");
    take_object(place);
  }

  void see_noun() {
    PlaceNoun noun = noun_at(sentence_, at_);
    take_modifier(noun);
    sentence_.use(at_, at_);
    if (open_is_weak() && noun.kind != NounKind::opening && open_->value == "in") open_.reset();
    if (open_) {
      if (!names_far(open_->value, open_->negated)) mention(noun);
      return take_object(std::move(noun));
    }
    if (extends_objects(noun)) {
      extended_->objects = {noun};
      if (!names_far(extended_->value, extended_->negated)) mention(noun);
      for (const PlaceNoun& subject : subjects_)
        emit(*extended_, subject);
      separator_.clear();
      return;
    }
    take_subject(std::move(noun));
  }

  // "lots of", "a large"
  void take_modifier(PlaceNoun& noun) {
    noun.article = sentence_.is(at_ - 1, Sense::filler, "article");
    if (!modifier_) return;
    noun.factor = sentence_.phrases[*modifier_].number;
    noun.span = joined(sentence_.phrases[*modifier_].span, noun.span);
    sentence_.use(*modifier_, *modifier_);
    modifier_.reset();
  }

  // "away from bakery and dairy": the list of objects goes on unless the noun starts something of
  // its own.
  bool extends_objects(const PlaceNoun& noun) const {
    const bool joins = separator_ == "and" || separator_ == "or";
    if (!extended_ || !joins || noun.article || noun.counted || noun.factor != 1) return false;
    if (extended_->value == "between" || noun.kind == NounKind::opening) return false;
    if (extended_->objects.back().kind == NounKind::place) return false;
    if (extended_->objects.back().kind == NounKind::opening) return false;
    const std::size_t next = sentence_.skip_fillers(at_ + 1);
    return !sentence_.is(next, Sense::relation) && !sentence_.is(next, Sense::place);
  }

  void take_subject(PlaceNoun noun) {
    decide_negation(noun);
    const bool joins = !separator_.empty() && !related_ && !subjects_.empty();
    const bool continues = joins && (separator_ == "and" || separator_ == "or");
    if (!joins || related_) subjects_.clear();
    if (joins && !continues && !list_ends_with_and()) subjects_.clear();
    if (continues && !subjects_.empty() && subjects_.back().counted != noun.counted) {
      subjects_.clear();
    }
    related_ = false;
    extended_.reset();
    separator_.clear();
    const bool kept_apart =
        verb_negation_.has_value();  // "don't put frozen by the door" asks for no frozen
    if (!kept_apart || noun.negated) mention(noun);
    if (noun.negated) return;
    subjects_.push_back(noun);
    if (fronted_ && !noun.counted) emit(*fronted_, noun);
  }

  // "bakery, dairy and frozen along …": commas before an "and" join, commas alone part.
  bool list_ends_with_and() const {
    for (std::size_t i = at_ + 1; i < sentence_.phrases.size(); ++i) {
      const Phrase& phrase = sentence_.phrases[i];
      if (phrase.sense == Sense::relation || phrase.sense == Sense::place) return false;
      if (phrase.sense != Sense::separator) continue;
      if (phrase.value == "and" || phrase.value == "or") return true;
      if (phrase.value != ",") return false;
    }
    return false;
  }

  // "no bakery, cafe or deli": a list that ends with "or" is refused as a whole; commas alone end
  // the refusal.
  void decide_negation(PlaceNoun& noun) {
    if (noun_negation_) {
      noun.negated = list_negated_ = true;
      noun.span = joined(sentence_.phrases[*noun_negation_].span, noun.span);
      sentence_.use(*noun_negation_, *noun_negation_);
      noun_negation_.reset();
    } else if (verb_negation_ && !relation_follows()) {
      noun.negated = list_negated_ = true;
      noun.span = joined(sentence_.phrases[*verb_negation_].span, noun.span);
      sentence_.use(*verb_negation_, *verb_negation_);
      verb_negation_.reset();
    } else {
      const bool joined_list = separator_ == "or" || (separator_ == "and" && !noun.article) ||
                               (separator_ == "," && list_ends_with_or());
      list_negated_ =
          list_negated_ && joined_list && !noun.counted && noun.factor == 1 && !relation_follows();
      noun.negated = list_negated_;
    }
  }

  bool list_ends_with_or() const {
    for (std::size_t i = at_ + 1; i < sentence_.phrases.size(); ++i) {
      const Phrase& phrase = sentence_.phrases[i];
      if (phrase.sense == Sense::filler || names_a_place(phrase)) continue;
      if (phrase.sense != Sense::separator) return false;
      if (phrase.value == "or") return true;
    }
    return false;
  }

  // In this clause, after the noun.
  bool relation_follows() const {
    for (std::size_t i = at_ + 1; i < sentence_.phrases.size(); ++i) {
      const Phrase& phrase = sentence_.phrases[i];
      if (phrase.sense == Sense::relation || phrase.sense == Sense::place) return true;
      if (phrase.sense == Sense::times && phrase.value == "by") return true;
      if (phrase.sense == Sense::separator && phrase.value != "and" && phrase.value != "or") {
        return false;
      }
    }
    return false;
  }

  void mention(const PlaceNoun& noun) {
    add_mention(reading_, noun);
    use_suffixes(sentence_, noun.phrase);
  }

  Sentence& sentence_;
  Reading& reading_;
  std::size_t at_ = 0;
  std::vector<PlaceNoun> subjects_;
  bool related_ = false;   // the subjects have a relation already
  std::string separator_;  // since the last noun, place or relation
  std::optional<std::size_t> modifier_, noun_negation_, verb_negation_;
  bool list_negated_ = false;
  std::optional<OpenRelation> open_;
  std::optional<OpenRelation> extended_;  // the last one, whose list of objects may go on
  std::optional<OpenRelation> fronted_;   // waits for its subjects
};

}  // namespace

void read_places(Sentence& sentence, Reading& reading) {
  PlaceReader(sentence, reading).run();
}

}  // namespace marketgen::intake
