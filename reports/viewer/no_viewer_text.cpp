// Replaces the viewer in a program that is built without Node.
#include "reports/viewer/viewer_text.hpp"

namespace graze::show {
const char* const kViewerText = "";
}  // namespace graze::show
