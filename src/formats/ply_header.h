// The header of a PLY file [Turk94].
#pragma once
#include <string>
#include <vector>

#include "formats/binary_number.h"
#include "formats/file_bytes.h"
#include "knotfit/index.h"
namespace knotfit {

struct PlyProperty {
  std::string name;
  NumberType type;
  bool list = false;
  NumberType count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  Index count = 0;
  std::vector<PlyProperty> properties;
  /// Bytes of a row in a binary file; of one with lists the least.
  Index row_bytes() const;
  bool has_list() const;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t offset = 0;  ///< where the data begins
  Index lines = 0;         ///< of the header
};

/// \throws FileError  not PLY, or a header that makes no sense: names the line
PlyHeader parse_ply_header(const FileBytes& file);

}  // namespace knotfit
