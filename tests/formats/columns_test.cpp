// What a name in a header stands for.
#include "formats/column_guess.h"
#include "support.h"
namespace knotfit::test {
namespace {

using Words = std::vector<std::string>;
using Rows = std::vector<std::vector<double>>;

TEST(ColumnNames, EveryNameOfAHeaderIsKnown) {
  const SourceData data = read("a.csv", "x,y,z,t\n1,2,3,0\n4,5,6,1\n");
  EXPECT_EQ(data.columns, (Words{"x", "y", "z", "time"}));
  EXPECT_TRUE(content<PointTable>(data).v.empty());
  EXPECT_EQ(read("a.csv", "x,y,z,u,t\n1,2,3,0,1\n").columns, (Words{"x", "y", "z", "u", "v"}));
  EXPECT_EQ(read("a.csv", "x,y,z,s,t\n1,2,3,0,1\n").columns, (Words{"x", "y", "z", "u", "v"}));
  EXPECT_EQ(read("a.csv", "x,y,z,u,v,t\n1,2,3,0,1,9\n").columns, (Words{"x", "y", "z", "u", "v", "time"}));
  EXPECT_EQ(read("a.csv", "x,y,z,s\n1,2,3,0\n").columns, (Words{"x", "y", "z", "s"}));
  EXPECT_EQ(read("a.csv", "X,Y,Z,Red,GREEN,b,Intensity,gps_time,Classification,mine\n1,2,3,0,0,0,0,0,0,0\n")
                .columns,
            (Words{"x", "y", "z", "r", "g", "b", "intensity", "time", "class", "-"}));
  ReadOptions options;
  options.columns = {"r", "g", "b", "x", "y", "z", "time", "intensity"};
  const SourceData named = read("a.xyz", "1 2 3 4 5 6 7 8\n", options);
  EXPECT_EQ(content<PointTable>(named).x, (std::vector<double>{4}));
  EXPECT_EQ(named.columns, options.columns);
  EXPECT_EQ(named.columns_from, "option");
  options.columns = {"x", "y", "q"};
  expect_throw<InvalidInput>([&] { read("a.csv", "1,2,3\n", options); }, "unknown column \"q\"");
}

}  // namespace
}  // namespace knotfit::test
