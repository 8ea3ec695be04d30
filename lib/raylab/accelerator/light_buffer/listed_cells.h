#pragma once

#include "raylab/geometry/vector.h"

#include <optional>
#include <span>

namespace raylab {

/// Cells of a face of a light buffer's cube: those of these columns and rows, the first and the last ones included.
struct CellRectangle {
    int first_column, last_column, first_row, last_row;

    friend bool operator==(const CellRectangle&, const CellRectangle&) = default;
};

/// The smallest rectangle of the face's cells that holds every cell through which a light sees something of a flat
/// convex polygon; absent where it sees nothing through this face. `corners`: three or more, in their order around it,
/// as seen from the light, which is at 0 and not on the polygon. Faces, columns and rows are those of light_cell().
/// Polygon and cells are closed: a polygon that ends in the border between two cells is seen through both. This is the
/// slot of exercise 08c. (Haines and Greenberg, The Light Buffer, IEEE CG&A 6(9), 1986; the corners are cut off as in
/// Sutherland and Hodgman, Reentrant Polygon Clipping, CACM 17(1), 1974.)
std::optional<CellRectangle> listed_cells(std::span<const Vec3d> corners, int face, int resolution);

}  // namespace raylab
