// Errors are values: what every function that can fail returns.
//
// An Error names a stable code from error_codes.inc, the place (JSON pointer, file:line, flag) and
// a message that says what was wrong, what was expected and what to do. Exceptions never cross a
// module border.
#pragma once
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>

namespace marketgen {

struct Error {
  std::string code;     // "plan.unknown_field": one of error_codes.inc, kept for ever
  std::string where;    // "riverside.json:/zones/2/fixture/tiers", "--size", "shop/scene.bin"
  std::string message;  // a sentence for a person
};

// "error[code] where: message", the one form in which errors are shown.
std::string to_string(const Error& error);

// Ends the process after printing `message`: for broken invariants of our own, never for bad input.
[[noreturn]] void fatal(const char* message);

// Either a value or an Error. Reading the wrong side is a programming fault and ends the process.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Result(Error error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& { return *checked_value(&state_); }
  T& value() & { return *checked_value(&state_); }
  // By value, so that `for (x : f().value())` reads nothing that is gone.
  T value() && { return std::move(*checked_value(&state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const& {
    if (ok()) fatal("Result::error() called on a value");
    return std::get<1>(state_);
  }

 private:
  template <class State>
  static auto checked_value(State* state) {
    auto* value = std::get_if<0>(state);
    if (value == nullptr) fatal(std::get<1>(*state).message.c_str());
    return value;
  }

  std::variant<T, Error> state_;
};

// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  const Error& error() const& {
    if (ok()) fatal("Result::error() called on success");
    return std::get<1>(state_);
  }

 private:
  std::variant<std::monostate, Error> state_;
};

}  // namespace marketgen

#define MARKETGEN_JOIN_INNER(a, b) a##b
#define MARKETGEN_JOIN(a, b) MARKETGEN_JOIN_INNER(a, b)

// MARKETGEN_TRY(const Plan plan, read_plan(path)); declares `plan`, or returns the error to the
// caller.
#define MARKETGEN_TRY(declaration, expression)           \
  auto MARKETGEN_JOIN(result_, __LINE__) = (expression); \
  if (!MARKETGEN_JOIN(result_, __LINE__).ok()) {         \
    return MARKETGEN_JOIN(result_, __LINE__).error();    \
  }                                                      \
  declaration = std::move(MARKETGEN_JOIN(result_, __LINE__)).value()

// MARKETGEN_CHECK(write_file(path, bytes)); returns the error of a Result<void> to the caller.
#define MARKETGEN_CHECK(expression)                          \
  if (auto MARKETGEN_JOIN(result_, __LINE__) = (expression); \
      !MARKETGEN_JOIN(result_, __LINE__).ok()) {             \
    return MARKETGEN_JOIN(result_, __LINE__).error();        \
  }                                                          \
  static_assert(true)
