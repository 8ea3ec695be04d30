#include "raylab/accelerator/light_buffer/light_cell.h"

#include "catch.h"
#include "raylab/experiment/adversarial/adversarial.h"

using namespace raylab;
using namespace raylab::adversarial;

TEST_CASE("each of the cube's faces is seen along its axis") {
    CHECK(light_cell({1, 0.1, -0.1}, 2) == LightCell{0, 1, 0});
    CHECK(light_cell({-1, 0.1, -0.1}, 2) == LightCell{1, 1, 0});
    CHECK(light_cell({-0.1, 1, 0.1}, 2) == LightCell{2, 1, 0});
    CHECK(light_cell({-0.1, -1, 0.1}, 2) == LightCell{3, 1, 0});
    CHECK(light_cell({0.1, -0.1, 1}, 2) == LightCell{4, 1, 0});
    CHECK(light_cell({0.1, -0.1, -1}, 2) == LightCell{5, 1, 0});
}

TEST_CASE("a direction has the same cell whatever its length") {
    Draw draw(1);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3d d = convert<double>(draw.any_direction());
        CHECK(light_cell(d, 64) == light_cell(d * 0x1p200, 64));
        CHECK(light_cell(d, 64) == light_cell(d * 0x1p-200, 64));
    }
}

TEST_CASE("a direction lies in its cell, borders included") {
    Draw draw(2);
    for (int i = 0; i < 20'000; ++i) {
        const int n = 1 << draw.integer(0, 6);
        const Vec3d d = convert<double>(draw.one_in(2) ? draw.lattice_direction(n) : draw.in_cube(1));
        const auto [face, column, row] = light_cell(d, n);
        const int axis = face / 2;
        const double depth = face % 2 == 0 ? d[axis] : -d[axis];
        const auto holds = [&](int cell, double x) {  // up to rounding
            return cell >= 0 && cell < n && x >= (2.0 * cell / n - 1 - 1e-15) * depth &&
                   x <= (2.0 * (cell + 1) / n - 1 + 1e-15) * depth;
        };
        CHECK(depth > 0);
        CHECK(holds(column, d[(axis + 1) % 3]));
        CHECK(holds(row, d[(axis + 2) % 3]));
    }
}

TEST_CASE("ties go to the first axis, and the cube's edge to the last cell") {
    CHECK(light_cell({1, 1, 1}, 4) == LightCell{0, 3, 3});
    CHECK(light_cell({-1, -1, -1}, 4) == LightCell{1, 0, 0});
    CHECK(light_cell({0, 1, -1}, 4) == LightCell{2, 0, 2});
    CHECK(light_cell({0, 0, 1}, 4) == LightCell{4, 2, 2});
    CHECK(light_cell({-0.0, -1, 0}, 4) == LightCell{3, 2, 2});
}
