#include "web/edit_lease.h"

#include <random>

#include <fmt/format.h>

namespace marketgen::web {

std::string new_token() {
  std::random_device system;
  std::string token;
  for (int word = 0; word < 4; ++word)
    token += fmt::format("{:08x}", system());
  return token;
}

bool same_secret(std::string_view given, std::string_view secret) {
  unsigned char differ = given.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < secret.size(); ++i)
    differ |= static_cast<unsigned char>((i < given.size() ? given[i] : '\0') ^ secret[i]);
  return differ == 0;
}

std::optional<std::string> EditLease::take(std::string_view held, Clock::time_point now) {
  if (holds(held, now)) return token_;
  if (is_taken(now)) return std::nullopt;
  token_ = new_token();
  heard_ = now;
  return token_;
}

bool EditLease::holds(std::string_view token, Clock::time_point now) {
  if (token_.empty() || !same_secret(token, token_)) return false;
  heard_ = now;
  return true;
}

void EditLease::give_back(std::string_view token) {
  if (!token_.empty() && same_secret(token, token_)) token_.clear();
}

bool EditLease::is_taken(Clock::time_point now) const {
  return !token_.empty() && now - heard_ < lease_time;
}

}  // namespace marketgen::web
