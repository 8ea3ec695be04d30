#include "raylab/report/ray_tree/ray_tree_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

std::string all_digits(const Vec3d& v) { return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z); }

// A highlight's edge may be 1e-197, which is invisible; its digits would hide those that matter.
std::string channel(double x) { return x != 0 && std::abs(x) < 1e-6 ? "~0" : fmt::format("{:.3g}", x); }

// Of a folded tree: in how many samples.
std::string many(const RayNode& node) { return node.samples == 1 ? "" : fmt::format(", {} samples", node.samples); }

}  // namespace

std::string in_words(const Color& color) {
    return fmt::format("{} {} {}", channel(color.x), channel(color.y), channel(color.z));
}

std::string why_it_ended(Ending ending) {
    switch (ending) {
        case Ending::branched:
            return "";
        case Ending::diffuse:
            return "the surface neither reflects nor transmits";
        case Ending::depth:
            return "not followed: the depth limit is reached";
        case Ending::threshold:
            return "not followed: its throughput is too small";
        case Ending::roulette:
            return "not followed: Russian roulette ended the path";
        case Ending::missed:
            return "no surface is hit: the background";
        case Ending::total_internal_reflection:
            return "total internal reflection: nothing is transmitted";
        case Ending::reached:
            return "the light is visible";
        case Ending::blocked:
            return "a surface occludes the light";
    }
    return "";
}

std::string what_it_hit(const RayNode& node) {
    if (node.kind == RayKind::shadow && node.light == RayNode::none)
        return "a point of an area light: " + to_string(node.ended) + many(node);
    if (node.kind == RayKind::shadow)
        return fmt::format("light {}: {}", node.light, to_string(node.ended)) + many(node);
    if (!was_cast(node)) return why_it_ended(node.ended) + many(node);
    if (node.ended == Ending::missed) return "background" + many(node);
    if (node.samples != 1) return node.object + many(node);
    return fmt::format("{} at t = {:.4g}", node.object, node.t);
}

std::string everything_about(const RayNode& node) {
    std::string text =
        fmt::format("{} ray, depth {}, throughput {:.9g}\n", to_string(node.kind), node.depth, node.throughput);
    if (was_cast(node))
        text += fmt::format("from {} towards {}\n", all_digits(convert<double>(node.ray.origin)),
                            all_digits(convert<double>(node.ray.direction)));
    if (was_cast(node) && node.ray.time != 0) text += fmt::format("at time {:.9g} s\n", node.ray.time);
    if (node.kind == RayKind::shadow)
        text +=
            node.light == RayNode::none ? "to a point of an area light\n" : fmt::format("to light {}\n", node.light);
    if (node.density > 0) text += fmt::format("chosen with density {:.6g} per steradian\n", node.density);
    if (!node.object.empty())
        text += fmt::format("hits {} at t = {:.9g}\npoint {}\nnormal {}\n", node.object, node.t, all_digits(node.point),
                            all_digits(node.normal));
    if (was_cast(node)) text += fmt::format("local colour {}\n", all_digits(node.local));
    if (was_cast(node) && node.kind != RayKind::shadow)
        text += fmt::format("adds {} to the pixel\n", all_digits(node.contribution));
    const auto why = why_it_ended(node.ended);
    return why.empty() ? text.substr(0, text.size() - 1) : text + why;
}

std::string summary(const RayTree& tree) {
    std::size_t rays = 0, shadow_rays = 0, cut = 0;
    int depth = 0;
    for (const auto& node : tree.nodes) {
        if (node.depth == 0) continue;  // a folded tree's pixel
        if (node.kind == RayKind::shadow)
            shadow_rays += node.samples;
        else if (!was_cast(node))
            cut += node.samples;
        else
            rays += node.samples, depth = std::max(depth, node.depth);
    }
    return fmt::format("{} {}, {} deep; {} {} cut; {} shadow {}; pixel {}", rays, rays == 1 ? "ray" : "rays", depth,
                       cut, cut == 1 ? "branch" : "branches", shadow_rays, shadow_rays == 1 ? "ray" : "rays",
                       in_words(tree.pixel));
}

}  // namespace raylab
