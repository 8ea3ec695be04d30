#pragma once

#include "other_interpolations.h"

// What wrong answers have in common in which another side of the triangle counts as the one that is seen.

namespace raylab::grading::mesh_hit {

inline Ingredients each_turned(const InterpolatedHit& hit) {
    Ingredients made = ingredients(hit);
    for (Vec3d& normal : made.normals)
        if (dot(normal, hit.to_viewer) < 0) normal = -normal;
    return made;
}

inline void add_sides(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& hint, const std::string& words, const Other& other) {
        add_instead(all, hint, words, other);
    };
    add("seen_from_behind", "the triangle is seen from behind, and you give 0", [](const Arguments& given) {
        return side_of(given.hit) < 0 ? InterpolatedBrightness{0, 0} : truth(given);
    });
    add("brighter_side", "of each normal and its opposite the brighter one counts", [](const Arguments& given) {
        const auto brighter = [&](const Vec3d& n) { return std::max(given.model(n), given.model(-n)); };
        const auto made = ingredients(given.hit);
        double gouraud = 0;
        for (std::size_t i = 0; i < 3; ++i) gouraud += made.weights[i] * brighter(made.normals[i]);
        return InterpolatedBrightness{gouraud, brighter(cancels(given.hit) ? made.face : glm::normalize(mixed(made)))};
    });
    // The normals by another side; the triangle's own, which stands in where they cancel, by the same or by the right
    // one.
    const auto by_side = [&](const std::string& hint, const std::string& words, const auto& side) {
        for (const bool own_is_right : {false, true})
            add(hint, words, [side, own_is_right](const Arguments& given) {
                Ingredients made = turned(given.hit, side(given) < 0 ? -1 : 1);
                if (own_is_right) made.face = side_of(given.hit) * given.hit.face;
                return shaded(given.model, made);
            });
    };
    by_side("side", "the normals end as they are given, though the triangle is seen from behind",
            [](const Arguments&) { return 1.0; });
    for (const int axis : {0, 1, 2})
        by_side("side", "which side is seen is decided by one coordinate of a normal, and not by where the viewer is",
                [axis](const Arguments& given) { return given.hit.face[axis]; });
    by_side("side_turned", "the normals are those of the side that is not seen",
            [](const Arguments& given) { return -side_of(given.hit); });
    add("side_of_each", "each normal that looks away from the viewer is turned by itself",
        [](const Arguments& given) { return shaded(given.model, each_turned(given.hit)); });
    by_side("side_of_each", "the mixed normal is turned by itself where it looks away from the viewer",
            [](const Arguments& given) {
                const auto made = ingredients(given.hit);
                return dot(mixed(made), given.hit.to_viewer) < 0 ? -side_of(given.hit) : side_of(given.hit);
            });
    for (const std::size_t vertex : {0u, 1u, 2u})
        by_side("side_of_each", "one vertex's normal says which side is seen",
                [vertex](const Arguments& given) { return dot(given.hit.normals[vertex], given.hit.to_viewer); });
    by_side("side_of_each", "the sum of the vertices' normals says which side is seen", [](const Arguments& given) {
        const auto& [a, b, c] = given.hit.normals;
        return dot(a + b + c, given.hit.to_viewer);
    });
    by_side("side_of_each", "most of the vertices' normals say which side is seen", [](const Arguments& given) {
        const auto away = std::ranges::count_if(
            given.hit.normals, [&](const Vec3d& normal) { return dot(normal, given.hit.to_viewer) < 0; });
        return away >= 2 ? -1.0 : 1.0;
    });
    all.push_back(instead("seen_from_behind",
                          "the triangle is seen from behind, and you give what it is without a light",
                          [](const Arguments& given) {
                              const double ambient = given.model.ambient;
                              return side_of(given.hit) < 0 ? InterpolatedBrightness{ambient, ambient} : truth(given);
                          }));
    add("face_for_mixed", "where the mixed normal looks away from the viewer you take the triangle's",
        [](const Arguments& given) {
            const auto made = ingredients(given.hit);
            auto found = truth(given);
            if (facing(given, mixed(made)) < 0) found.phong = given.model(made.face);
            return found;
        });
}

}  // namespace raylab::grading::mesh_hit
