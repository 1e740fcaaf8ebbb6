// Answers as structs: a model is asked for JSON of a described struct, its answer is read strictly,
// and it gets one chance to mend what is wrong.
//
//   MARKETGEN_TRY(const auto answered, ask<Verdict>(model, request, check));
//   use(answered.value);
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/fields.h"
#include "io/json.h"
#include "llm/language_model.h"

namespace marketgen::llm {

// The JSON Schema of a described struct in the part of the language that every provider enforces:
// all fields required, none besides, no limits of length or size (the reader checks those).
std::string answer_schema_of(const TypeInfo& type);

// The schema with a top-level text field (or list of texts) held to `names`. A field that does not
// exist is a fault of ours and ends the process.
std::string with_names(const std::string& schema,
                       std::string_view field,
                       std::span<const std::string_view> names);

// The first JSON object in a text: the whole of it, or what stands among prose, in a fence, after a
// model's thoughts. Nothing when there is none.
std::optional<std::string> json_object_in(std::string_view text);

struct AnswerCost {
  int requests = 0;
  std::int64_t tokens_in = 0, tokens_out = 0;
};

// Reads an answer's JSON; its error goes back to the model, so it says all that is wrong.
using AnswerReader = std::function<Result<void>(const std::string& json)>;

// Asks, reads, and asks once more with the reader's error. request.answer_schema is also written
// out in the system text, for servers that do not enforce it. Errors: llm.bad_answer with the
// second error; those of LanguageModel::chat.
Result<AnswerCost> ask_for_json(const LanguageModel& model,
                                ChatRequest request,
                                const AnswerReader& read);

template <class T>
struct Answered {
  T value;
  AnswerCost cost;
};

// `check` is called with what was read and says what is wrong with its content. Without
// request.answer_schema, that of T is used.
template <class T>
Result<Answered<T>> ask(const LanguageModel& model,
                        ChatRequest request,
                        const std::function<Result<void>(const T&)>& check = {}) {
  if (request.answer_schema.empty()) request.answer_schema = answer_schema_of(type_of<T>());
  T value{};
  const AnswerReader read = [&](const std::string& json) -> Result<void> {
    MARKETGEN_TRY(value, io::read_json<T>(json, "answer"));
    if (check) MARKETGEN_CHECK(check(value));
    return {};
  };
  MARKETGEN_TRY(const AnswerCost cost, ask_for_json(model, std::move(request), read));
  return Answered<T>{std::move(value), cost};
}

}  // namespace marketgen::llm
