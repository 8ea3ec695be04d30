#include "cases.h"

#include "spread_picture.h"

#include "raylab/base/number_text.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/read_scene.h"
#include "raylab/transport/light/light_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace raylab::spread {

namespace {

std::array<double, 2> random_pair(std::uint64_t sample, std::uint64_t seed = 1) {
    return {random_number({seed, 0, sample, 0}), random_number({seed, 0, sample, 1})};
}

// A square light of radiance 1, seen from the origin; its irradiance over pi is the form factor.
struct SquareLight {
    RectangleLight shape;

    double truth() const {
        const auto& [corner, first, second] = shape;
        const std::array<Vec3d, 4> polygon{corner, corner + second, corner + first + second, corner + first};
        return contour_form_factor({0, 0, 0}, {0, 0, 1}, polygon);
    }
    Vec3d normal() const { return glm::normalize(cross(shape.first, shape.second)); }
    Vec3d point(const std::array<double, 2>& numbers) const {
        return shape.corner + numbers[0] * shape.first + numbers[1] * shape.second;
    }
};

SquareLight overhead(double height, double half) {
    return {{{-half, -half, height}, {2 * half, 0, 0}, {0, 2 * half, 0}}};
}
SquareLight half_sunk() {
    return {{{1, -0.5, -0.5}, {0, 1, 0}, {0, 0, 1}}};
}  // stands on edge, half of it below the horizon

// The mean of samples, and how much one of them deviates from it.
struct Estimate {
    double mean, deviation;
};

Estimate estimate(int samples, const std::function<double(const std::array<double, 2>&)>& sample) {
    double sum = 0, squares = 0;
    for (int i = 0; i < samples; ++i) {
        const double x = sample(random_pair(static_cast<std::uint64_t>(i)));
        sum += x;
        squares += x * x;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean))};
}

double above(double cosine) { return std::max(0.0, cosine); }

// cos / pi times radiance 1 over a density: uniform in area, turned into one per steradian.
double by_area(const SquareLight& light, const std::array<double, 2>& numbers,
               const std::function<double(double)>& horizon = above) {
    const Vec3d to = light.point(numbers);
    const double squared = dot(to, to), distance = std::sqrt(squared);
    const double facing = std::abs(dot(to, light.normal())) / distance;
    return horizon(to.z / distance) / std::numbers::pi * facing * light.shape.area() / squared;
}

double by_solid_angle(const SquareLight& light, const std::array<double, 2>& numbers) {
    const auto found = light.shape.sample({0, 0, 0}, numbers);
    return above(found->point.z / glm::length(found->point)) / std::numbers::pi / found->pdf;
}

std::string found_for(double found, double truth) { return fmt::format("{:.4g} for {:.4g}", found, truth); }

// LIGHT-AREA-PDF
std::vector<CaseRow> area_rows() {
    constexpr int samples = 100'000;
    const SquareLight light = overhead(2, 0.5);
    const double truth = light.truth();
    const double forgotten = estimate(samples, [&](const auto& numbers) {
                                 const Vec3d to = light.point(numbers);
                                 return above(to.z / glm::length(to)) / std::numbers::pi * light.shape.area();
                             }).mean;
    const double turned = estimate(samples, [&](const auto& numbers) { return by_area(light, numbers); }).mean;
    return {{"1 / area taken for a density per steradian", "fails: more than 3 times as bright",
             found_for(forgotten, truth), forgotten > 3 * truth},
            {"1 / area, times distance^2 over the light's cosine", "holds: within 1 %", found_for(turned, truth),
             std::abs(turned / truth - 1) < 0.01}};
}

// HORIZON-LIGHT
std::vector<CaseRow> horizon_rows() {
    constexpr int samples = 100'000;
    const SquareLight light = half_sunk();
    const double truth = light.truth();
    const auto mean = [&](const std::function<double(double)>& horizon) {
        return estimate(samples, [&](const auto& numbers) { return by_area(light, numbers, horizon); }).mean;
    };
    const double absolute = mean([](double cosine) { return std::abs(cosine); });
    const double negative = mean([](double cosine) { return cosine; });
    const double clipped = mean(above);
    return {
        {"|cos|", "fails: twice as bright, lit from below", found_for(absolute, truth),
         std::abs(absolute / truth - 2) < 0.05},
        {"cos, which is negative below", "fails: dark", found_for(negative, truth), std::abs(negative) < 0.05 * truth},
        {"max(cos, 0)", "holds: within 1 %", found_for(clipped, truth), std::abs(clipped / truth - 1) < 0.01}};
}

// TINY-LIGHT: the light is small beside the room, and large beside its distance.
std::vector<CaseRow> tiny_rows() {
    constexpr int samples = 100'000;
    const SquareLight light = overhead(0.01, 0.5);
    const double truth = light.truth();
    const Estimate area = estimate(samples, [&](const auto& numbers) { return by_area(light, numbers); });
    const Estimate angle = estimate(samples, [&](const auto& numbers) { return by_solid_angle(light, numbers); });
    const auto words = [&](const Estimate& e) { return fmt::format("{:.2g} times its mean", e.deviation / truth); };
    return {{"uniform in area", "fails: a sample deviates by more than 10 times the mean", words(area),
             area.deviation > 10 * truth},
            {"uniform in solid angle (Urena, Fajardo and King 2013)", "holds: by less than the mean", words(angle),
             angle.deviation < truth && std::abs(angle.mean / truth - 1) < 0.01}};
}

// GLOSSY-MIS: RMS deviation of a sample, relative to the mean, on a glossy floor below a light.
double glossy_noise(double exponent, double light_radius, LightStrategy strategy) {
    const Scene scene = read_scene_text(fmt::format(R"(raylab = 1
[image]
width = 8
height = 8
[camera]
position = [0, 1, 2]
target = [0, 0, 0]
fov_y = 4
[material.floor]
diffuse = [0, 0, 0]
kr = 1
gloss = {}
[material.light]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "sphere"
center = [0, 1, -2]
radius = {}
material = "light"
)",
                                                    exponent, light_radius),
                                        "glossy.toml");
    const auto accelerator = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const TransportPicture picture(scene, *accelerator, frame, {.strategy = strategy});
    constexpr int samples = 1024;
    SampledImage image(8, 8);
    picture.add(image, {SamplerKind::random, samples, 1}, {0, samples}, Summand::sample, 1);
    return image.relative_error() * std::sqrt(samples);
}

std::vector<CaseRow> glossy_rows() {
    struct End {
        std::string words;
        double exponent, radius;
    };
    std::vector<CaseRow> rows;
    const std::array ends{End{"a large light on a smooth floor", 3000, 0.7},
                          End{"a small light on a dull floor", 10, 0.03}};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto& [words, exponent, radius] = ends[i];
        const double lights = glossy_noise(exponent, radius, LightStrategy::lights);
        const double lobes = glossy_noise(exponent, radius, LightStrategy::lobes);
        const double both = glossy_noise(exponent, radius, LightStrategy::both);
        const bool first = i == 0;
        const double weak = first ? lights : lobes, strong = first ? lobes : lights;
        const auto noise = [](double n) { return fmt::format("a sample deviates by {:.2g} times the mean", n); };
        rows.push_back({(first ? "points on the light: " : "directions of the lobe: ") + words,
                        "fails: more than 5 times as noisy as the other", noise(weak), weak > 5 * strong});
        rows.push_back({"both, weighted: " + words, "holds: at most twice as noisy as the better", noise(both),
                        both <= 2 * strong + 0.1});
    }
    return rows;
}

// FIREFLY: an area light that a diffuse floor sees in a mirror only: no point on the light is any use.
std::vector<CaseRow> firefly_rows(const ChapterRun& run) {
    const Scene scene = scene_named("firefly");
    const auto accelerator = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const TransportPicture picture(scene, *accelerator, frame, paths());
    const int pixels = scene.image.width * scene.image.height;
    const int many = run.sized(16'384, 4096);
    SampledImage image(scene.image.width, scene.image.height);
    picture.add(image, {SamplerKind::random, many, 1}, {0, many}, Summand::sample, run.threads);
    const Image converged = image.mean();
    double mean = 0;
    for (const Pixel& pixel : converged.pixels()) mean += static_cast<double>(pixel.g) / pixels;
    SampledImage few(scene.image.width, scene.image.height);
    constexpr int samples = 16;
    picture.add(few, {SamplerKind::random, samples, 2}, {0, samples}, Summand::sample, run.threads);
    const Image noisy = few.mean();
    int dark = 0;
    float brightest = 0;
    for (const Pixel& pixel : noisy.pixels()) {
        dark += pixel.g < 0.5 * mean;
        brightest = std::max(brightest, pixel.g);
    }
    const double share = static_cast<double>(dark) / pixels;
    return {{"paths, 16 a pixel", "fails: most pixels too dark by half, some 10 times too bright",
             fmt::format("{} too dark, the brightest {:.0f} times its value", share_text(share), brightest / mean),
             share > 0.5 && brightest > 10 * mean}};
}

}  // namespace

std::vector<StabilityCase> light_cases(const ChapterRun& run) {
    return {{"LIGHT-AREA-PDF", "A square light of 1 m, 2 m above: densities have units.", area_rows},
            {"HORIZON-LIGHT", "A light stands on edge, half of it below the horizon of the lit point.", horizon_rows},
            {"TINY-LIGHT", "A light of 1 m, a centimetre above the lit point.", tiny_rows},
            {"GLOSSY-MIS", "A glossy floor mirrors a light; either way to find it fails at one end.", glossy_rows},
            {"FIREFLY", "An area light that the floor sees in a mirror only, so that chance alone finds it.",
             [run] { return firefly_rows(run); }}};
}

}  // namespace raylab::spread
