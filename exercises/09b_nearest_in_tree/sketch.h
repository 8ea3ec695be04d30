#pragma once

#include "flat_view.h"
#include "symptoms.h"

namespace raylab::grading::tree {

/// The boxes of the leaves along the ray, numbered in the order in which an answer asked for their things.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const auto point = [&](double t) { return given.ray.origin + t * given.ray.direction; };
    const auto [right, up] = longest_axes(given.ray.direction);
    const NodeBox root = box_of(given, 0);
    const Vec3d low = glm::min(root.low, given.ray.origin), high = glm::max(root.high, given.ray.origin);
    FlatView view(right, up, low, high,
                  "boxes of leaves: green where things have to be asked for; red: yours, in your order");
    const auto asked = asked_of(answer);
    const auto hit = truth(given);
    for (int leaf = given.leaves() - 1; leaf < given.nodes(); ++leaf) {
        const auto entry = entry_of(given, leaf);
        const bool needed = entry && (!hit || *entry <= *hit);
        const NodeBox box = box_of(given, leaf);
        view.box(box.low, box.high, {.line = needed ? case_ink::right : case_ink::faint, .width = needed ? 3.0 : 1.0});
    }
    const double end = dot((root.low + root.high) / 2.0 - given.ray.origin, given.ray.direction) /
                       dot(given.ray.direction, given.ray.direction);
    view.ray(given.ray.origin, point(end + 0.6 * glm::length(root.high - root.low) / glm::length(given.ray.direction)));
    int number = 0;
    for (const int what : asked)
        if (given.is_leaf(what - leaf_mark)) {
            const NodeBox box = box_of(given, what - leaf_mark);
            view.text({box.high.x, box.high.y, box.high.z}, case_ink::yours, fmt::format("{}.", ++number));
        }
    if (hit)
        view.dot(point(*hit), case_ink::right, "right");
    else
        view.text(root.low, case_ink::right, "right: no hit");
    if (answer[0] == 1 && std::isfinite(answer[1]))
        view.dot(point(std::clamp(answer[1], 0.0, 2 * end + 1)), case_ink::yours, "yours");
    else
        view.text(root.high, case_ink::yours, "yours: no hit");
    return view.drawn();
}

}  // namespace raylab::grading::tree
