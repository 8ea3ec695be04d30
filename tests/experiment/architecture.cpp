#include "raylab/experiment/generate/architecture.h"

#include "catch.h"
#include "mesh_bits.h"
#include "raylab/experiment/generate/uneven.h"
#include "raylab/geometry/bounds/box.h"

#include <cmath>

using namespace raylab;

namespace {

// The largest area of a triangle over the median one.
double unevenness(const Mesh& mesh) {
    std::vector<double> areas;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto [a, b, c] = mesh.triangle(face);
        const Vec3d normal = cross(convert<double>(b) - convert<double>(a), convert<double>(c) - convert<double>(a));
        areas.push_back(std::sqrt(dot(normal, normal)));
    }
    std::ranges::sort(areas);
    return areas.back() / areas[areas.size() / 2];
}

}  // namespace

TEST_CASE("buildings grow with their levels: a hall by its length, a city by its area") {
    CHECK(arcade_hall(0).faces.size() > 1000);
    CHECK_THAT(double(arcade_hall(4).faces.size()), WithinRel(2.0 * double(arcade_hall(3).faces.size()), 0.02));
    CHECK_THAT(double(city(3).faces.size()), WithinRel(4.0 * double(city(2).faces.size()), 0.2));
    CHECK(stadium(3).faces.size() - stadium(2).faces.size() == 20 * (64 - 16));
}

TEST_CASE("nothing of a hall lies outside of its walls") {
    const Box box = *bounds(Shape(std::make_shared<const Mesh>(arcade_hall(3))));
    CHECK(box.min.x > -0.5f);  // the first columns stand at its end
    for (const auto& [found, wall] :
         {std::pair{box.min.y, 0.0f}, {box.min.z, 0.0f}, {box.max.x, 32.0f}, {box.max.y, 12.0f}, {box.max.z, 14.0f}})
        CHECK_THAT(found, WithinAbs(wall, 1e-5));
}

TEST_CASE("triangles of very different sizes lie side by side") {
    CHECK(unevenness(arcade_hall(4)) > 1000);
    CHECK(unevenness(city(3)) > 1000);
    CHECK(unevenness(hair(2)) < 1000);
    CHECK(unevenness(stadium(5)) > 1000);
}

TEST_CASE("generated buildings and hair are the same bits everywhere") {
    CHECK(fingerprint(arcade_hall(2)) == 0x3e9bc15c54677321);
    CHECK(fingerprint(city(1)) == 0xcd8a2c436fb1ec49);
    CHECK(fingerprint(hair(2)) == 0xb735009a43d013cb);
    CHECK(fingerprint(stadium(2)) == 0x4d9939ecd2c51c9c);
}
