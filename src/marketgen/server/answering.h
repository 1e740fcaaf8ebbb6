// What addresses have in common: numbers and rows in what is asked, files as answers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "server/view_files.h"
#include "web/http_message.h"

namespace marketgen::server {

// What errors call the body of what is asked.
inline constexpr const char* body_name = "request";

Result<web::HttpReply> reply_with(ViewFile file);

// Of an address that nothing is at.
Error no_address(const web::HttpAsk& ask);

// A part of the path as a row of so many. Error: server.not_found.
Result<std::uint32_t> row_of(const web::HttpAsk& ask, std::string_view text, std::size_t rows);

// A number in the query; `usual` when it is not there. Error: server.bad_request.
Result<std::uint64_t> number_in(const web::HttpAsk& ask,
                                const std::string& name,
                                std::uint64_t usual,
                                std::uint64_t low,
                                std::uint64_t high);

}  // namespace marketgen::server
