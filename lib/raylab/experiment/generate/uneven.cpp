#include "raylab/experiment/generate/uneven.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/mason.h"
#include "raylab/sampling/sequence.h"

#include <cassert>

namespace raylab {

Mesh hair(int levels) {
    assert(levels >= 0 && levels <= 16);
    Mason mason;
    mason.add_mesh(icosphere(4), {0, 0, 0}, 1);
    const int hairs = 64 << levels;
    for (int i = 0; i < hairs; ++i) {
        RandomSequence random(1, static_cast<std::uint64_t>(i));
        Vec3d at = random.unit_vector(), along = at + 0.5 * random.in_cube();
        const int pieces = i % 2 == 0 ? 8 : random.whole(1, 2);
        const double piece = random.between(0.8, 1.6) / pieces;
        const Vec3d across = 0.001 * random.unit_vector_across(along);
        for (int k = 0; k < pieces; ++k) {
            const Vec3d step = piece * glm::normalize(along);
            if (pieces == 1)
                mason.triangle(at - across, at + across, at + step);
            else
                mason.quad(at - 0.5 * across, across, step);
            at += step;
            along += 0.4 * random.in_cube() + Vec3d{0, -0.5, 0};
        }
    }
    return mason.taken();
}

Mesh stadium(int levels) {
    assert(levels >= 0 && levels <= 9);
    constexpr double field = 60, step = 1;
    constexpr int rows = 60;
    const auto round = circle(7);
    Mason mason;
    mason.add_mesh(bumpy_sphere(levels), {0, 0.3, 0}, 0.25);
    mason.quad({-field, 0, -field}, {2 * field, 0, 0}, {0, 0, 2 * field});
    for (int row = 0; row < rows; ++row)
        for (std::size_t i = 0; i < round.size(); ++i) {
            const Angle a = round[i], b = round[(i + 1) % round.size()];
            const double inner = field + step * row, outer = inner + step, height = 0.5 * row;
            const auto point = [&](const Angle& angle, double radius, double y) {
                return Vec3d{radius * angle.cosine, y, radius * angle.sine};
            };
            const Vec3d from = point(a, inner, height + 0.5), to = point(b, inner, height + 0.5);
            mason.quad(from, to - from, {0, -0.5, 0});  // the riser, and the tread
            mason.triangle(from, to, point(b, outer, height + 0.5));
            mason.triangle(from, point(b, outer, height + 0.5), point(a, outer, height + 0.5));
        }
    for (const Angle& at : circle(5))  // masts that lean over the steps
        mason.triangle({125 * at.cosine, 0, 125 * at.sine}, {125 * at.cosine, 1, 125 * at.sine},
                       {70 * at.cosine, 60, 70 * at.sine});
    return mason.taken();
}

}  // namespace raylab
