// The data of a PLY file, row by row: the same calls for text and for bytes.
#pragma once
#include <memory>
#include <string>

#include "formats/ply_header.h"
namespace knotfit {

class PlyRows {
 public:
  virtual ~PlyRows() = default;
  /// \throws FileError  the rows of the element cannot be in the bytes that follow
  virtual void begin_element(const PlyElement& element) = 0;
  virtual void begin_row(Index row) = 0;
  /// The next number of the row. \throws FileError  none is left, or no number
  virtual double next(NumberType type) = 0;
  /// The same for the entries of a list: how many there are, checked against what follows.
  virtual Index next_count(const PlyProperty& list) = 0;
  /// Leaves out the next `count` numbers.
  virtual void skip(NumberType type, Index count) = 0;
  /// Triangles in the element's rows, by the corners of its list `corners`: at least as many as there are, a few
  /// more where a text's rows hold other numbers too. Moves nothing; a damaged row, or one of more corners than
  /// `most`, ends the count.
  virtual Index triangles(const PlyElement& element, const PlyProperty& corners, Index most) const = 0;
  virtual void end_row() = 0;
  /// \return what follows the last element, a sentence; empty where nothing does
  virtual std::string end_file() = 0;
  /// Line of the row at hand, from 1; 0: binary.
  virtual Index line() const = 0;
};

std::unique_ptr<PlyRows> ply_rows(const FileBytes& file, const PlyHeader& header);

}  // namespace knotfit
