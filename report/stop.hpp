// A long command that is asked to stop ends in order: it keeps and shows what it has.
#pragma once

namespace graze::tool {

// While it lives, SIGINT and SIGTERM ask for a stop; the second one ends the program as ever.
class StopBySignal {
 public:
  StopBySignal();
  ~StopBySignal();
  StopBySignal(const StopBySignal&) = delete;
  StopBySignal& operator=(const StopBySignal&) = delete;

  // The number of the signal that came, or 0.
  [[nodiscard]] static int received();
};

}  // namespace graze::tool
