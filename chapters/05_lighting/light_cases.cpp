#include "cases.h"

#include "raylab/base/number_text.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/shading/illumination.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raylab::lighting {

namespace {

constexpr Vec3d up{0, 0, 1};

Vec3d leaning(double radians) { return {std::sin(radians), 0, std::cos(radians)}; }

// cos^n of the angle between the mirror direction and the viewer, literally as in the formula, without clamping.
double unclamped(const Vec3d& to_light, const Vec3d& to_viewer, double shininess) {
    const Vec3d mirrored = 2 * dot(up, to_light) * up - to_light;
    return std::pow(dot(mirrored, to_viewer), shininess);
}

StabilityCase even_power() {
    return {"EVEN-POWER", "Light and viewer on the same side, 160 degrees off the mirror direction: a negative cosine.",
            [] {
                const double degrees = std::numbers::pi / 180;
                const Vec3d light = leaning(80 * degrees), viewer = leaning(80 * degrees);
                const double even = unclamped(light, viewer, 2), odd = unclamped(light, viewer, 3),
                             broken = unclamped(light, viewer, 2.5);
                const double kept = phong_specular(up, light, viewer, 2);
                return std::vector<CaseRow>{
                    {"cos^2, not cut at 0", "fails: a second highlight", fmt::format("{:.3g}", even), even > 0.8},
                    {"cos^3, not cut at 0", "fails: negative light", fmt::format("{:.3g}", odd), odd < -0.8},
                    {"cos^2.5, not cut at 0", "fails: not a number", std::isnan(broken) ? "not a number" : "a number",
                     std::isnan(broken)},
                    {"cut at 0", "holds: 0", fmt::format("{:.3g}", kept), kept == 0}};
            }};
}

StabilityCase highlight_cut() {
    return {"HIGHLIGHT-CUT",
            "A light that sets, its mirror direction in the viewer's eye: a millionth of a radian before and after.",
            [] {
                const double horizon = std::numbers::pi / 2, step = 1e-6;
                const auto at = [&](double angle) { return phong_specular(up, leaning(angle), leaning(-angle), 10); };
                const double jump = at(horizon - step) - at(horizon + step);
                const double diffuse = dot(up, leaning(horizon - step));
                return std::vector<CaseRow>{{"Phong's highlight", "fails: goes out at once, falls by more than 0.99",
                                             fmt::format("falls by {:.3g}", jump), jump > 0.99},
                                            {"Lambert's cosine", "holds: fades, falls by less than 1e-5",
                                             fmt::format("falls by {:.1g}", diffuse), diffuse < 1e-5}};
            }};
}

StabilityCase light_on_surface() {
    return {"LIGHT-ON-SURFACE", "A light with quadratic falloff, and a point where it stands, or a hair away.", [] {
                const Light light{.kind = PointLight{{0, 0, 0}}, .attenuation = {0, 0, 1}};
                const auto textbook = [&](double d) { return 1 / (d * d); };
                const auto lab = [&](double d) {
                    const auto seen = illumination(light, {d, 0, 0});
                    return CaseRow{fmt::format("the lab, d = {:.0g}", d), "holds: finite, or no light",
                                   seen ? fmt::format("{:.3g}", seen->color.x) : "no light",
                                   !seen || std::isfinite(seen->color.x)};
                };
                return std::vector<CaseRow>{
                    {"1 / d^2, d = 0", "fails: infinite", fmt::format("{}", textbook(0)), std::isinf(textbook(0))},
                    {"1 / d^2, d = 1e-160", "fails: infinite", fmt::format("{}", textbook(1e-160)),
                     std::isinf(textbook(1e-160))},
                    lab(0),
                    lab(1e-160),
                    lab(1e-100)};
            }};
}

// Whether a point `angle` off a spot's axis is inside its cone, by cosines in the number type T.
template <Real T>
bool inside(double angle, double cone) {
    return cast<T>(std::cos(angle)) >= cast<T>(std::cos(cone));
}

StabilityCase narrow_spot(const ChapterRun& run) {
    return {
        "NARROW-SPOT",
        "A spot of a hundredth of a degree, and points up to twice as far off its axis: near 1, cosines hardly change.",
        [run] {
            const double cone = 0.01 * std::numbers::pi / 180;
            constexpr int points = 10'000;
            int in_float = 0, in_double = 0;
            RandomSequence random(run.seed, 0);
            for (int i = 0; i < points; ++i) {
                const double angle = random.between(0, 2 * cone);
                in_float += inside<float>(angle, cone) != (angle <= cone);
                in_double += inside<double>(angle, cone) != (angle <= cone);
            }
            return std::vector<CaseRow>{
                {"cosines in float", "fails: wrong in more than 10 %",
                 "wrong in " + share_text(1.0 * in_float / points), in_float > points / 10},
                {"cosines in double", "holds: never wrong",
                 in_double == 0 ? "never wrong" : fmt::format("wrong {} times", in_double), in_double == 0}};
        }};
}

StabilityCase spot_edge() {
    return {"SPOT-EDGE", "The light of a spot just inside and just outside its cone of 30 degrees.", [] {
                const auto step = [](double exponent) {
                    const Light spot{.kind = SpotLight{
                                         .position = {0, 0, 1}, .target = {0, 0, 0}, .cone = 30, .exponent = exponent}};
                    const auto at = [&](double degrees) {
                        const double angle = degrees * std::numbers::pi / 180;
                        const auto seen = illumination(spot, Vec3d{0, 0, 1} - leaning(angle));
                        return seen ? seen->color.x : 0;
                    };
                    return at(29.9999) - at(30.0001);
                };
                const double uniform = step(0), soft = step(10), softer = step(60);
                return std::vector<CaseRow>{{"uniform", "fails: a hard edge, falls by 1",
                                             fmt::format("falls by {:.3g}", uniform), uniform > 0.999},
                                            {"cos^10", "fails: an edge still, falls by more than 0.2",
                                             fmt::format("falls by {:.3g}", soft), soft > 0.2},
                                            {"cos^60", "holds: no edge to be seen, falls by less than 0.001",
                                             fmt::format("falls by {:.1g}", softer), softer < 1e-3}};
            }};
}

}  // namespace

std::vector<StabilityCase> light_cases(const ChapterRun& run) {
    return {even_power(), highlight_cut(), light_on_surface(), spot_edge(), narrow_spot(run)};
}

std::vector<StabilityCase> cases(const ChapterRun& run) {
    std::vector<StabilityCase> all;
    for (const auto& part : {light_cases(run), mesh_cases(run), local_cases(run)})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace raylab::lighting
