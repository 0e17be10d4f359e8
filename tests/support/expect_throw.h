// An error is checked by its type and its words.
#pragma once
#include <gtest/gtest.h>

#include <string>
namespace knotfit::test {

template <class Error, class Action>
void expect_throw(const Action& action, const std::string& words) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown; expected \"" << words << "\"";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
        << "message: " << error.what() << "\nexpected in it: " << words;
  }
}

}  // namespace knotfit::test
