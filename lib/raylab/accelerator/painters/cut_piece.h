#pragma once

#include "raylab/accelerator/painters/painters_tree.h"

namespace raylab {

PaintersTree::Piece whole_piece(const Triangle& triangle, std::uint32_t number);

/// The two parts into which a plane cuts a piece.
struct Halves {
    std::optional<PaintersTree::Piece> behind, inside, before;
};

/// Cuts a piece of `triangle` by a plane; `number` is the plane's. A piece that is not surely cut goes to one side
/// whole.
Halves divided(const PaintersTree::Piece& piece, const Triangle& triangle, const Triangle& plane, std::uint32_t number);

/// The sides of a plane on which a piece surely has corners.
struct Reach {
    bool behind = false, before = false;
};
Reach reach(const PaintersTree::Piece& piece, const Triangle& plane);

}  // namespace raylab
