#include "formats/json_members.h"

#include <gtest/gtest.h>

#include <string>

#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

const std::string kPath = "a.json";

JsonMembers members(const std::string& text) {
  return JsonMembers(text, text, kPath, "knotfit curve");
}

TEST(JsonMembers, AreFoundByName) {
  const std::string text = "{\"a\": 1.5, \"list\": [1, 2], \"none\": null}";
  const JsonMembers in = members(text);
  EXPECT_EQ(in.get("list"), "[1, 2]");
  EXPECT_EQ(in.find("none"), "null");
  EXPECT_FALSE(in.find("gone").has_value());
  EXPECT_EQ(in.at("a").number(), 1.5);
}

TEST(JsonMembers, SayWhatIsWrongAndWhere) {
  const auto bad = [](const std::string& text, const std::string& words, const auto& ask) {
    test::expect_throw<FileError>([&] { ask(members(text)); }, words);
  };
  bad("[1]", "a JSON object is missing", [](const JsonMembers&) {});
  bad("{\n\"a\": 1,\n\"a\": 2}", "a.json:3: a: the member is there twice",
      [](const JsonMembers& in) { in.get("a"); });
  bad("{\"a\": 1}", "not a knotfit curve: the member \"knots\" is missing",
      [](const JsonMembers& in) { in.get("knots"); });
  bad("{\"a\":\n \"x\"}", "a.json:2: a: ", [](const JsonMembers& in) { in.at("a").number(); });
}

}  // namespace
}  // namespace knotfit
