// The header of a NumPy array file.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "formats/file_bytes.h"
#include "knotfit/index.h"
namespace knotfit {

/// What the header says, checked against the size of the file.
struct NpyHeader {
  char kind = 'f';    ///< f: floating, i: signed, u: unsigned
  int item_size = 8;  ///< bytes
  bool big_endian = false;
  bool fortran_order = false;
  std::vector<Index> shape;
  std::size_t offset = 0;  ///< of the first item
  Index count() const {
    Index product = 1;
    for (const Index n : shape) product *= n;
    return product;
  }
};

inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// Header of versions 1 to 3 [NumPy, numpy.lib.format]: a Python dictionary of literals, parsed as
/// such and never evaluated.
/// \throws FileError  not NPY, malformed, a type that holds no plain real numbers, or a shape that
///   the bytes of the file do not fill exactly
NpyHeader parse_npy_header(const FileBytes& file);

/// "240 x 320 x 3"
std::string shape_text(const std::vector<Index>& shape);

}  // namespace knotfit
