#pragma once
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace laver::test {

/// Expects an Error of that code whose message is one line and contains `part`.
template <class Action>
void expectError(ExitCode code, const std::string& part, Action action) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.code(), code) << text;
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

}  // namespace laver::test
