#include "catch.h"
#include "transport/lights.h"

#include "raylab/radiosity/form_factor/closed_forms.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <array>

// The irradiance of a small patch by each light, over pi L: the form factor from the patch to the light. All truths are
// closed forms that share nothing with the samplers.

using namespace raylab;
using namespace raylab::lights;

namespace {

// Of two dozen estimates none is off by 4.5 standard errors but in one of 6000 sets of seeds.
void check_irradiance(const AreaLights& lights, const Vec3d& at, const Vec3d& normal, double truth) {
    int samples = 50'000;
    Estimate estimate = irradiance_over_pi(lights, at, normal, samples);
    while (estimate.error > truth / 500) estimate = irradiance_over_pi(lights, at, normal, samples *= 4);
    const auto [mean, error] = estimate;
    INFO(mean << " +- " << error << ", truth " << truth);
    CHECK(std::abs(mean - truth) <= 4.5 * error);
    // A density that is one hundredth too large would make this of it, and would be found.
    CHECK(std::abs(mean / 1.01 - truth) > 4.5 * error);
}

const Vec3d origin{0, 0, 0}, up{0, 0, 1};

}  // namespace

TEST_CASE("a sphere lights a patch by (R / d)^2 cos, whether it is large or tiny, near or far") {
    struct Setting {
        double radius, distance, angle;
    };
    for (const auto [radius, distance, angle] :
         {Setting{1, 4, 0}, {1, 4, 0.9}, {1, 1.25, 0}, {1e-3, 1, 0.5}, {100, 1e4, 1.2}}) {
        const Vec3d center = distance * Vec3d{std::sin(angle), 0, std::cos(angle)};
        const AreaLights lights(lit_by(Sphere{convert<float>(center), static_cast<float>(radius)}));
        const Vec3d exact = convert<double>(convert<float>(center));
        const double r = static_cast<float>(radius);
        check_irradiance(lights, origin, up, r * r * exact.z / std::pow(glm::length(exact), 3));
    }
}

TEST_CASE("a sphere that the horizon cuts lights a patch by what is above it") {
    const AreaLights lights(lit_by(Sphere{{2, 0, 0.25}, 1}));
    const double distance = std::hypot(2, 0.25);
    check_irradiance(lights, origin, up, element_to_sphere(1, distance, std::acos(0.25 / distance)));
}

TEST_CASE("inside a sphere a patch is lit from everywhere: its irradiance is pi L") {
    const AreaLights lights(lit_by(Sphere{{0.3f, 0.2f, 0.1f}, 1}));
    check_irradiance(lights, origin, up, 1);
    check_irradiance(lights, Vec3d{0.3f, 0.2f, 0.1f} + Vec3d{0, 0, -1}, up, 1);  // on its surface, looking inwards
}

TEST_CASE("a disk, a ring and an ellipse") {
    const auto disk = [](double radius, double height) {
        return radius * radius / (radius * radius + height * height);
    };
    check_irradiance(AreaLights(lit_by(Disk{{0, 0, 2}, {0, 0, -1}, 1})), origin, up, disk(1, 2));
    check_irradiance(AreaLights(lit_by(Annulus{{0, 0, 2}, {0, 0, -1}, 0.5f, 1})), origin, up,
                     disk(1, 2) - disk(0.5, 2));
    const Affine stretched{.columns = {Vec3f{2, 0, 0}, Vec3f{0, 2, 0}, Vec3f{0, 0, 1}}, .translation = {0, 0, 1}};
    check_irradiance(AreaLights(lit_by(Disk{{0, 0, 2}, {0, 0, -1}, 1}, stretched)), origin, up, disk(2, 3));
}

TEST_CASE("a rectangle, parallel and upright: Lambert's closed forms") {
    const Polygon above{{{0, 0, 2}, {0, 1, 2}, {3, 1, 2}, {3, 0, 2}}};
    check_irradiance(AreaLights(lit_by(above)), origin, up, element_to_parallel_rectangle(3, 1, 2));
    const Polygon wall{{{0, 1.5f, 0}, {2, 1.5f, 0}, {2, 1.5f, 1}, {0, 1.5f, 1}}};
    check_irradiance(AreaLights(lit_by(wall)), origin, up, element_to_perpendicular_rectangle(1, 2, 1.5));
}

TEST_CASE("a triangle, a mesh, a polygon with a reflex corner: Lambert's contour integral") {
    const std::array<Vec3d, 3> corners{Vec3d{1, 0, 1}, {-1, 1, 2}, {0, -2, 1.5}};
    const Triangle triangle{convert<float>(corners[0]), convert<float>(corners[1]), convert<float>(corners[2])};
    const double truth = std::max(contour_form_factor(origin, up, corners),
                                  contour_form_factor(origin, up, std::array{corners[0], corners[2], corners[1]}));
    check_irradiance(AreaLights(lit_by(triangle)), origin, up, truth);

    const double half = element_to_parallel_rectangle(1, 1, 2);
    const auto mesh = std::make_shared<const Mesh>(
        Mesh{.vertices = {{0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2}}, .faces = {{0, 1, 2}, {0, 2, 3}}});
    check_irradiance(AreaLights(lit_by(mesh)), origin, up, half);
    const Polygon corner{{{0, 0, 2}, {0, 1, 2}, {-1, 1, 2}, {-1, -1, 2}, {1, -1, 2}, {1, 0, 2}}};
    check_irradiance(AreaLights(lit_by(corner)), origin, up, 3 * half);
}

TEST_CASE("an ellipsoid of equal radii is a sphere, and so is a sphere that is turned, enlarged and mirrored") {
    const auto from_outside = [](const Shape& shape, const Affine& placement = {}) {
        return AreaLights(
            lit_by(shape, placement, Sides::front));  // the far side of an ellipsoid is hidden by the near one
    };
    check_irradiance(from_outside(Ellipsoid{{0, 0, 4}, {1, 1, 1}}), origin, up, 0.0625);
    const Affine turned{.columns = {Vec3f{0, 2, 0}, Vec3f{2, 0, 0}, Vec3f{0, 0, 2}}, .translation = {0, 0, 0}};
    check_irradiance(from_outside(Sphere{{0, 0, 2}, 0.5f}, turned), origin, up, 0.0625);
    // Squeezed flat it is nearly a disk.
    check_irradiance(from_outside(Ellipsoid{{0, 0, 2}, {1, 1, 1e-6f}}), origin, up, 0.2);
}

TEST_CASE("the solid angle of a light is estimated without any error where it is sampled by solid angle") {
    const std::array<Shape, 4> shapes{Sphere{{1, 2, 3}, 0.5f}, Sphere{{0, 0, 0.1f}, 1},
                                      Triangle{{1, 0, 1}, {-1, 1, 2}, {0, -2, 1.5f}},
                                      Polygon{{{1, 0, 2}, {1, 1, 2}, {3, 1, 2}, {3, 0, 2}}}};
    for (const Shape& shape : shapes) {
        const AreaLights lights(lit_by(shape));
        const double first = lights.sample(origin, 0.5, {0.1, 0.2})->pdf;
        for (std::uint64_t i = 0; i < 500; ++i) {
            RandomSequence random(61, i);
            const double u = random.next();
            CHECK_THAT(lights.sample(origin, random.next(), {u, random.next()})->pdf, WithinRel(first, 1e-14));
        }
    }
}
