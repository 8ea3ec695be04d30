#pragma once

#include "raylab/accelerator/bvh/box_packet.h"
#include "raylab/accelerator/primitives.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

/// Traverses a tree of boxes with a packet of rays. A node that none of them hits costs one test instead of one for
/// each ray, and so does a node that all of them hit; only otherwise is each ray tested. (Wald et al., Interactive
/// Rendering with Coherent Ray Tracing, CGF 20(3), 2001; the lists of active rays are those of Overbeck et al., Large
/// Ray Packets for Real-time Whitted Ray Tracing, RT 2008.) Nearest decides which hit is nearest, whatever the order of
/// visits, so the answers are those of single rays.
class PacketWalk {
public:
    PacketWalk(std::span<const BoxTree::Node> nodes, const Primitives& bounded, const Primitives& unbounded,
               std::span<const Ray> rays, Traversal& traversal);

    std::optional<Hit> hit(std::size_t ray) const { return nearest_[ray].hit(); }

    /// The largest packet: the rays of an 8 x 8 tile of a picture.
    static constexpr std::size_t largest = 64;

private:
    struct Active {
        std::uint32_t ray;
        double entry;  // a lower bound of its t inside the node's box
    };
    using Rays = std::span<const Active>;

    struct List {
        std::array<Active, largest> rays;
        std::size_t count = 0;

        void add(const Active& ray) { rays[count++] = ray; }
        operator Rays() const { return {rays.data(), count}; }
    };

    void at_node(const BoxTree::Node& node, Rays active);
    void at_child(const BoxTree::Node& node, std::size_t side, Rays active);
    void at_leaf(std::size_t first, std::size_t end, Rays active);
    std::array<BoxPacket::RaysHitting, 2> verdicts(const BoxTree::Node& node, Rays active);
    void set_end(std::uint32_t ray);

    // A packet with so few active rays is not tested as a whole; its rays are tested one by one.
    static constexpr std::size_t few = 4;

    std::span<const BoxTree::Node> nodes_;
    const Primitives& bounded_;
    std::span<const Ray> rays_;
    Traversal& traversal_;
    std::vector<BoxRay> box_rays_;
    std::vector<Nearest> nearest_;
    BoxPacket packet_;
    double end_ = 0;  // none of the rays' nearest hits lies beyond it
};

/// The nearest hits of rays, packet by packet of consecutive rays; `alone(ray)` answers for rays that do not form a
/// packet.
template <class Alone>
std::vector<std::optional<Hit>> hits_by_packets(std::span<const BoxTree::Node> nodes, const Primitives& bounded,
                                                const Primitives& unbounded, std::span<const Ray> rays,
                                                Traversal& traversal, const Alone& alone) {
    std::vector<std::optional<Hit>> hits;
    hits.reserve(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += PacketWalk::largest) {
        const auto packet = rays.subspan(first, std::min(PacketWalk::largest, rays.size() - first));
        if (!BoxPacket::fits(packet)) {
            for (const Ray& ray : packet) hits.push_back(alone(ray));
            continue;
        }
        const PacketWalk walk(nodes, bounded, unbounded, packet, traversal);
        for (std::size_t i = 0; i < packet.size(); ++i) hits.push_back(walk.hit(i));
    }
    return hits;
}

}  // namespace raylab
