#include "raylab/base/tiles.h"

#include "raylab/base/progress.h"
#include "raylab/base/thread_pool.h"

#include <algorithm>

namespace raylab {

namespace {

// Pixels a side: small enough to balance two cores at 64 x 64, large compared with one atomic operation.
constexpr int tile_size = 16;

}  // namespace

void for_each_piece(std::size_t count, std::size_t grain, int threads,
                    const std::function<void(std::size_t, std::size_t)>& work) {
    ThreadPool pool(threads, (count + grain - 1) / grain);
    pool.for_each_piece(count, grain, work);
}

void for_each_tile(int width, int height, int threads, const std::string& label,
                   const std::function<void(Tile)>& work) {
    const int across = (width + tile_size - 1) / tile_size;
    const int down = (height + tile_size - 1) / tile_size;
    const auto count = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    Progress progress(label, count);
    for_each_piece(count, 1, threads, [&](std::size_t begin, std::size_t) {
        const int x = static_cast<int>(begin) % across * tile_size;
        const int y = static_cast<int>(begin) / across * tile_size;
        work({x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)});
        progress.step();
    });
}

}  // namespace raylab
