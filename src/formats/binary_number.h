// Numbers as bytes of either order.
#pragma once
namespace knotfit {

/// 'f' floating point, 'i' signed, 'u' unsigned, of 1, 2, 4 or 8 bytes.
struct NumberType {
  char kind = 'f';
  int size = 8;
};

using LoadNumber = double (*)(const char*);

/// The loader of a type; of 'f' there are 2 (IEEE binary16), 4 and 8 bytes.
LoadNumber number_loader(NumberType type, bool big_endian);

}  // namespace knotfit
