#pragma once

#include "raylab/report/structure/structure_method.h"

#include <string>

namespace raylab::grids {

/// How the textbook's grid is made, and what can be wrong with it.
struct TextbookOptions {
    enum class Hits { of_this_cell, anywhere } hits = Hits::of_this_cell;  // anywhere: the first one found ends the walk
    enum class Mailboxes {
        none,
        with_hits,      // right: what was found beyond the cell is kept
        without_hits,   // thrown away, and not asked again
        of_8_bits,      // the ray's number comes round after 255 rays
        of_pixels,      // the same number for all that is asked along one line: the range is forgotten
    } mailboxes = Mailboxes::none;
};

/// The grid of the papers in floats: t added to from plane to plane, primitives in the cells between the two that their
/// boxes' corners are in. Its own primitive tests are exact, so what is wrong is the grid's doing. For one thread.
StructureMethod textbook_method(const std::string& name, const TextbookOptions& options);

}  // namespace raylab::grids
