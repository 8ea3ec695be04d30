#include "measured_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::cornell {

namespace {

// From 400 to 700 nanometres in steps of 4, as Cornell's Program of Computer Graphics measured and published them.
constexpr int first_nanometre = 400, nanometre_step = 4;
using Spectrum = std::array<double, 76>;

constexpr Spectrum white_paint{
    0.343, 0.445, 0.551, 0.624, 0.665, 0.687, 0.708, 0.723, 0.715, 0.710, 0.745, 0.758, 0.739, 0.767, 0.777, 0.765,
    0.751, 0.745, 0.748, 0.729, 0.745, 0.757, 0.753, 0.750, 0.746, 0.747, 0.735, 0.732, 0.739, 0.734, 0.725, 0.721,
    0.733, 0.725, 0.732, 0.743, 0.744, 0.748, 0.728, 0.716, 0.733, 0.726, 0.713, 0.740, 0.754, 0.764, 0.752, 0.736,
    0.734, 0.741, 0.740, 0.732, 0.745, 0.755, 0.751, 0.744, 0.731, 0.733, 0.744, 0.731, 0.712, 0.708, 0.729, 0.730,
    0.727, 0.707, 0.703, 0.729, 0.750, 0.760, 0.751, 0.739, 0.724, 0.730, 0.740, 0.737};

constexpr Spectrum red_paint{0.040, 0.046, 0.048, 0.053, 0.049, 0.050, 0.053, 0.055, 0.057, 0.056, 0.059, 0.057, 0.061,
                             0.061, 0.060, 0.062, 0.062, 0.062, 0.061, 0.062, 0.060, 0.059, 0.057, 0.058, 0.058, 0.058,
                             0.056, 0.055, 0.056, 0.059, 0.057, 0.055, 0.059, 0.059, 0.058, 0.059, 0.061, 0.061, 0.063,
                             0.063, 0.067, 0.068, 0.072, 0.080, 0.090, 0.099, 0.124, 0.154, 0.192, 0.255, 0.287, 0.349,
                             0.402, 0.443, 0.487, 0.513, 0.558, 0.584, 0.620, 0.606, 0.609, 0.651, 0.612, 0.610, 0.650,
                             0.638, 0.627, 0.620, 0.630, 0.628, 0.642, 0.639, 0.657, 0.639, 0.635, 0.642};

constexpr Spectrum green_paint{
    0.092, 0.096, 0.098, 0.097, 0.098, 0.095, 0.095, 0.097, 0.095, 0.094, 0.097, 0.098, 0.096, 0.101, 0.103, 0.104,
    0.107, 0.109, 0.112, 0.115, 0.125, 0.140, 0.160, 0.187, 0.229, 0.285, 0.343, 0.390, 0.435, 0.464, 0.472, 0.476,
    0.481, 0.462, 0.447, 0.441, 0.426, 0.406, 0.373, 0.347, 0.337, 0.314, 0.285, 0.277, 0.266, 0.250, 0.230, 0.207,
    0.186, 0.171, 0.160, 0.148, 0.141, 0.136, 0.130, 0.126, 0.123, 0.121, 0.122, 0.119, 0.114, 0.115, 0.117, 0.117,
    0.118, 0.120, 0.122, 0.128, 0.132, 0.139, 0.144, 0.146, 0.150, 0.152, 0.157, 0.159};

// The light was given at 400, 500, 600 and 700 nanometres.
Spectrum light() {
    constexpr std::array<double, 4> given{0, 8, 15.6, 18.4};
    Spectrum result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double place = static_cast<double>(nanometre_step * i) / 100;
        const auto before = std::min<std::size_t>(static_cast<std::size_t>(place), given.size() - 2);
        result[i] = std::lerp(given[before], given[before + 1], place - static_cast<double>(before));
    }
    return result;
}

// A bell with two widths.
double bell(double at, double middle, double below, double above) {
    return std::exp(-0.5 * std::pow((at - middle) / (at < middle ? below : above), 2));
}

// The colour matching functions of the CIE's observer of 1931, as sums of bells (Wyman, Sloan and Shirley, Simple
// Analytic Approximations to the CIE XYZ Color Matching Functions, Journal of Computer Graphics Techniques 2(2), 2013).
Vec3d matching(double nanometres) {
    const double l = nanometres;
    return {
        1.056 * bell(l, 599.8, 37.9, 31.0) + 0.362 * bell(l, 442.0, 16.0, 26.7) - 0.065 * bell(l, 501.1, 20.4, 26.2),
        0.821 * bell(l, 568.8, 46.9, 40.5) + 0.286 * bell(l, 530.9, 16.3, 31.1),
        1.217 * bell(l, 437.0, 11.8, 36.0) + 0.681 * bell(l, 459.0, 26.0, 13.8)};
}

// Linear RGB with the primaries of Rec. 709 (and sRGB).
Color rgb_of(const Spectrum& spectrum) {
    Vec3d xyz{0, 0, 0};
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == spectrum.size();  // the trapezoid rule
        xyz += (is_end ? 0.5 : 1) * spectrum[i] * matching(first_nanometre + nanometre_step * static_cast<double>(i));
    }
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
            -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

Color reflected(const Spectrum& reflectance) {
    Spectrum product = light();
    for (std::size_t i = 0; i < product.size(); ++i) product[i] *= reflectance[i];
    return rgb_of(product) / rgb_of(light());
}

std::string in_words(const Color& color) { return fmt::format("{:.3f}, {:.3f}, {:.3f}", color.r, color.g, color.b); }

}  // namespace

std::vector<MeasuredColor> measured_reflectances() {
    return {{"white", reflected(white_paint)}, {"red", reflected(red_paint)}, {"green", reflected(green_paint)}};
}

Color measured_light() { return rgb_of(light()) / rgb_of(light()).r; }

std::vector<std::string> color_header() { return {"surface", "from its spectrum", "in scene.toml"}; }

std::vector<std::vector<std::string>> color_rows(const Scene& scene) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, color] : measured_reflectances()) {
        const auto material = std::ranges::find(scene.materials, name, &Material::name);
        rows.push_back({name, in_words(color), in_words(std::get<Color>(material->diffuse))});
    }
    rows.push_back({"light, before balancing", in_words(measured_light()), "1, 1, 1 times its strength"});
    return rows;
}

}  // namespace raylab::cornell
