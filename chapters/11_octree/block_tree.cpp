#include "block_tree.h"

#include <algorithm>
#include <cmath>

namespace raylab::octrees {

namespace {

bool holds(const BlockTree& cell, PlanePoint point) {
    return point.x >= cell.x && point.x < cell.x + cell.side && point.y >= cell.y && point.y < cell.y + cell.side;
}

void grow(BlockTree& cell, const std::vector<PlanePoint>& things, const std::vector<int>& bits, std::size_t depth) {
    const bool empty = std::ranges::none_of(things, [&](PlanePoint thing) { return holds(cell, thing); });
    if (empty || depth == bits.size()) return;
    cell.bits = bits[depth];
    const int count = 1 << cell.bits, side = cell.side / count;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            cell.cells.push_back({cell.x + i * side, cell.y + j * side, side});
            grow(cell.cells.back(), things, bits, depth + 1);
        }
}

// From the root down to the leaf that holds a whole-numbered place.
std::vector<const BlockTree*> path_to(const BlockTree& root, int x, int y) {
    std::vector<const BlockTree*> path{&root};
    while (!path.back()->cells.empty()) {
        const BlockTree& cell = *path.back();
        const int side = cell.side >> cell.bits;
        const int place = (x - cell.x) / side + ((y - cell.y) / side << cell.bits);
        path.push_back(&cell.cells[static_cast<std::size_t>(place)]);
    }
    return path;
}

}  // namespace

BlockTree block_tree(int side, const std::vector<PlanePoint>& things, const std::vector<int>& bits) {
    BlockTree root{0, 0, side};
    grow(root, things, bits, 0);
    return root;
}

std::vector<LeafOnWay> way_through(const BlockTree& tree, PlanePoint from, PlanePoint direction) {
    std::vector<LeafOnWay> way;
    int x = static_cast<int>(from.x), y = static_cast<int>(from.y);
    PlanePoint in = from;
    while (x < tree.side && y < tree.side) {
        LeafOnWay next{.path = path_to(tree, x, y), .in = in, .out = {}};
        const BlockTree& leaf = next.leaf();
        const double to_x = (leaf.x + leaf.side - from.x) / direction.x;
        const double to_y = (leaf.y + leaf.side - from.y) / direction.y;
        const double t = std::min(to_x, to_y);
        next.across = to_x <= to_y ? 0 : 1;
        next.out = in = {from.x + t * direction.x, from.y + t * direction.y};
        x = to_x <= t ? leaf.x + leaf.side : std::clamp(static_cast<int>(in.x), leaf.x, leaf.x + leaf.side - 1);
        y = to_y <= t ? leaf.y + leaf.side : std::clamp(static_cast<int>(in.y), leaf.y, leaf.y + leaf.side - 1);
        way.push_back(next);
    }
    return way;
}

std::size_t shared(const LeafOnWay& a, const LeafOnWay& b) {
    std::size_t count = 0;
    while (count < std::min(a.path.size(), b.path.size()) && a.path[count] == b.path[count]) ++count;
    return count;
}

}  // namespace raylab::octrees
