#include "catch.h"

#include "raylab/geometry/oracle/cgal_ray.h"
#include "raylab/geometry/oracle/oracle.h"

#include <limits>

using namespace raylab;

TEST_CASE("CGAL's quick kernel loses a direction much shorter than its origin is far, the exact one keeps it") {
    const TriangleOf<double> triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    for (const auto& [length, quick_hits] : {std::pair{1.0, true}, {1e-20, false}}) {
        const RayOf<double> ray{{0.25, 0, 3}, {0, 0, -length}, {0, std::numeric_limits<double>::infinity()}};
        CHECK(oracle::intersect(ray, triangle).hit());
        CHECK(oracle::cgal_do_intersect(oracle::CgalKernel::epeck, ray, triangle));
        CHECK(oracle::cgal_do_intersect(oracle::CgalKernel::epick, ray, triangle) == quick_hits);
    }
}
