// The arithmetics that a checker uses: all of them in turn, the quickest first, or only those after the
// doubles, so that the stages behind the filters are tested by themselves. The verdict is the same.
#pragma once

namespace graze::oracle {

enum class Stages { all, without_doubles };

}  // namespace graze::oracle
