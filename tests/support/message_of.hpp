// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <exception>
#include <string>

namespace fde::bench {

// The message with which a call throws; "accepted" if it does not.
template <class Error = std::exception, class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

// Expects that the call throws with this text in its message.
template <class Error = std::exception, class Call>
void expect_message(const Call& call, const std::string& part) {
  const std::string message = message_of<Error>(call);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

}  // namespace fde::bench
