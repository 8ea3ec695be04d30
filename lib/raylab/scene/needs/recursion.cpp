#include "raylab/scene/background.h"
#include "raylab/scene/needs/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab {

namespace {

// The smallest depth d with k^d at most the threshold: a ray at depth d + 1 has been multiplied by k d times, so that
// none there is worth following. (The product is formed step by step, as a renderer does it: rounding is monotonic, so
// no product of smaller coefficients comes out larger.)
Recursion counted(double coefficient, const NeedsQuestion& question) {
    const auto& [threshold, depth_limit, split] = question.options;
    Recursion found{{.coefficient = coefficient}, 1};
    double share = coefficient;
    for (; question.worth_a_ray(share) && found.depth < depth_limit; share *= coefficient) ++found.depth;
    found.passed_on.stopped_by_limit = question.worth_a_ray(share);
    const bool ever = found.passed_on.stopped_by_limit && coefficient < 1 && threshold > 0;
    const double end = ever ? std::ceil(std::log(threshold) / std::log(coefficient)) : 0;
    found.passed_on.why = fmt::format(
        "k = {:.4g} is the most that a surface passes on; k^{} is {}", coefficient, found.depth,
        found.passed_on.stopped_by_limit ? fmt::format("more than {:.3g}, so the limit of depth ends it{}", threshold,
                                                       ever ? fmt::format(" (k^{} would not be)", end) : "")
                                         : fmt::format("the first that is at most {:.3g}", threshold));
    return found;
}

bool passes_on(const NeedsQuestion& question, std::size_t object) {
    const auto worth = [&](std::size_t side) {
        const auto largest = passed_on(question, question.scene.materials[side]);
        return question.worth_a_ray(largest.reflected) || question.worth_a_ray(largest.transmitted);
    };
    const Object& o = question.scene.objects[object];
    const ObjectFacts& facts = question.objects[object];
    return (facts.front_seen && worth(o.front)) || (facts.back_seen && worth(o.back));
}

struct End {
    int depth;
    std::string why;
};

// Whether the shape of the scene ends the recursion: a single object reflects or transmits light, and never to itself.
std::optional<End> early_end(const NeedsQuestion& question) {
    const Scene& scene = question.scene;
    std::optional<std::size_t> only;
    for (std::size_t i = 0; i < question.objects.size(); ++i) {
        if (!passes_on(question, i)) continue;
        if (only || !question.objects[i].clear) return std::nullopt;
        only = i;
    }
    if (!only) return std::nullopt;
    if (!question.shows_only_background())
        return End{2, "only " + name_of(scene, *only) + " passes light on, and no ray that leaves it hits it again"};
    if (sends_light(scene.background))
        return End{2, name_of(scene, 0) + " is alone: a ray that leaves it hits nothing but the background"};
    return End{1, name_of(scene, 0) + " is alone: a ray that leaves it hits nothing but the black background"};
}

}  // namespace

bool bends_light(const Scene& scene, const std::vector<ObjectFacts>& facts) {
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const Object& object = scene.objects[i];
        const bool transmits = (facts[i].front_seen && scene.materials[object.front].kt > 0) ||
                               (facts[i].back_seen && scene.materials[object.back].kt > 0);
        if (transmits && scene.materials[object.front].ior != 1) return true;
    }
    return false;
}

LargestShares passed_on(const NeedsQuestion& question, const Material& material) {
    const double kr = material.kr, kt = material.kt;
    if (kt == 0) return {kr, 0};
    const bool by_angle = question.options.split == NeedsOptions::Split::by_angle;
    // At total internal reflection the mirrored ray also carries kt.
    return {by_angle || question.bends_light ? kr + kt : kr, by_angle ? kr + kt : kt};
}

Recursion recursion_needs(const NeedsQuestion& question, const std::vector<bool>& seen) {
    const Scene& scene = question.scene;
    double coefficient = 0;
    bool reflection = false, transmission = false;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) continue;
        const auto largest = passed_on(question, scene.materials[i]);
        coefficient = std::max({coefficient, largest.reflected, largest.transmitted});
        reflection = reflection || question.worth_a_ray(largest.reflected);
        transmission = transmission || question.worth_a_ray(largest.transmitted);
    }
    if (!reflection && !transmission) {
        const auto why = coefficient > 0 ? fmt::format("kr and kt of all that is seen are at most {:.3g}",
                                                       question.options.threshold)
                                         : "nothing that is seen is a mirror or a glass";
        return {{.coefficient = coefficient, .why = why}, 1};
    }
    Recursion found = counted(coefficient, question);
    if (const auto end = early_end(question); end && end->depth <= found.depth) {
        found.depth = end->depth;
        found.passed_on.stopped_by_limit = false;
        found.passed_on.why = end->why;
    }
    found.passed_on.reflection = reflection && found.depth > 1;
    found.passed_on.transmission = transmission && found.depth > 1;
    return found;
}

}  // namespace raylab
