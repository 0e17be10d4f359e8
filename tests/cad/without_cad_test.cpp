#include <gtest/gtest.h>

#include "knotfit/cad.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

TEST(WithoutCad, SaysWhatToDo) {
  EXPECT_FALSE(cad_available());
  expect_throw<InvalidInput>([] { write_cad("a.step", {}, {}, false); }, "-DKNOTFIT_WITH_CAD=ON");
  expect_throw<InvalidInput>([] { read_cad("a.step"); },
                             "a.step: this knotfit was built without CAD exchange");
}

}  // namespace
}  // namespace knotfit::test
