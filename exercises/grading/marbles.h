#pragma once

#include "dice.h"
#include "work_task.h"

#include "raylab/scene/scene.h"

// The scenes in which work is counted: small spheres in a cube. They are generated, so that a student's process need
// not open a file.

namespace raylab::grading {

/// This many marbles in the cube from the origin to (side, side, side), each with a diameter of a fiftieth to a
/// sixteenth of its side.
inline Scene marbles(int count, double side) {
    Dice dice(1);
    Scene scene{.source = "marbles", .materials = {{.name = "glass"}}};
    for (int i = 0; i < count; ++i) {
        const Vec3d center = dice.point(0.05, 0.95) * side;
        const auto radius = cast<float>(dice.in(0.01, 0.03) * side);
        scene.objects.push_back({.shape = Sphere{convert<float>(center), radius}, .placement = {}});
    }
    return scene;
}

/// Traces rays through a structure of marbles, whose trace(ray, answer) calls the function under test to find where to
/// go on. Each call is a unit of work.
template <class Structure>
WorkTask through_marbles(const std::string& name, const std::string& unit, const std::vector<Ray>& rays) {
    return {name, unit, [rays](const Answer& answer) {
                const Structure structure;
                Worked worked;
                const auto counted = [&](std::span<const double> input, std::span<double> output) {
                    ++worked.work;
                    answer(input, output);
                };
                for (const Ray& ray : rays) worked.hits.push_back(structure.trace(ray, counted));
                return worked;
            }};
}

}  // namespace raylab::grading
