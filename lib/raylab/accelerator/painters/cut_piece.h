#pragma once

#include "raylab/accelerator/painters/painters_tree.h"

namespace raylab {

PaintersTree::Piece whole_piece(const Triangle& triangle, std::uint32_t number);

/// What a plane makes of a piece.
struct Halves {
    std::optional<PaintersTree::Piece> behind, inside, before;
};

/// `triangle` is the piece's, `number` the plane's. A piece that is not surely cut goes to one side whole.
Halves divided(const PaintersTree::Piece& piece, const Triangle& triangle, const Triangle& plane, std::uint32_t number);

/// On which sides of a plane a piece surely has corners.
struct Reach {
    bool behind = false, before = false;
};
Reach reach(const PaintersTree::Piece& piece, const Triangle& plane);

}  // namespace raylab
