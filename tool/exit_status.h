// The tool's exit statuses.
#pragma once
namespace knotfit::tool {

enum ExitStatus : int {
  kReached = 0,     ///< done: the tolerance holds, or none was asked
  kOther = 1,       ///< anything else: a full disk, no memory, a result that failed its check
  kBadInput = 2,    ///< bad input or usage, an output that cannot be opened
  kNotReached = 3,  ///< written, but below what was asked
  kStopped = 130    ///< stopped by a signal; the best surface so far is written
};

}  // namespace knotfit::tool
