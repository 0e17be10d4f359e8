#include "knotfit/control.h"

#include <gtest/gtest.h>
namespace knotfit {
namespace {

using std::chrono::seconds;
using std::chrono::steady_clock;

TEST(Control, WithoutALimitTheRestHasNone) {
  const auto long_ago = steady_clock::now() - seconds(1000);
  EXPECT_EQ(time_left({}, long_ago).time_limit, 0);
  EXPECT_FALSE(out_of_time({}, long_ago));
}

TEST(Control, TheRestIsWhatIsLeft) {
  Control control;
  control.time_limit = 1000;
  const auto start = steady_clock::now() - seconds(400);
  const double left = time_left(control, start).time_limit;
  EXPECT_LE(left, 600);
  EXPECT_GT(left, 500);
  EXPECT_FALSE(out_of_time(control, start));
}

TEST(Control, NothingLeftIsAMillisecondAndNotNoLimit) {
  Control control;
  control.time_limit = 1;
  const auto start = steady_clock::now() - seconds(5);
  EXPECT_EQ(time_left(control, start).time_limit, 1e-3);
  EXPECT_TRUE(out_of_time(control, start));
}

TEST(Control, TheRestReportsAndStopsAsTheWhole) {
  std::stop_source source;
  int reports = 0;
  Control control;
  control.progress = [&](const Progress&) { ++reports; };
  control.stop = source.get_token();
  const Control rest = time_left(control, steady_clock::now());
  rest.progress({});
  source.request_stop();
  EXPECT_EQ(reports, 1);
  EXPECT_TRUE(rest.stop.stop_requested());
}

}  // namespace
}  // namespace knotfit
