// The header of a PCD file.
#pragma once
#include <string>
#include <vector>

#include "formats/binary_number.h"
#include "formats/file_bytes.h"
#include "knotfit/index.h"
namespace knotfit {

struct PcdField {
  std::string name;  ///< "_": padding
  NumberType type{'f', 4};
  Index count = 1;  ///< numbers of a point
  Index bytes() const { return count * type.size; }
};

enum class PcdEncoding { ascii, binary, compressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  Index width = 0, height = 1, points = 0;
  PcdEncoding encoding = PcdEncoding::ascii;
  std::size_t offset = 0;  ///< of the data in the file
  Index lines = 0;         ///< of the header
  Index point_bytes() const {
    Index sum = 0;
    for (const PcdField& field : fields) sum += field.bytes();
    return sum;
  }
};

/// \throws FileError  no PCD file, a line that cannot be read, fields that do not agree; names the line
PcdHeader parse_pcd_header(const FileBytes& file);

}  // namespace knotfit
