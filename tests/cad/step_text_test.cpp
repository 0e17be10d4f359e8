#include <gtest/gtest.h>

#include "formats/cad/occt.h"
#include "formats/support.h"
#include "knotfit/cad.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(StepText, IsShortAndStandard) {
  const auto tidied = [](const std::string& text, const std::string& wanted) {
    EXPECT_EQ(cad::tidy_step(text), wanted);
  };
  tidied("(1.0000000000000000E+00,-2.5000000000000000E-01,0.0000000000000000E+00)", "(1.,-0.25,0.)");
  tidied("(1.0000000000000000E-07,\n  3.3333333333333331E-01)", "(1.E-07,\n  0.3333333333333333)");
  tidied("#12 = X(3,(4,1,4),#7,.F.);", "#12 = X(3,(4,1,4),#7,.F.);");
  tidied("('1.0000 \n2.50',1.50E+00)", "('1.0000 2.50',1.5)");
  tidied("'\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80\xE4'",
         "'\\X2\\00E4\\X0\\\\X2\\20AC\\X0\\\\X4\\0001F600\\X0\\\\X2\\00E4\\X0\\'");
  tidied("'it''s'", "'it''s'");
  tidied("", "");
}

}  // namespace
}  // namespace knotfit::test
