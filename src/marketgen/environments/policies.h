// Every policy of the program, by the name that environments/policy_name.h reads.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::environments {

inline constexpr std::array<std::string_view, 9> policies{"classical",
                                                          "highest",
                                                          "hybrid",
                                                          "oracle",
                                                          "oracle-plain",
                                                          "oracle-thorough",
                                                          "random",
                                                          "stop",
                                                          "vlm"};

}  // namespace marketgen::environments
