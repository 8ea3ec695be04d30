#include "raylab/scene/pov/light.h"

#include "raylab/scene/pov/words.h"

#include <algorithm>
#include <cmath>

namespace raylab::pov {

namespace {

// A parallel light of POV-Ray is a plane, which is put this far from the origin. POV-Ray does not see objects farther
// away than 1e7.
constexpr double far_away = 1e6;

struct Kind {
    std::string operator()(const PointLight&) const { return ""; }
    std::string operator()(const SpotLight& spot) const {
        return fmt::format(" spotlight radius {} falloff {} tightness {} point_at {}", spot.cone, spot.cone,
                           spot.exponent, vector(spot.target));
    }
    std::string operator()(const DistantLight&) const { return " parallel point_at <0, 0, 0>"; }
};

struct Position {
    Vec3d operator()(const PointLight& point) const { return point.position; }
    Vec3d operator()(const SpotLight& spot) const { return spot.position; }
    Vec3d operator()(const DistantLight& distant) const { return -far_away * glm::normalize(distant.direction); }
};

// POV-Ray's attenuation is 2 / (1 + (d / distance)^power).
struct Fade {
    double factor;  // multiplies the colour
    std::string words = {};
};

// 1 / (c + k d^power) = 1/c / (1 + (d / (c/k)^(1/power))^power). Where c is 0, one so small that it does not show is
// used.
Fade fade(double constant, double coefficient, double power) {
    constexpr double too_small_to_show = 1e-8;
    const double c = constant > 0 ? constant : too_small_to_show * coefficient;
    return {1 / (2 * c), fmt::format(" fade_distance {} fade_power {}", std::pow(c / coefficient, 1 / power), power)};
}

Fade fade(const Vec3d& attenuation, double distance) {
    const auto [constant, linear, quadratic] = std::array{attenuation.x, attenuation.y, attenuation.z};
    if (linear == 0 && quadratic == 0) return {constant > 0 ? 1 / constant : 1};
    if (linear == 0) return fade(constant, quadratic, 2);
    if (quadratic == 0) return fade(constant, linear, 1);
    return fade(constant, quadratic + linear / std::max(distance, 1e-3), 2);
}

}  // namespace

std::string light(const Light& light, const Camera& camera) {
    const Vec3d position = std::visit(Position{}, light.kind);
    const bool is_distant = std::holds_alternative<DistantLight>(light.kind);
    const Vec3d constant{1, 0, 0};
    return light_source(position, light.color, std::visit(Kind{}, light.kind),
                        is_distant ? constant : light.attenuation, glm::length(camera.target - position));
}

std::string light_source(const Vec3d& position, const Color& color, const std::string& words, const Vec3d& attenuation,
                         double distance) {
    const Fade faded = fade(attenuation, distance);
    return "light_source { " + vector(position) + ", color rgb " + vector(faded.factor * color) + words + faded.words +
           " }\n";
}

bool says_attenuation(const Vec3d& attenuation) { return attenuation.y == 0 || attenuation.z == 0; }

}  // namespace raylab::pov
