#include "catch.h"

#include "raylab/experiment/pixel_coverage.h"

#include <vector>

using namespace raylab;

namespace {

double covered(const std::vector<glm::dvec2>& polygon, int column, int row) {
    return pixel_coverage(polygon, column, row);
}

}  // namespace

TEST_CASE("a pixel inside a polygon is covered, one outside is not") {
    const std::vector<glm::dvec2> square{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    CHECK(covered(square, 3, -4) == 1);
    CHECK(covered(square, 12, 0) == 0);
    CHECK(covered(square, 10, 0) == 0);
}

TEST_CASE("a diagonal halves its pixels, whichever way round the triangle goes") {
    CHECK(covered({{0, 0}, {8, 0}, {8, 8}}, 3, 3) == 0.5);
    CHECK(covered({{8, 8}, {8, 0}, {0, 0}}, 3, 3) == 0.5);
    CHECK(covered({{0, 0}, {8, 0}, {8, 8}}, 4, 3) == 1);
}

TEST_CASE("a triangle smaller than its pixel covers its own area") {
    CHECK_THAT(covered({{5.25, 7.25}, {5.75, 7.25}, {5.25, 7.75}}, 5, 7), WithinAbs(0.125, 1e-15));
}

TEST_CASE("the pixels' shares add up to the polygon's area") {
    const std::vector<glm::dvec2> triangle{{1.3, 2.7}, {17.9, 6.1}, {4.4, 15.2}};
    double sum = 0;
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column) sum += covered(triangle, column, row);
    const double area = 0.5 * ((17.9 - 1.3) * (15.2 - 2.7) - (4.4 - 1.3) * (6.1 - 2.7));
    CHECK_THAT(sum, WithinRel(area, 1e-13));
}
