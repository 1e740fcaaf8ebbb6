"""Words: which goods a wish names, and whether the program reported a piece of the prompt."""
import re

# What people call goods -> how a shelf would be labelled: (words of the name, subcategory or None).
# A wish is met by any of its rows. Only where the common name differs from the printed one.
GOODS_ALIASES = {
    "oat milk": [("oat drink", "milk")], "soy milk": [("soy drink", "milk"), ("soya drink", "milk")],
    "almond milk": [("almond drink", "milk")], "egg": [("", "eggs"), ("pickled egg", None)],
    "cheese": [("", "cheese")], "pasta": [("", "pasta")], "chip": [("crisp", "crisps"), ("chip", "crisps")], "cooky": [("cooky", "biscuits"), ("biscuit", "biscuits")],
    "ice cream": [("", "ice cream")], "pet food": [("", "pet food")], "hot dog": [("frankfurter", None)],
    "cola": [("cola mix", "soft drinks")], "doughnut": [("donut", None), ("berliner", "pastry")],
    "seaweed": [("seaweed snack", None)],
    "newspaper": [("newspaper", None)], "sandwich": [("sandwich", "ready meals")],
    "ready meal": [("", "ready meals")], "soft drink": [("", "soft drinks")],
}
# What people say of how goods are kept, which no label says.
KEPT = {"frozen": {"frozen"}, "canned": {"canned", "tinned"}}
# Goods of that name that are something else.
NOT_MEANT = {"egg": {"snacks"}}
NOT_COWS = {"goat", "sheep", "oat", "soy", "soya", "almond", "coconut", "rice", "drink", "nut", "pea"}
STOP_WORDS = set("a an the and or of to in on at by for with from is are be it its that this which we i you he she they them "
                 "our my your their his her can could would should will shall may me us as has have had do does not no "
                 "when where while what how also so too then there here please".split())
CJK = re.compile(r"[㐀-鿿]")
PARTICLES = set("的了在是把也都就和与及要能不有一个上里请")


def stem(word):
    word = word.lower().removesuffix("'s")
    if word.endswith("ies") and len(word) > 3:
        return word[:-3] + "y"
    if word.endswith("ie") and len(word) > 4:
        return word[:-2] + "y"
    if word.endswith(("ches", "shes", "xes", "oes")) and len(word) > 4 and word != "shoes":
        return word[:-2]
    if word.endswith("s") and not word.endswith("ss") and len(word) > 3:
        return word[:-1]
    return word


def words_of(text):
    return [stem(w) for w in re.findall(r"[^\W\d_]+(?:'[^\W\d_]+)?", text)]


def is_named(product, wish):
    """A wish for goods: its last word ends the product's name, its other words stand in name or variant, or
    say how it is kept."""
    wanted = words_of(wish)
    key = " ".join(wanted)
    if product["category"] in NOT_MEANT.get(key, ()):
        return False
    name = words_of(product["name"])
    if key == "cow milk":
        every = set(name) | set(words_of(product["variant"] + " " + " ".join(product["keywords"])))
        return product["subcategory"] == "milk" and "milk" in every and not every & NOT_COWS
    for label, subcategory in GOODS_ALIASES.get(key, ()):
        if subcategory in (None, product["subcategory"]) and all(w in name for w in words_of(label)):
            return True
    if key in GOODS_ALIASES and GOODS_ALIASES[key][0][0] == "" or key == "sandwich":
        return False  # the subcategory decides
    described = set(name) | set(words_of(product["variant"])) | KEPT.get(product["category"], set())
    return bool(name) and name[-1] == wanted[-1] and all(w in described for w in wanted)


def places_of(text, prompt):
    """Character ranges at which the text stands in the prompt."""
    return [(m.start(), m.end()) for m in re.finditer(re.escape(text), prompt, re.IGNORECASE)] if text.strip() else []


def span_in_characters(span, prompt):
    data = prompt.encode("utf8")
    return len(data[:span[0]].decode("utf8", "ignore")), len(data[:span[1]].decode("utf8", "ignore"))


def spans_within(entry):
    """Every [first, past the last] pair under a key that speaks of spans."""
    found = []
    for key, value in entry.items():
        if "span" not in key or not isinstance(value, list):
            continue
        if len(value) == 2 and all(isinstance(v, int) for v in value):
            found.append(value)
        found += [v for v in value if isinstance(v, list) and len(v) == 2]
    return [s for s in found if s[1] > s[0]]


def reported_places(entry, prompt):
    """Where in the prompt an entry of the program's lists points to: its byte spans, else its words."""
    spans = spans_within(entry)
    if spans:
        return [span_in_characters(s, prompt) for s in spans]
    texts = [v for k, v in sorted(entry.items()) if isinstance(v, str) and k != "why" and len(v) >= 2]
    return [place for text in texts for place in places_of(text, prompt)]


def covered_share(place, places):
    characters = set(range(*place))
    hit = set().union(*[set(range(*p)) & characters for p in places]) if places else set()
    return len(hit) / max(1, len(characters))


def content_words(text):
    """(start, end, word) of the words that carry meaning; of Chinese every character but particles."""
    words = [(m.start(), m.end(), stem(m.group())) for m in re.finditer(r"[^\W_]+(?:'\w+)?", CJK.sub(" ", text))]
    signs = [(m.start(), m.end(), m.group()) for m in CJK.finditer(text) if m.group() not in PARTICLES]
    return [w for w in words if w[2] not in STOP_WORDS] + signs


def share_of_words_reported(text, prompt, entries):
    """The share of the text's content words that the entries point to in the prompt."""
    best = 0.0
    words = content_words(text)
    places = [p for e in entries for p in reported_places(e, prompt)]
    for start, _ in places_of(text, prompt):
        hit = sum(any(p[0] < start + w[1] and p[1] > start + w[0] for p in places) for w in words)
        best = max(best, hit / max(1, len(words)))
    return best


def says_words(text, entry):
    """The share of the text's content words that an entry's own sentences repeat."""
    said = {w[2] for v in entry.values() if isinstance(v, str) for w in content_words(v)}
    words = [w[2] for w in content_words(text)]
    return sum(w in said for w in words) / max(1, len(words))


def is_in_conflicts(text, prompt, conflicts):
    """At least half of the text's characters lie in what a conflict points to; where a conflict has no
    spans, at least half of the text's content words are repeated by it."""
    for entry in conflicts:
        places = reported_places(entry, prompt)
        if any(covered_share(place, places) >= 0.5 for place in places_of(text, prompt)):
            return True
        if not spans_within(entry) and says_words(text, entry) >= 0.5:
            return True
    return False
