// Bodies that lie far out in their own frames, and a position that brings them back: what a piece of a level
// is, cut out of it with the level's coordinates.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

// An offset of size/2 to size along one to three of the axes, of full doubles.
[[nodiscard]] Vec3<double> far_offset(Draw& draw, double size);
// The same set, but for the rounding of what is added: the shape that much farther out in the body's frame,
// its pivot with it, and the position back by as much. Vertices are moved; what has none is posed.
void push_out(Body<double>& body, Spin& spin, const Vec3<double>& offset);

}  // namespace graze::corpus
