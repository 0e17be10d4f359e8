#include "formats/json_reader.h"

#include <nlohmann/json.hpp>

#include "support.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

bool accepts(const std::string& text) {
  const std::string path = "a.json";
  JsonReader reader(text, text, path);
  try {
    reader.skip();
    reader.finish();
    return true;
  } catch (const FileError&) {
    return false;
  }
}

const std::string kText = R"({"a": [1, -2.5e+3, 0, 0.1E-2, []], "b\u00e9\n": {"c": true, "d": null, "e": {}},
 "f": false, "g": "\ud83d\ude00 \\ \" / \/ é 😀"})";

// nlohmann-json is the witness: the same texts are JSON.
TEST(JsonReader, AcceptsWhatIsJsonAndNothingElse) {
  for (const char* text : {"",
                           " ",
                           "1",
                           "-",
                           "01",
                           "1.",
                           ".5",
                           "1e",
                           "+1",
                           "-0",
                           "1e5",
                           "tru",
                           "true",
                           "nul",
                           "null",
                           "\"",
                           "\"a\"",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\ud800\"",
                           "\"\\udc00\"",
                           "\"\\ud800\\u0041\"",
                           "\"\x01\"",
                           "\"\xff\"",
                           "\"\xc0\x80\"",
                           "\"\xed\xa0\x80\"",
                           "\"\xf4\x90\x80\x80\"",
                           "\"\xe2\x82\"",
                           "[",
                           "[]",
                           "[1,]",
                           "[,]",
                           "[1 2]",
                           "{",
                           "{}",
                           "{\"a\"}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "{\"a\":1 \"b\":2}",
                           "[1]x",
                           "{}{}",
                           "\xef\xbb\xbf{",
                           "NaN",
                           "[1]]"})
    EXPECT_EQ(accepts(text), nlohmann::json::accept(std::string(text))) << text;
  EXPECT_TRUE(accepts(kText));
  Random random;
  int good = 0;
  for (int k = 0; k < 50000; ++k) {
    std::string text = kText;
    for (int change = random.integer(1, 3); change > 0; --change) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
      if (random.integer(0, 2) == 0)
        text.erase(at, 1);
      else
        text[at] = random.integer(0, 1) == 0 ? "{}[],:\"\\0123e.-+tfn u"[random.integer(0, 20)]
                                             : static_cast<char>(random.integer(1, 255));
    }
    const bool witness = nlohmann::json::accept(text);
    good += witness;
    ASSERT_EQ(accepts(text), witness) << text;
  }
  EXPECT_GT(good, 1000);
}

TEST(JsonReader, ReadsTheSameValues) {
  const std::string path = "a.json";
  JsonReader reader(kText, kText, path);
  const auto members = reader.members();
  const nlohmann::json witness = nlohmann::json::parse(kText);
  ASSERT_EQ(members.size(), witness.size());
  for (const auto& [name, text] : members) {
    ASSERT_TRUE(witness.contains(name)) << name;
    EXPECT_EQ(nlohmann::json::parse(text), witness[name]);
    JsonReader value(kText, text, path);
    if (value.peek() == JsonReader::Kind::string) {
      EXPECT_EQ(value.string(), witness[name].get<std::string>());
    }
  }
}

TEST(JsonReader, QuotedStringsReadBack) {
  for (const std::string text : {"", "u", "a \"b\" \\ \n\t\x01", "é😀"}) {
    const std::string quoted_text = json_quoted(text);
    const std::string path;
    EXPECT_EQ(JsonReader(quoted_text, quoted_text, path).string(), text);
    EXPECT_EQ(nlohmann::json::parse(quoted_text).get<std::string>(), text);
  }
  EXPECT_EQ(json_quoted("\xff"), "\"\xEF\xBF\xBD\"");
}

TEST(JsonReader, StopsAtDeepNesting) {
  std::string deep(5'000'000, '[');
  const std::string path = "deep.json";
  expect_throw<FileError>([&] { JsonReader(deep, deep, path).skip(); }, "nested deeper than 100");
  std::string objects;
  for (int k = 0; k < 100000; ++k) objects += "{\"a\":";
  expect_throw<FileError>([&] { JsonReader(objects, objects, path).skip(); }, "nested deeper than 100");
}

}  // namespace
}  // namespace knotfit::test
