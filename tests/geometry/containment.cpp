#include "catch.h"

#include "raylab/geometry/containment.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

// Twice as far along x, moved, mirrored: the determinant is negative.
const Affine placed{{Vec3f{-2, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0.5f, 0, 1}}, {3, -1, 2}};

Containment at(const Vec3d& local, const Shape& shape, const Affine& placement) {
    return containment(region_about(transform_point(placement, local)), shape, placement);
}

const std::vector<Shape> closed_shapes{
    Sphere{{0, 0, 0}, 1},
    Ellipsoid{{0, 0, 0}, {1, 1, 1}},
    Cylinder{{0, -1, 0}, {0, 1, 0}, 1, Ends::capped},
    Cone{{0, -1, 0}, {0, 1, 0}, 1.5f, 0.5f, Ends::capped},
    Paraboloid{{0, -1, 0}, {0, 1, 0}, 1, Ends::capped},
    Hyperboloid{{0, -1, 0}, {0, 1, 0}, 0.5f, 1, Ends::capped},
};

// The same shapes by their textbook equations, y upward.
bool textbook_inside(std::size_t shape, const Vec3d& p) {
    const double rho = std::hypot(p.x, p.z), s = (p.y + 1) / 2;
    const bool between = s > 0 && s < 1;
    switch (shape) {
        case 2:
            return between && rho < 1;
        case 3:
            return between && rho < 1.5 - s;
        case 4:
            return between && rho * rho < s;
        case 5:
            return between && rho * rho < 0.25 + 0.75 * (2 * s - 1) * (2 * s - 1);
        default:
            return rho * rho + p.y * p.y < 1;
    }
}

}  // namespace

TEST_CASE("a point lies inside a closed shape where the textbook says so, placed or not") {
    int inside = 0, outside = 0;
    for (std::size_t shape = 0; shape < closed_shapes.size(); ++shape)
        for (int i = 0; i < 17; ++i)
            for (int j = 0; j < 17; ++j)
                for (int k = 0; k < 17; ++k) {
                    const Vec3d p{-1.61 + 0.2 * i, -1.62 + 0.2 * j, -1.63 + 0.2 * k};  // on no surface
                    const auto expected = textbook_inside(shape, p) ? Containment::inside : Containment::outside;
                    (expected == Containment::inside ? inside : outside) += 1;
                    INFO("shape " << shape << " at " << p.x << " " << p.y << " " << p.z);
                    REQUIRE(at(p, closed_shapes[shape], {}) == expected);
                    REQUIRE(at(p, closed_shapes[shape], placed) == expected);
                }
    CHECK(inside > 1000);
    CHECK(outside > 1000);
}

TEST_CASE("a point on the surface is undecided, and so is a region across it") {
    const Sphere sphere{{0, 0, 0}, 1};
    CHECK(containment(region_about({0.6, 0.8, 0}), sphere, {}) == Containment::undecided);  // rounded to the doubles
    CHECK(containment(region_about({1, 0, 0}), sphere, {}) == Containment::undecided);
    CHECK(containment(region_about({0.5, 0, 0}, {0.6, 0, 0}), sphere, {}) == Containment::undecided);
    CHECK(containment(region_about({0.5, 0, 0}, {-0.4, 0, 0}), sphere, {}) == Containment::inside);
    CHECK(containment(region_about({2, 0, 0}, {0.4, 0, 0}), sphere, {}) == Containment::outside);
}

TEST_CASE("a point in the plane of a cap is not inside") {
    for (std::size_t shape = 2; shape < closed_shapes.size(); ++shape)
        for (const double y : {-1.0, 1.0})
            CHECK(containment(region_about({0, y, 0}), closed_shapes[shape], {}) != Containment::inside);
}

TEST_CASE("coordinates beyond all bounds prove nothing") {
    const double huge = std::numeric_limits<double>::max();
    CHECK(containment(region_about({huge, huge, 0}), Sphere{{0, 0, 0}, 1}, {}) != Containment::inside);
    CHECK(containment(region_about({std::nan(""), 0, 0}), Sphere{{0, 0, 0}, 1}, {}) == Containment::undecided);
}

TEST_CASE("what is open or flat has everything outside") {
    const std::vector<Shape> open{Cylinder{{0, -1, 0}, {0, 1, 0}, 1},  Cone{{0, -1, 0}, {0, 1, 0}, 1, 0},
                                  Plane{{0, 0, 0}, {0, 1, 0}},         Disk{{0, 0, 0}, {0, 1, 0}, 1},
                                  Annulus{{0, 0, 0}, {0, 1, 0}, 1, 2}, Triangle{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}};
    for (const auto& shape : open) {
        CHECK_FALSE(is_closed(shape));
        CHECK_FALSE(is_convex(shape));
        CHECK(at({0, 0.1, 0}, shape, {}) == Containment::outside);
    }
    CHECK(is_planar(open[2]));
    CHECK(is_planar(open[4]));
    CHECK_FALSE(is_planar(open[0]));
}

TEST_CASE("a capped hyperboloid is closed but not convex") {
    for (const auto& shape : closed_shapes) CHECK(is_closed(shape));
    CHECK(is_convex(closed_shapes[3]));
    CHECK_FALSE(is_convex(closed_shapes[5]));
}

TEST_CASE("nobody knows the inside of a mesh, but all is outside beyond its box") {
    const auto mesh = std::make_shared<const Mesh>(
        Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    CHECK(containment(region_about({0.1, 0.1, 0.1}), mesh, {}) == Containment::undecided);
    CHECK(containment(region_about({0.1, 0.1, 1.1}), mesh, {}) == Containment::outside);
    const auto tall = std::make_shared<const Mesh>(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, 0, 9}}, mesh->faces});
    for (const auto& [side, length] : {std::pair{0, 1.0}, {1, 3.0}, {2, 9.0}}) {
        Vec3d within{0.5, 0.5, 0.5}, beyond = within, before = within;
        within[side] = 0.9 * length, beyond[side] = 1.1 * length, before[side] = -0.1;
        Vec3d smallest = within, largest = within;
        smallest[side] = 0, largest[side] = length;
        for (const Vec3d& on_the_box : {smallest, largest})
            CHECK(containment(region_about(on_the_box), tall, {}) == Containment::undecided);
        CHECK(containment(region_about(within), tall, {}) == Containment::undecided);
        CHECK(containment(region_about(beyond), tall, {}) == Containment::outside);
        CHECK(containment(region_about(before), tall, {}) == Containment::outside);
    }
    CHECK_FALSE(is_planar(mesh));
    CHECK_FALSE(is_closed(mesh));
}
