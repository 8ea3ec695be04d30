#pragma once

#include "raylab/experiment/structure/structure_method.h"

#include <string>

namespace raylab::grids {

/// How the textbook's grid is built, and its possible mistakes.
struct TextbookOptions {
    // Anywhere: the first hit that is found ends the traversal.
    enum class Hits { of_this_cell, anywhere } hits = Hits::of_this_cell;
    enum class Mailboxes {
        none,
        with_hits,     // right: a hit beyond the cell is kept
        without_hits,  // a hit beyond the cell is discarded, and its primitive is not tested again
        of_8_bits,     // the ray's number wraps around after 255 rays
        of_pixels,     // all queries along one line have the same number: the range is ignored
    } mailboxes = Mailboxes::none;
};

/// The grid of the papers in floats: t is incremented from plane to plane, and primitives are listed in the cells
/// between those of their boxes' corners. Its primitive tests are exact, so all errors are the grid's. For one thread
/// only.
StructureMethod textbook_method(const std::string& name, const TextbookOptions& options);

}  // namespace raylab::grids
