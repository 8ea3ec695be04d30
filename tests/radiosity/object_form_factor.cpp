#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/object_form_factor.h"

#include <numbers>

using namespace raylab;

namespace {

Scene scene_of(const std::vector<Shape>& shapes) {
    Scene scene;
    scene.source = "test.toml";
    scene.materials = {{.name = "white"}};
    for (const Shape& shape : shapes)
        scene.objects.push_back({.shape = shape, .path = "object " + std::to_string(scene.objects.size())});
    return scene;
}

// The unit square at a height, its front upward.
Polygon square(float height) { return {{{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}}}; }

ObjectFormFactor asked(const Scene& scene, const std::string& from, const std::string& to, double edge = 0.1) {
    return object_form_factor(scene, surface_name(from), surface_name(to), edge, 1 << 16);
}

}  // namespace

TEST_CASE("form factors of flat objects in full view are right to twelve digits, on the sides that see each other") {
    const Scene scene = scene_of({square(0), square(1)});
    CHECK(asked(scene, "object 0", "object 1:back").value == Approx(0.199824895698387).epsilon(1e-12));
    CHECK(asked(scene, "object 1:back", "object 0:front").value == Approx(0.199824895698387).epsilon(1e-12));
    CHECK(asked(scene, "object 0", "object 1:back").standard_error == 0);
    CHECK(asked(scene, "object 0", "object 1:front").value == 0);
    CHECK(asked(scene, "object 0:back", "object 1:back").value == 0);
    CHECK(asked(scene, "object 0", "object 0").value == 0);
}

TEST_CASE(
    "every method answers between objects as well as it can, half hidden or not; another is refused with the list") {
    const Scene free = scene_of({square(0), square(1)}),
                half = scene_of({square(0), square(1),
                                 Polygon{{{-4, -4, 0.5f}, {0.5f, -4, 0.5f}, {0.5f, 5, 0.5f}, {-4, 5, 0.5f}}}});
    const auto by = [](const Scene& scene, const std::string& method) {
        return object_form_factor(scene, surface_name("object 0"), surface_name("object 1:back"), 0.1, 1 << 12, method);
    };
    constexpr double truth = 0.199824895698387, near = 0.4;  // the hemicube and the disk see it from one point
    for (const auto& [method, error] : {std::pair{"polygon", 1e-12},
                                        {"closed", 1e-12},
                                        {"contour", 1e-6},
                                        {"hemicube", near},
                                        {"disk", near},
                                        {"auto", 1e-12}}) {
        INFO(method);
        CHECK(by(free, method).value == Approx(truth).epsilon(error));
        CHECK(by(free, method).standard_error == 0);
        CHECK(by(half, method).value == Approx(by(free, method).value / 2).epsilon(0.02));
    }
    const auto sampled = by(free, "area");
    CHECK(sampled.standard_error > 0);
    CHECK(std::abs(sampled.value - truth) < 4 * sampled.standard_error);
    CHECK_THROWS_WITH(by(free, "areas"), Catch::Contains("(auto; area; disk; ") &&
                                             Catch::Contains("found \"areas\" (did you mean \"area\"?)"));
}

TEST_CASE("what stands between two objects is found, within four standard errors") {
    // A wall at half the height covers a half of the squares: seen from below it and what is left share the view.
    Scene scene =
        scene_of({square(0), square(1), Polygon{{{-4, -4, 0.5f}, {0.5f, -4, 0.5f}, {0.5f, 5, 0.5f}, {-4, 5, 0.5f}}}});
    const auto hidden = asked(scene, "object 0", "object 1:back");
    CHECK(hidden.standard_error > 0);
    CHECK(hidden.standard_error < 1e-3);
    // By symmetry the wall stops the ways whose middle has x < 1/2, which are half of them.
    CHECK(std::abs(hidden.value - 0.199824895698387 / 2) < 4 * hidden.standard_error + 1e-12);
    scene.objects[2].shape = Polygon{{{-4, -4, 0.5f}, {5, -4, 0.5f}, {5, 5, 0.5f}, {-4, 5, 0.5f}}};
    CHECK(asked(scene, "object 0", "object 1:back").value == 0);
}

TEST_CASE("curved objects come to their closed forms as their pieces become smaller") {
    const auto near = [](double value, double truth, double share) { return std::abs(value / truth - 1) < share; };
    const Scene disks = scene_of({Disk{{0, 0, 0}, {0, 0, 1}, 1}, Disk{{0, 0, 1}, {0, 0, -1}, 1}});
    CHECK(near(asked(disks, "object 0", "object 1", 0.1).value, 0.381966011250105, 2e-3));
    const Scene spheres = scene_of({Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 2}});
    CHECK(near(asked(spheres, "object 1:back", "object 0:front", 0.6).value, 0.25, 0.04));
    CHECK(near(asked(spheres, "object 0:front", "object 1:back", 0.6).value, 1, 0.02));
}

TEST_CASE("from a point: a ball straight above, aside, and partly below the horizon") {
    const Scene scene = scene_of({Sphere{{0, 0, 2}, 1}});
    const auto from_origin = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return point_form_factor(scene, {0, 0, 0}, {3 * std::sin(angle), 0, 3 * std::cos(angle)},
                                 surface_name("object 0"), 0.05, 1);
    };
    CHECK(from_origin(0).value == Approx(0.25).epsilon(3e-3));
    CHECK(from_origin(30).value == Approx(0.21650635094611).epsilon(3e-3));
    CHECK(from_origin(80).value == Approx(0.0546958164455).epsilon(4e-3));
    CHECK(from_origin(100).value == Approx(0.0112837720288).epsilon(1e-2));
}

TEST_CASE("an object that the scene does not have, and a side that is not shown, are refused by name") {
    Scene scene = scene_of({square(0), square(1)});
    CHECK_THROWS_WITH(asked(scene, "object 0", "objet 1"), Catch::Contains("did you mean \"object 1\""));
    scene.objects[1].sides = Sides::back;
    CHECK_THROWS_WITH(asked(scene, "object 0", "object 1:front"),
                      Catch::Contains("object 1: expected a side that is shown"));
    CHECK(asked(scene, "object 0", "object 1").value == Approx(0.199824895698387));
}
