#include "raylab/experiment/structure/structure_difference.h"

#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace raylab {

namespace {

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return !a && !b;
    return a->primitive == b->primitive && a->t == b->t && a->u == b->u && a->v == b->v && a->part == b->part;
}

/// The first primitive along a ray, by the oracle; of several at the same t the lowest.
struct Truth {
    Primitive primitive;
    oracle::ExactT t;
};

std::optional<Truth> first_hit(const Scene& scene, const Ray& ray) {
    std::optional<Truth> first;
    const auto offer = [&](const Shape& shape, const Object& object, Primitive primitive) {
        if (primitive == ray.leaving && is_flat(shape)) return;
        const Motion* motion = motion_of(scene, object);
        const auto answer =
            motion ? oracle::intersect(in<double>(ray), shape, object.placement, *motion, ray.time, object.sides)
                   : oracle::intersect(in<double>(ray), shape, object.placement, object.sides);
        if (answer.hit() && (!first || is_lt(answer.t->compare(first->t)))) first = Truth{primitive, *answer.t};
    };
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        const Mesh* mesh = as_mesh(object.shape);
        for (std::uint32_t part = 0; part < part_count(object.shape); ++part)
            offer(mesh ? Shape(mesh->triangle(part)) : object.shape, object, {number, part});
    }
    return first;
}

std::string words(const std::optional<Truth>& truth) {
    if (!truth) return "nothing";
    return fmt::format("part {} of object {} at t = {}", truth->primitive.part, truth->primitive.object,
                       truth->t.to_string());
}

bool right(const std::optional<Hit>& hit, const std::optional<Truth>& truth) {
    if (!hit || !truth) return !hit && !truth;
    if (hit->primitive != truth->primitive) return false;
    const float t = cast<float>(hit->t);
    return std::isinf(t) || truth->t.error_in_ulp(t) <= 1;
}

std::string yes_or_no(bool answer) { return answer ? "yes" : "no"; }

}  // namespace

std::string words(const std::optional<Hit>& hit) {
    if (!hit) return "nothing";
    return fmt::format("part {} of object {} at t = {:.9g} ({:a})", hit->primitive.part, hit->primitive.object, hit->t,
                       hit->t);
}

std::optional<Disagreement> StructureCaller::ask(const Ray& ray, const std::optional<Hit>& expected) {
    const auto found = structure_.closest(ray, seeing_);
    if (!same(expected, found)) return Disagreement{"closest: " + words(expected), "closest: " + words(found)};
    const bool occluded = structure_.occluded(ray, feeling_);
    if (occluded == expected.has_value()) return std::nullopt;
    return Disagreement{"occluded: " + yes_or_no(expected.has_value()), "occluded: " + yes_or_no(occluded)};
}

std::optional<TogetherDisagreement> disagreement_together(const Accelerator& structure, std::span<const Ray> rays,
                                                          std::span<const std::optional<Hit>> expected) {
    Traversal traversal;
    const auto found = structure.closest_of(rays, traversal);
    const auto occluded = structure.occluded_of(rays, traversal);
    for (const std::size_t answers : {found.size(), occluded.size()})
        if (answers != rays.size())
            return TogetherDisagreement{0,
                                        {fmt::format("{} answers", rays.size()), fmt::format("{} answers", answers)}};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto of_ray = [i](const std::string& call, const std::string& answer) {
            return fmt::format("{}, ray {}: {}", call, i, answer);
        };
        if (!same(expected[i], found[i]))
            return TogetherDisagreement{
                i, {of_ray("closest_of", words(expected[i])), of_ray("closest_of", words(found[i]))}};
        if (occluded[i] != expected[i].has_value())
            return TogetherDisagreement{i,
                                        {of_ray("occluded_of", yes_or_no(expected[i].has_value())),
                                         of_ray("occluded_of", yes_or_no(occluded[i]))}};
    }
    return std::nullopt;
}

CaseJudge judge_by_list(const StructureMethod& structure) {
    return [structure](const StructureCase& asked) -> std::optional<Disagreement> {
        const auto list = make_accelerator("list", asked.scene), other = structure.make(asked.scene);
        StructureCaller caller(*other);
        std::optional<Disagreement> last;
        std::vector<std::optional<Hit>> expected;
        for (const Ray& ray : asked.rays) {
            Traversal traversal;
            expected.push_back(list->closest(ray, traversal));
            last = caller.ask(ray, expected.back());
        }
        if (last) return last;
        const auto together = disagreement_together(*other, asked.rays, expected);
        return together ? std::optional(together->answers) : std::nullopt;
    };
}

std::optional<Disagreement> judge_by_oracle(const StructureCase& asked) {
    if (asked.rays.empty()) return std::nullopt;
    Traversal traversal;
    const auto hit = make_accelerator("list", asked.scene)->closest(asked.rays.back(), traversal);
    const auto truth = first_hit(asked.scene, asked.rays.back());
    if (right(hit, truth)) return std::nullopt;
    return Disagreement{"oracle: " + words(truth), "list: " + words(hit)};
}

}  // namespace raylab
