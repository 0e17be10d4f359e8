// Files that are checked before they get their name.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
namespace knotfit {

/// write_file, with a look at what was written: `check` gets the temporary file's path once all of it is on disk.
/// Where it throws, nothing is left behind and the target stays as it was.
/// \throws FileError  also where the target is no plain file
void write_checked_file(const std::string& path, bool force, const std::function<void(std::ostream&)>& write,
                        const std::function<void(const std::string&)>& check);

}  // namespace knotfit
