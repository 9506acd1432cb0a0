// The text of engines/guarantees.json, as it was when the library was built.
#pragma once

namespace graze::engine {
extern const char* const kGuaranteesText;
}  // namespace graze::engine
