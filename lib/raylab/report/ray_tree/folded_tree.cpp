#include "raylab/report/ray_tree/folded_tree.h"

#include <cassert>
#include <map>
#include <tuple>

namespace raylab {

namespace {

// What rays of one node have in common: its parent, and what people would call them.
using Fold = std::tuple<std::size_t, RayKind, std::size_t, bool, Ending, std::string>;

Fold fold_of(const RayNode& node, std::size_t parent) {
    const bool ends_alike = node.kind != RayKind::shadow && was_cast(node) && node.ended != Ending::missed;
    return {parent, node.kind, node.light, was_cast(node), ends_alike ? Ending::branched : node.ended, node.object};
}

}  // namespace

RayTree folded_tree(std::span<const RayTree> samples) {
    assert(!samples.empty());
    RayTree all;
    all.nodes.push_back({.depth = 0, .samples = samples.size(), .object = "the pixel"});
    std::map<Fold, std::size_t> places;
    std::vector<std::size_t> seen_in{samples.size()};  // of each node, the last sample that has it
    for (std::size_t s = 0; s < samples.size(); ++s) {
        std::vector<std::size_t> place_of;  // of the sample's nodes, among those of all
        for (const RayNode& node : samples[s].nodes) {
            const std::size_t parent = node.parent == RayNode::none ? 0 : place_of[node.parent];
            const auto [found, is_new] = places.try_emplace(fold_of(node, parent), all.nodes.size());
            const std::size_t place = found->second;
            place_of.push_back(place);
            if (is_new) {
                all.nodes.push_back(node);
                all.nodes.back().parent = parent;
                all.nodes.back().density = 0;
                seen_in.push_back(s);
                continue;
            }
            RayNode& sum = all.nodes[place];
            sum.throughput += node.throughput;
            sum.contribution += node.contribution;
            sum.local += node.local;
            if (sum.ended != node.ended) sum.ended = Ending::branched;
            sum.samples += seen_in[place] != s;
            seen_in[place] = s;
        }
        all.pixel += samples[s].pixel;
    }
    const auto count = static_cast<double>(samples.size());
    for (RayNode& node : std::span(all.nodes).subspan(1)) {
        node.local /= static_cast<double>(node.samples);
        node.throughput /= count;
        node.contribution /= count;
    }
    all.pixel /= count;
    return all;
}

}  // namespace raylab
