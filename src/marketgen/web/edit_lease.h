// Who may change a store: one page at a time, by a token that it is given.
//
// A page says every few seconds that it is still there. Who has not been heard of for `lease_time`
// loses his right as soon as somebody else asks for it, and keeps it as long as nobody does.
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace marketgen::web {

class EditLease {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds lease_time{30};

  // The token of who may go on; nothing while another one has the lease. `held` is the token that
  // he was given before, or empty.
  std::optional<std::string> take(std::string_view held, Clock::time_point now);
  // Whether the token is that of the lease; he was heard of then.
  bool holds(std::string_view token, Clock::time_point now);
  // Whoever has another token changes nothing.
  void give_back(std::string_view token);
  bool is_taken(Clock::time_point now) const;

 private:
  std::string token_;  // empty: nobody has it
  Clock::time_point heard_;
};

// 128 bits from the system, as 32 hex digits.
std::string new_token();
// Takes as long whatever the texts share, so that a secret cannot be guessed byte by byte.
bool same_secret(std::string_view given, std::string_view secret);

}  // namespace marketgen::web
