#include "formats/npy_header.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/support.h"
namespace knotfit::test {
namespace {

NpyHeader header(const std::string& dictionary, const std::string& data, int version = 1) {
  return parse_npy_header(FileBytes("a.npy", npy(dictionary, data, version)));
}

TEST(NpyHeader, SaysTypeOrderShapeAndWhereTheItemsBegin) {
  for (const int version : {1, 2, 3}) {
    const NpyHeader h = header(npy_dictionary(">i4", "2, 3", true), std::string(24, 'x'), version);
    EXPECT_EQ(h.kind, 'i');
    EXPECT_EQ(h.item_size, 4);
    EXPECT_TRUE(h.big_endian);
    EXPECT_TRUE(h.fortran_order);
    EXPECT_EQ(h.shape, (std::vector<Index>{2, 3}));
    EXPECT_EQ(h.count(), 6);
    EXPECT_EQ(h.offset % 64, 0u);
  }
  const NpyHeader h = header(npy_dictionary("<f8", "5,"), std::string(40, 'x'));
  EXPECT_FALSE(h.big_endian || h.fortran_order);
  EXPECT_EQ(h.shape, (std::vector<Index>{5}));
}

TEST(NpyHeader, IsHeldAgainstTheBytesThatFollow) {
  const auto bad = [](const std::string& shape, std::size_t bytes, const std::string& words) {
    expect_throw<FileError>([&] { header(npy_dictionary("<f8", shape), std::string(bytes, 'x')); }, words);
  };
  bad("3, 2", 47, "but only 47 bytes follow");
  bad("3, 2", 49, "make 48 bytes, but 49 follow the header");
  bad("0, 2", 0, "an array of shape 0 x 2 holds no points");
  bad("4000000000, 4000000000, 4000000000", 8, "but only 8 bytes follow");
}

TEST(ShapeText, IsAProduct) {
  EXPECT_EQ(shape_text({240, 320, 3}), "240 x 320 x 3");
  EXPECT_EQ(shape_text({}), "()");
}

}  // namespace
}  // namespace knotfit::test
