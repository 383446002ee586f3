// How far a piece's core reaches from the link that carries it: what bounds on motion are made of.
#pragma once

#include "common/geometry/piece.h"

namespace accord {

// m, upper bounds.
struct PieceReach {
  double from_origin;  // of the link's frame
  double from_axis;    // z of the link's frame; planar: the same as from_origin
};

PieceReach reach_of(const Piece<2>& piece);
PieceReach reach_of(const Piece<3>& piece);

}  // namespace accord
