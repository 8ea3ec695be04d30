#include "catch.h"

#include "raylab/geometry/oracle/cgal_ray.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/sequence.h"

#include <limits>

using namespace raylab;
using oracle::CgalKernel;
using oracle::HitKind;

namespace {

class Cases {
public:
    explicit Cases(std::uint64_t seed) : random_(seed, 0) {}

    double number(double size) { return random_.between(-size, size); }
    Vec3d point(double size) { return {number(size), number(size), number(size)}; }
    TriangleOf<double> triangle() { return {point(1), point(1), point(1)}; }
    /// A ray from a float origin towards a point of the triangle's plane, rounded to floats on the way.
    RayOf<double> aimed(const TriangleOf<double>& at, double u, double v) {
        const Vec3f origin = convert<float>(point(3));
        const Vec3d target = at.a + u * (at.b - at.a) + v * (at.c - at.a);
        const Vec3f direction = convert<float>(target - convert<double>(origin));
        return {convert<double>(origin), convert<double>(direction), {0, std::numeric_limits<double>::infinity()}};
    }

private:
    RandomSequence random_;
};

}  // namespace

TEST_CASE("oracle: agrees with CGAL's exact kernel on every ray that is not coplanar") {
    Cases cases(1);
    int different = 0, hits = 0, boundary = 0;
    for (int i = 0; i < 4000; ++i) {
        const TriangleOf<double> triangle = cases.triangle();
        RayOf<double> ray = cases.aimed(triangle, cases.number(1), i % 2 ? cases.number(1) : 0);
        if (i % 4 == 0) ray.direction = triangle.b - ray.origin;  // doubles, mostly exact: at a vertex
        const auto answer = oracle::intersect(ray, triangle);
        if (answer.hit_kind == HitKind::within) continue;
        different += answer.hit() != oracle::cgal_do_intersect(CgalKernel::epeck, ray, triangle);
        hits += answer.hit();
        boundary += answer.hit_kind == HitKind::boundary;
    }
    CHECK(different == 0);
    CHECK(hits > 500);
    CHECK(boundary > 10);
}

TEST_CASE("oracle: a ray kept as two rounded points is another ray where its direction is small") {
    Cases cases(2);
    int epick = 0, epeck = 0;
    for (int i = 0; i < 2000; ++i) {
        const TriangleOf<double> triangle = cases.triangle();
        RayOf<double> ray = cases.aimed(triangle, 0.3 + cases.number(0.5), 0.3 + cases.number(0.5));
        ray.direction *= 1e-20;
        const bool truth = oracle::intersect(ray, triangle).hit();
        epick += oracle::cgal_do_intersect(CgalKernel::epick, ray, triangle) != truth;
        epeck += oracle::cgal_do_intersect(CgalKernel::epeck, ray, triangle) != truth;
    }
    CHECK(epick > 200);
    CHECK(epeck == 0);
}
