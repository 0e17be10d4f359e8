// What a reader did with a file that its user should know: columns taken, points left out, notes.
#pragma once
#include <string>
#include <vector>

#include "knotfit/source_data.h"
namespace knotfit::tool {

struct Reading {
  std::vector<std::string> columns;  ///< what each was taken for; empty: the format says it
  std::string from;                  ///< "option", "header", "guess"
  Index left_out = 0;                ///< points that miss a value
  std::vector<std::string> notes;
};

Reading reading_of(const SourceData& data);

/// "columns: x y z - (by the header; - left out)" and a line end; nothing where the format says it.
std::string columns_to_text(const Reading& reading);
/// "note: ..." and a line end, each.
std::string notes_to_text(const Reading& reading);

}  // namespace knotfit::tool
