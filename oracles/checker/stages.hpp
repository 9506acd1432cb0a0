// Which arithmetics a checker goes through: all of them in turn, the quickest first; or none in doubles, so
// that what is behind the filters is tried by itself. The verdict is the same.
#pragma once

namespace graze::oracle {

enum class Stages { all, without_doubles };

}  // namespace graze::oracle
