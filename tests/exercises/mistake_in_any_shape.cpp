#include "catch.h"

#include "judging.h"
#include "number_pairs.h"

#include "raylab/sampling/mapping/concentric_disk.h"
#include "raylab/sampling/mapping/cosine_direction.h"
#include "raylab/transport/light/light_point.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

// A function that draws at random makes a typical mistake in many shapes: polar or concentric, turned, reflected, u and
// v exchanged. The hint is the same.

using namespace raylab;
using namespace raylab::grading;

namespace {

constexpr double pi = std::numbers::pi;

// The verdict on a function that gives some doubles for each pair of the numbers that input `which` names.
template <class Function>
Verdict verdict_on(const std::string& name, std::size_t which, const Function& function) {
    const Exercise& asked = exercise(name);
    const auto cases = asked.cases(1);
    const auto answers = answers_of(
        asked,
        [&](std::span<const double> in, std::span<double> out) {
            std::size_t place = 0;
            for (const auto& [u, v] : number_pairs(in[which]))
                for (const double value : function(in, u, v)) out[place++] = value;
        },
        cases);
    return judge(asked, cases, answers);
}

using Hint = std::optional<std::string>;

Hint lens_hint(const std::function<DiskPoint(double radius, double u, double v)>& lens) {
    return verdict_on("15", 1,
                      [&](auto in, double u, double v) {
                          const auto [x, y] = lens(in[0], u, v);
                          return std::array{x, y};
                      })
        .hint;
}

Verdict lobe_verdict(const std::function<SampledDirection(double u, double v)>& lobe) {
    return verdict_on("15b", 0, [&](auto, double u, double v) {
        const auto [d, pdf] = lobe(u, v);
        return std::array{d.x, d.y, d.z, pdf};
    });
}

Verdict light_verdict(
    const std::function<LightPoint(const Vec3d& center, double radius, const Vec3d& from, double u, double v)>& light) {
    return verdict_on("15c", 7, [&](auto in, double u, double v) {
        const auto [p, pdf] = light({in[0], in[1], in[2]}, in[3], {in[4], in[5], in[6]}, u, v);
        return std::array{p.x, p.y, p.z, pdf};
    });
}

}  // namespace

TEST_CASE("a mistake has its hint in any shape, by how its points are spread", "[long]") {
    CHECK(lens_hint([](double radius, double u, double v) {
              const double r = radius * v, angle = -2 * pi * u + 1;
              return DiskPoint{r * std::sin(angle), r * std::cos(angle)};
          }) == "sqrt_forgotten");
    CHECK(lens_hint([](double radius, double u, double v) {
              const auto [x, y] = concentric_disk(u, v);
              return DiskPoint{radius * x * std::hypot(x, y), radius * y * std::hypot(x, y)};
          }) == "sqrt_forgotten");
    CHECK(lens_hint([](double radius, double u, double v) {
              const auto [x, y] = concentric_disk(v, u);
              return DiskPoint{2 * radius * x, 2 * radius * y};
          }) == "diameter");
    CHECK(lens_hint([](double radius, double, double v) {
              const double r = radius * std::sqrt(v), angle = 2 * pi * v;
              return DiskPoint{r * std::cos(angle), -r * std::sin(angle)};
          }) == "same_number_twice");
    CHECK(lens_hint([](double radius, double u, double v) {
              const double r = radius * std::sqrt(v), angle = pi * (u - 0.5);
              return DiskPoint{r * std::cos(angle), r * std::sin(angle)};
          }) == "part_of_a_turn");
    CHECK(lens_hint([](double radius, double u, double v) {
              const double r = radius * std::pow(u, 0.4), angle = 2 * pi * v;
              return DiskPoint{r * std::cos(angle), r * std::sin(angle)};
          }) == "crowd_at_the_rim");
}

TEST_CASE("a small bias is no mistake that is known, though its points are spread nearly as a known one's", "[long]") {
    const auto power = [](double exponent) {
        return [exponent](double radius, double u, double v) {
            const double r = radius * std::pow(u, exponent), angle = 2 * pi * v;
            return DiskPoint{r * std::cos(angle), r * std::sin(angle)};
        };
    };
    CHECK_FALSE(lens_hint(power(0.505)));
    CHECK_FALSE(lens_hint(power(0.52)));
    CHECK(lens_hint([](double radius, double u, double v) {
              const double r = radius * std::sqrt(1 - u), angle = -360 * v;
              return DiskPoint{r * std::sin(angle), r * std::cos(angle)};
          }) == "degrees");
}

TEST_CASE("a mistake about directions or their densities has its hint in any shape", "[long]") {
    CHECK(lobe_verdict([](double u, double v) {  // by the angle, and the other way round
              const double below = std::acos(v), angle = -2 * pi * u;
              const Vec3d d{std::sin(below) * std::sin(angle), std::sin(below) * std::cos(angle), std::cos(below)};
              return SampledDirection{d, 1 / (2 * pi)};
          })
              .hint == "uniform_and_says_so");
    CHECK(lobe_verdict([](double u, double v) {
              return SampledDirection{cosine_direction(v, 1 - u).direction, 1 / pi};
          }).hint == "pdf_without_cosine");
    CHECK(lobe_verdict([](double u, double v) {
              const Vec3d d = cosine_direction(v, u).direction;
              return SampledDirection{{d.y, d.z, d.x}, d.z / pi};
          }).hint == "y_is_up");
    CHECK(light_verdict([](const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
              const Vec3d near = light_point(center, radius, from, v, u).point, way = glm::normalize(near - from);
              const double pdf = light_point(center, radius, from, v, u).pdf;
              return LightPoint{near + 2 * dot(center - near, way) * way, pdf};
          }).hint == "far_side");
    CHECK(light_verdict([](const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
              const auto [point, pdf] = light_point(center, radius, from, 1 - v, u);
              return LightPoint{point, 1 / pdf};
          }).hint == "solid_angle_for_pdf");
    CHECK(light_verdict([](const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
              const auto [point, pdf] = light_point(center, radius, from, v, u);
              return LightPoint{point - from, pdf};
          }).hint == "from_forgotten");
}

TEST_CASE("a density that is wrong by 1 % is found at every single point", "[long]") {
    const auto lobe = lobe_verdict([](double u, double v) {
        const auto [d, pdf] = cosine_direction(u, v);
        return SampledDirection{d, 1.01 * pdf};
    });
    CHECK(lobe.right == 0);
    const auto light = light_verdict([](const Vec3d& center, double radius, const Vec3d& from, double u, double v) {
        const auto [point, pdf] = light_point(center, radius, from, u, v);
        return LightPoint{point, 1.01 * pdf};
    });
    CHECK(light.right == 0);
}
