#pragma once

#include <functional>
#include <string>

namespace raylab {

/// A rectangle of pixels: columns [x0, x1), rows [y0, y1).
struct Tile {
    int x0, y0, x1, y1;
};

/// Calls work(tile) once for every tile of a width x height picture, from `threads` threads (0: all cores). Each begins
/// with a part of the picture and then helps with the others', so which thread computes a tile varies: its result must
/// depend on its pixels alone. The first exception that any tile throws is thrown here, after all threads have stopped.
/// `label` names the progress bar; empty: none.
void for_each_tile(int width, int height, int threads, const std::string& label, const std::function<void(Tile)>& work);

/// The same for an index range [0, count), in pieces of at most `grain`: work(begin, end).
void for_each_piece(std::size_t count, std::size_t grain, int threads,
                    const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace raylab
