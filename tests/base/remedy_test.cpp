#include "knotfit/remedy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "knotfit/exceptions.h"

namespace knotfit {
namespace {

using List = std::vector<NamedRemedy>;

// As a program with options of its own may say it.
std::string shout(const NamedRemedy& r) {
  return "<" + std::string(remedy_name(r.remedy)) + (r.value.empty() ? "" : ":" + r.value) + ">";
}

TEST(Remedy, EveryOneHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Remedy remedy : all_remedies()) {
    const std::string_view name = remedy_name(remedy);
    EXPECT_FALSE(name.empty());
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos) << name;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kLastRemedy) + 1);
}

TEST(Remedy, IsNamedInBackquotes) {
  EXPECT_EQ(remedy_text(Remedy::fill_holes), "`fill_holes`");
  EXPECT_EQ(remedy_text(Remedy::base, "cylinder"), "`base = cylinder`");
}

TEST(Remedy, EveryTextReadsBack) {
  for (const Remedy remedy : all_remedies())
    for (const char* value : {"", "nan", "x,y,z,u,v", "-,x = y"}) {
      const std::string text = "do this: " + remedy_text(remedy, value) + " or not";
      EXPECT_EQ(remedies_in(text), (List{{remedy, value}})) << text;
    }
}

TEST(Remedy, ATextMayNameSeveral) {
  const std::string text =
      remedy_text(Remedy::columns, "x,y,z") + " or " + remedy_text(Remedy::skip_lines, "1");
  EXPECT_EQ(remedies_in(text), (List{{Remedy::columns, "x,y,z"}, {Remedy::skip_lines, "1"}}));
  EXPECT_EQ(say_remedies(text, shout), "<columns:x,y,z> or <skip_lines:1>");
}

TEST(Remedy, WhatIsNoneStaysAsItIs) {
  for (const char* text : {"", "no backquote", "one ` alone", "`", "``", "`no_such_name`", "`fill_holes",
                           "`fill holes`", "`Fill_holes`", "`fill_holes=1`", "`nodata nan`"}) {
    EXPECT_EQ(say_remedies(text, shout), text);
    EXPECT_EQ(remedies_in(text), List{}) << text;
  }
}

TEST(Remedy, ABackquoteOfAnotherTextHidesNone) {
  EXPECT_EQ(say_remedies("`a b`c: `orient` turns", shout), "`a b`c: <orient> turns");
  EXPECT_EQ(say_remedies("it`s `orient`", shout), "it`s <orient>");
  EXPECT_EQ(say_remedies("a file `x`orient`", shout), "a file `x<orient>");
}

TEST(Remedy, ExceptionsTellTheirs) {
  EXPECT_EQ(InvalidInput("two parts; " + remedy_text(Remedy::largest_part) + " keeps one").remedies(),
            (List{{Remedy::largest_part, ""}}));
  EXPECT_EQ(FileError("a.csv", 3, "z is empty; " + remedy_text(Remedy::nodata, "nan")).remedies(),
            (List{{Remedy::nodata, "nan"}}));
  EXPECT_EQ(InvalidInput("nothing helps").remedies(), List{});
}

}  // namespace
}  // namespace knotfit
