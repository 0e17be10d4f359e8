#include <nlohmann/json.hpp>

#include "knotfit/version.h"
#include "support.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

SurfaceDocument small() {
  SurfaceDocument d;
  d.surface = Surface(KnotVector::clamped(1, {}), KnotVector::clamped(2, std::vector<double>{0.1}), 1,
                      {1, 2, 3, 4, 5, 6, 7, 0.1});
  d.map = {"x", "y", -1.5, 2, 0, 1e-3};
  d.height_field = true;
  d.options = R"({"tol": "0.1%", "list": [1, 2.50]})";
  d.result = R"({"rms": 1e-3})";
  return d;
}

SurfaceDocument parse(const std::string& text) {
  return surface_from_json(text, "s.json");
}

void expect_equal(const SurfaceDocument& a, const SurfaceDocument& b) {
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.map, b.map);
  EXPECT_EQ(a.height_field, b.height_field);
  EXPECT_EQ(a.options, b.options);
  EXPECT_EQ(a.result, b.result);
}

TEST(SurfaceJson, EveryDoubleComesBackExactly) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    SurfaceDocument d;
    const int degree_u = random.integer(1, 9), degree_v = random.integer(1, 9), dim = random.integer(1, 4);
    const KnotVector u = random_knots(random, degree_u), v = random_knots(random, degree_v);
    std::vector<double> net(static_cast<std::size_t>(u.size() * v.size() * dim));
    for (double& c : net) c = random.uniform(-1, 1) * random.log_uniform(1e-300, 1e300);
    net[0] = -0.0;
    net.back() = 5e-324;
    d.surface = Surface(u, v, dim, net);
    d.map = {"a\"\\\n", "é", random.uniform(-1e9, 0), random.uniform(1, 2), -0x1.fffffffffffffp1000,
             0x1p-1074};
    const SurfaceDocument back = parse(to_json(d));
    expect_equal(back, d);
    EXPECT_TRUE(std::signbit(back.surface.net()[0]));
    EXPECT_EQ(to_json(back), to_json(d));
  }
}

TEST(SurfaceJson, HoldsTheDocumentedMembers) {
  const nlohmann::json j = nlohmann::json::parse(to_json(small()));
  EXPECT_EQ(j["format"], "knotfit-surface");
  EXPECT_EQ(j["version"], 1);
  EXPECT_EQ(j["knotfit"], std::string(version()));
  EXPECT_EQ(j["degree"], nlohmann::json({1, 2}));
  EXPECT_EQ(j["knots_u"], nlohmann::json({0, 0, 1, 1}));
  EXPECT_EQ(j["knots_v"], nlohmann::json({0, 0, 0, 0.1, 1, 1, 1}));
  EXPECT_EQ(j["height_field"], true);
  EXPECT_EQ(j["parameter_map"]["name_u"], "x");
  EXPECT_EQ(j["parameter_map"]["u0"], -1.5);
  EXPECT_EQ(j["parameter_map"]["v1"], 1e-3);
  EXPECT_EQ(j["options"]["tol"], "0.1%");
  EXPECT_EQ(j["result"]["rms"], 1e-3);
  const nlohmann::json& net = j["control_points"];  // [size_u][size_v][dimension]
  ASSERT_EQ(net.size(), 2U);
  ASSERT_EQ(net[1].size(), 4U);
  EXPECT_EQ(net[1][3], nlohmann::json::array({0.1}));
}

TEST(SurfaceJson, OptionsAndResultKeepTheirText) {
  expect_equal(parse(to_json(small())), small());
  SurfaceDocument d = small();
  d.options = d.result = "";
  expect_equal(parse(to_json(d)), d);
  d.options = "[1]";
  expect_throw<InvalidInput>([&] { to_json(d); }, "the options of a surface document must be a JSON object");
  d.options = "{\"a\": }";
  expect_throw<InvalidInput>([&] { to_json(d); }, "must be a JSON object");
  d.options = "";
  d.result = "{} {}";
  expect_throw<InvalidInput>([&] { to_json(d); }, "the result of a surface document");
}

TEST(SurfaceJson, RefusesToWriteWhatCannotBeRead) {
  expect_throw<InvalidInput>([] { to_json({}); }, "without a surface");
  SurfaceDocument d = small();
  d.map.u1 = d.map.u0;
  expect_throw<InvalidInput>([&] { to_json(d); }, "must be below u1");
  d.map.u1 = kInf;
  expect_throw<InvalidInput>([&] { to_json(d); }, "its ends must be finite");
}

TEST(SurfaceJson, TheSurfaceMayStandUnderSurface) {
  const std::string inner = to_json(small());
  expect_equal(parse("{\"surface\": " + inner + ", \"status\": \"reached\", \"degree\": \"any\"}"), small());
  SurfaceDocument bare = small();
  bare.options = "";
  SurfaceDocument with = bare;
  with.options = "{\"a\": 1}";
  expect_equal(parse("{\"options\": {\"a\": 1}, \"surface\": " + to_json(bare) + "}"), with);
}

TEST(SurfaceJson, MembersInAnyOrderAndOnlyThoseNeeded) {
  const SurfaceDocument d = parse(
      "\xEF\xBB\xBF{\"control_points\": [[[1],[2]],[[3],[4]]], \"extra\": [null], \"knots_v\": [0,0,1,1],\n"
      "\"knots_u\": [0,0,1,1], \"degree\": [1,1]}");
  EXPECT_EQ(d.surface.net(), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_TRUE(d.map.identity());
  EXPECT_FALSE(d.height_field);
  EXPECT_TRUE(d.options.empty());
}

TEST(SurfaceJson, NamesTheBadMember) {
  const auto refuse = [](const std::string& member, const std::string& value, const std::string& words) {
    nlohmann::ordered_json j = nlohmann::ordered_json::parse(to_json(small()));
    if (value.empty())
      j.erase(member);
    else
      j[member] = nlohmann::ordered_json::parse(value);
    SCOPED_TRACE(member + " = " + value);
    expect_throw<FileError>([&] { parse(j.dump(1)); }, words);
    expect_throw<FileError>([&] { parse(j.dump(1)); }, "s.json:");
  };
  refuse("format", "\"gismo\"", "format: \"gismo\" is a foreign schema");
  refuse("format", "3", "format: a name is missing");
  refuse("version", "2", "version: version 2 of the schema is unknown");
  refuse("degree", "", "the member \"degree\" is missing");
  refuse("degree", "[1]", "degree: two whole numbers from 1 to 9");
  refuse("degree", "[1, 2, 3]", "degree: two whole numbers");
  refuse("degree", "[1.5, 2]", "degree: two whole numbers");
  refuse("degree", "[0, 2]", "degree: two whole numbers");
  refuse("degree", "[1, 10]", "degree: two whole numbers");
  refuse("knots_u", "", "the member \"knots_u\" is missing");
  refuse("knots_u", "[0, 0, 1, \"a\"]", "knots_u: a number is missing");
  refuse("knots_u", "[1, 1, 0, 0]", "knots_u: ");
  refuse("knots_v", "[0]", "knots_v: ");
  refuse("knots_v", "[0, 0, 0, 1, 1, 1]", "control_points: row 0 (from 0) has more than the 3 points");
  refuse("knots_u", "[0, 0, 0.5, 1, 1]", "control_points: 2 rows, but degree and knots_u ask for 3");
  refuse("control_points", "", "the member \"control_points\" is missing");
  refuse("control_points", "[]", "control_points: 0 numbers are no 2 x 4 control points");
  refuse("control_points", "[1, 2]", "control_points: 2 numbers are no 2 x 4 control points");
  refuse("control_points", "[[1, 2], [3, 4]]",
         "control_points: 2 entries of 2 numbers are no 2 x 4 control points");
  refuse("control_points", "[[1, 2], [3]]",
         "control_points: entry 1 (from 0) has 1 numbers, the first has 2");
  refuse("control_points", "[[[[1]]]]", "control_points: ");
  refuse("control_points", "[[[1],[1],[1],[1]],[[1],[1],[1]]]",
         "control_points: row 1 (from 0) has 3 points");
  refuse("control_points", "[[[1],[1],[1],[1]],[[1],[1],[1],[1,2]]]",
         "control_points: point (1, 3) has 2 components");
  refuse("control_points", "[[[],[],[],[]],[[],[],[],[]]]", "control_points: point (0, 0) has 0 components");
  refuse("control_points", "[[[1],[1],[1],[1]],[[1],[1],[1],[1]],[[1],[1],[1],[1]]]",
         "control_points: more than the 2 rows");
  refuse("control_points", "[[[1],[1],[1],[1]],[[1],[1],[1],[null]]]", "control_points: a number is missing");
  refuse("parameter_map", "[]", "a JSON object is missing");
  refuse("parameter_map", "{\"u0\": 0, \"u1\": 1, \"v0\": 0}", "\"v1\" is missing");
  refuse("parameter_map", "{\"u0\": 0, \"u1\": \"1\", \"v0\": 0, \"v1\": 1}",
         "parameter_map.u1: a number is missing");
  refuse("parameter_map", "{\"u0\": 0, \"u1\": 0, \"v0\": 0, \"v1\": 1}",
         "parameter_map: u0 = 0 must be below u1 = 0");
  refuse("height_field", "1", "height_field: true or false is missing");
  refuse("options", "3", "options: an object is missing");
  refuse("surface", "3", "a JSON object is missing");
}

TEST(SurfaceJson, RefusesWhatIsNoSurface) {
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "a JSON object is missing"},
           {"hello", "a JSON object is missing"},
           {"[1]", "a JSON object is missing"},
           {"{", "the file ends too early"},
           {"{}", "s.json:1: not a knotfit surface: the member \"degree\" is missing"},
           {"{}\n x", "s.json:2: something follows"},
           {"{\"degree\": [1,1],\n\"degree\": [1,1]}", "s.json:2: degree: the member is there twice"},
           {"{\n\"degree\": [1,1}", "s.json:2: ',' or ']' is missing in an array"}})
    expect_throw<FileError>([&, t = text] { parse(t); }, words);
  std::string huge = to_json(small());
  huge.replace(huge.find("[0.1]"), 5, "[1e999]");
  expect_throw<FileError>([&] { parse(huge); }, "control_points: \"1e999\" is beyond the range of a double");
}

TEST(SurfaceJson, TheDocumentedExampleIsASurface) {
  const std::string text = bytes_of(std::filesystem::path(KNOTFIT_TEST_DATA) / "../../docs/formats.md");
  const std::size_t begin = text.find("```json\n"), end = text.find("```", begin + 8);
  ASSERT_NE(end, std::string::npos);
  const SurfaceDocument d = parse(text.substr(begin + 8, end - begin - 8));
  EXPECT_EQ(d.surface.degree_u(), 3);
  EXPECT_EQ(d.surface.control_point_count(), 16);
  EXPECT_TRUE(d.height_field);
}

TEST(SurfaceJson, FilesOfSurfaces) {
  const TemporaryFolder folder;
  write_file(folder.file("s.json"), false, [](std::ostream& out) { out << to_json(small()); });
  expect_equal(read_surface(folder.file("s.json")), small());
  expect_throw<FileError>([&] { read_surface(folder.file("none.json")); }, "no such file");
}

// What other programs write: the same surface of 2 x 3 points (i, j) in every form.
TEST(SurfaceJson, ReadsTheFormsOfOtherPrograms) {
  const auto text = [](const std::string& degree, const std::string& net, const std::string& order) {
    return "{\"degree\": " + degree +
           ", \"knots_u\": [0,0,1,1], \"knots_v\": [0,0,0.5,1,1], \"control_points\": " + net +
           (order.empty() ? "" : ", \"order\": \"" + order + "\"") + "}";
  };
  const Surface wanted(KnotVector(1, {0, 0, 1, 1}), KnotVector(1, {0, 0, 0.5, 1, 1}), 2,
                       {0, 0, 0, 1, 0, 2, 1, 0, 1, 1, 1, 2});
  const auto expect = [&](const std::string& net, const std::string& order) {
    EXPECT_EQ(parse(text("1", net, order)).surface, wanted) << net << order;
    EXPECT_EQ(parse(text("[1, 1]", net, order)).surface, wanted) << net << order;
  };
  for (const std::string order : {"", "u-major"}) {
    expect("[[[0,0],[0,1],[0,2]],[[1,0],[1,1],[1,2]]]", order);
    expect("[[0,0],[0,1],[0,2],[1,0],[1,1],[1,2]]", order);
    expect("[ [0,0,0,1,0,2], [1,0,1,1,1,2] ]", order);
    expect("[0,0,0,1,0,2,1,0,1,1,1,2]", order);
  }
  expect("[[[0,0],[1,0]],[[0,1],[1,1]],[[0,2],[1,2]]]", "v-major");
  expect("[[[0,0],[0,1],[0,2]],[[1,0],[1,1],[1,2]]]", "v-major");  // its shape says that it is not
  expect("[[0,0],[1,0],[0,1],[1,1],[0,2],[1,2]]", "v-major");
  expect("[0,0,1,0,0,1,1,1,0,2,1,2]", "v-major");
  const Surface heights(wanted.knots_u(), wanted.knots_v(), 1, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(parse(text("1", "[[1,2,3],[4,5,6]]", "")).surface, heights);
  EXPECT_EQ(parse(text("1", "[[1,4],[2,5],[3,6]]", "v-major")).surface, heights);
  expect_throw<FileError>([&] { parse(text("1", "[1]", "rows")); },
                          "order: \"rows\" is neither \"u-major\" nor");
  expect_throw<FileError>([&] { parse(text("0", "[1]", "")); }, "degree: two whole numbers from 1 to 9");
}

}  // namespace
}  // namespace knotfit::test
