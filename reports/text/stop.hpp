// Ends a long command in order when a stop is requested: it keeps and shows its results so far.
#pragma once

#include "engines/system/system.hpp"

namespace graze::tool {

// While it lives, SIGINT and SIGTERM request a stop, and a line on stderr says so. One request may come as several
// signals: timeout(1) sends its own to the program and to its group. A signal within a second of the first counts as
// the same request. A later signal ends the program at once.
class StopBySignal {
 public:
  StopBySignal() { system::accept_stop_requests(); }
  ~StopBySignal() { system::end_stop_requests(); }
  StopBySignal(const StopBySignal&) = delete;
  StopBySignal& operator=(const StopBySignal&) = delete;

  // The number of the signal that came, or 0.
  [[nodiscard]] static int received() { return system::stop_request(); }
};

}  // namespace graze::tool
