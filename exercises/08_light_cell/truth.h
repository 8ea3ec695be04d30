#pragma once

#include "arguments.h"

#include <cmath>

// The truth, without the formula under test: a cell is right if the direction lies within its borders. It is computed
// in long double.

namespace raylab::grading::cells {

/// A direction in a face's coordinates: w times (u, v, 1).
struct Seen {
    long double u, v, w;
};

inline Seen seen_through(const Vec3d& direction, int face) {
    const int axis = face / 2;
    const auto coordinate = [&](int i) { return static_cast<long double>(direction[i % 3]); };
    return {coordinate(axis + 1), coordinate(axis + 2), face % 2 == 0 ? coordinate(axis) : -coordinate(axis)};
}

/// Whether u w lies between the borders of a column or a row, with this much room on both sides (in widths of a cell).
inline bool is_within(long double u, long double w, double cell, int resolution, long double room) {
    const auto border = [&](long double number) { return (2 * number / resolution - 1) * w; };
    return u >= border(static_cast<long double>(cell) + room) && u <= border(static_cast<long double>(cell) + 1 - room);
}

/// Whether the cell exists, and the direction goes through it.
inline bool goes_through(const Arguments& given, double face, double column, double row, long double room = 0) {
    const auto is_number = [](double x, int count) { return x >= 0 && x < count && x == std::floor(x); };
    if (!is_number(face, 6) || !is_number(column, given.resolution) || !is_number(row, given.resolution)) return false;
    const Seen seen = seen_through(given.direction, static_cast<int>(face));
    return seen.w > 0 && std::abs(seen.u) <= seen.w && std::abs(seen.v) <= seen.w &&
           is_within(seen.u, seen.w, column, given.resolution, room) &&
           is_within(seen.v, seen.w, row, given.resolution, room);
}

/// The first face through which the direction goes; -1: none.
inline int found_face(const Vec3d& direction) {
    for (int face = 0; face < 6; ++face) {
        const Seen seen = seen_through(direction, face);
        if (seen.w > 0 && std::abs(seen.u) <= seen.w && std::abs(seen.v) <= seen.w) return face;
    }
    return -1;
}

/// The first cell through which the direction goes, found by trying all.
inline LightCell found_cell(const Arguments& given) {
    const int face = found_face(given.direction);
    if (face < 0) return {-1, -1, -1};
    const Seen seen = seen_through(given.direction, face);
    int column = 0, row = 0;
    while (column + 1 < given.resolution && !is_within(seen.u, seen.w, column, given.resolution, 0)) ++column;
    while (row + 1 < given.resolution && !is_within(seen.v, seen.w, row, given.resolution, 0)) ++row;
    return {face, column, row};
}

/// Whether any correct method must find this cell and no other.
inline bool keeps_margin(const Arguments& given) {
    const LightCell cell = found_cell(given);
    return goes_through(given, cell.face, cell.column, cell.row, 1e-6L);
}

}  // namespace raylab::grading::cells
