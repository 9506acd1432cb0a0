// Bodies that lie far out in their own frames, and a position that brings them back: what a piece of a level
// is, cut out of it with the level's coordinates.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

// An offset of size/2 to size along one to three of the axes, of full doubles.
[[nodiscard]] Vec3<double> far_offset(Draw& draw, double size);
// The same set, up to the rounding of the added offset. The shape and its pivot move that much farther out in
// the body's frame, and the position moves back by as much. Vertices are moved. A shape without vertices is
// posed.
void push_out(Body<double>& body, Spin& spin, const Vec3<double>& offset);

}  // namespace graze::corpus
