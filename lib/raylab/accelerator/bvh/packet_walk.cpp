#include "raylab/accelerator/bvh/packet_walk.h"

#include <algorithm>

namespace raylab {

PacketWalk::PacketWalk(std::span<const BoxTree::Node> nodes, const Primitives& bounded, const Primitives& unbounded,
                       std::span<const Ray> rays, Traversal& traversal)
    : nodes_(nodes),
      bounded_(bounded),
      rays_(rays),
      traversal_(traversal),
      box_rays_(rays.begin(), rays.end()),
      nearest_(rays.begin(), rays.end()),
      packet_(box_rays_) {
    List all;
    for (std::uint32_t ray = 0; ray < rays.size(); ++ray) {
        for (std::size_t i = 0; i < unbounded.size(); ++i) unbounded.test(i, rays[ray], nearest_[ray], traversal);
        set_end(ray);
        all.add({ray, rays[ray].range.min});
    }
    for (const BoxRay& ray : box_rays_) end_ = std::max(end_, ray.end());
    if (!nodes.empty()) at_node(nodes.front(), all);
}

void PacketWalk::set_end(std::uint32_t ray) {
    box_rays_[ray].set_end(std::min<double>(rays_[ray].range.max, nearest_[ray].limit()));
}

std::array<BoxPacket::RaysHitting, 2> PacketWalk::verdicts(const BoxTree::Node& node, Rays active) {
    if (active.size() < few) return {BoxPacket::RaysHitting::some, BoxPacket::RaysHitting::some};
    traversal_.box_tests += 2;
    return {packet_.rays_hitting(node.planes, 0, end_), packet_.rays_hitting(node.planes, 1, end_)};
}

void PacketWalk::at_node(const BoxTree::Node& node, Rays active) {
    using enum BoxPacket::RaysHitting;
    ++traversal_.steps;
    const auto intersect = verdicts(node, active);
    if (intersect[0] == none && intersect[1] == none) return;
    std::array<List, 2> lists;
    std::array<double, 2> first{};  // where the first ray enters each child: all rays visit the nearer one first
    const bool asks_all = intersect[0] == some || intersect[1] == some;
    for (std::size_t i = 0; i < (asks_all ? active.size() : 1); ++i) {
        const BoxRay& ray = box_rays_[active[i].ray];
        const auto entries = ray.entries(node.planes);
        traversal_.box_tests += 2;
        if (i == 0) first = entries;
        for (const std::size_t side : {0, 1})
            if (intersect[side] == some && ray.reaches(entries[side])) lists[side].add({active[i].ray, entries[side]});
    }
    const std::size_t nearer = first[1] < first[0] ? 1 : 0;
    for (const std::size_t side : {nearer, 1 - nearer})
        if (intersect[side] != none) at_child(node, side, intersect[side] == all ? active : Rays(lists[side]));
}

// Since the list of active rays was made, some of them may have found a hit in front of this child.
void PacketWalk::at_child(const BoxTree::Node& node, std::size_t side, Rays active) {
    List still;
    for (const Active& ray : active)
        if (box_rays_[ray.ray].reaches(ray.entry)) still.add(ray);
    if (still.count == 0) return;
    if (node.count[side] > 0)
        at_leaf(node.first[side], node.first[side] + node.count[side], still);
    else
        at_node(nodes_[node.first[side]], still);
}

void PacketWalk::at_leaf(std::size_t first, std::size_t end, Rays active) {
    for (const auto& [ray, entry] : active) {
        for (std::size_t i = first; i < end; ++i) bounded_.test(i, rays_[ray], nearest_[ray], traversal_);
        set_end(ray);
    }
    end_ = 0;
    for (const BoxRay& ray : box_rays_) end_ = std::max(end_, ray.end());
}

}  // namespace raylab
