#include "catch.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"

#include <cstdint>

using namespace raylab;

TEST_CASE("a child of bvh8 is prefetched where it lies: a node at its beginning, a leaf in its first line") {
    const std::uintptr_t nodes = 0x7f0000000000, lines = 0x100000;  // lines may lie before nodes
    const auto addresses =
        Bvh8Child::addresses(reinterpret_cast<const void*>(nodes), reinterpret_cast<const void*>(lines));
    for (const std::size_t index : {std::size_t{0}, std::size_t{1}, Bvh8Child::max_nodes - 1}) {
        const Bvh8Child node = Bvh8Child::node(index);
        CHECK(node.address(addresses) == nodes + index * sizeof(Bvh8Node));
        CHECK(node.address(addresses) == nodes + node.node_offset());
    }
    for (const std::size_t line : {std::size_t{0}, std::size_t{1}, Bvh8Child::max_lines - 1})
        for (std::size_t count = 1; count <= bvh8_width; ++count) {
            const Bvh8Child leaf = Bvh8Child::leaf(Bvh8Child::Kind::triangles, line, count);
            const std::uintptr_t first = lines + line * sizeof(Bvh8Line);
            CHECK(leaf.line_offset() == line * sizeof(Bvh8Line));
            CHECK(leaf.address(addresses) >= first);
            CHECK(leaf.address(addresses) < first + sizeof(Bvh8Line));
            CHECK(leaf.address(addresses) == lines + leaf.offset());
        }
}
