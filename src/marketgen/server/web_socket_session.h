// Carries a websocket (RFC 6455, by Boost.Beast) on a connection that has asked for one.
//
// A page that sends anything but text, a message of more than 4 kB, or more than 200 messages in a
// second is cut off, and so is one that answers no ping for 20 seconds, or does not take 64 texts.
#pragma once
#include <atomic>
#include <memory>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "server/web_socket.h"

namespace marketgen::server {

// `connections` counts it while it lives.
void carry_web_socket(boost::asio::ip::tcp::socket socket,
                      const boost::beast::http::request<boost::beast::http::string_body>& request,
                      std::unique_ptr<SocketPeer> peer,
                      std::atomic<int>& connections);

}  // namespace marketgen::server
