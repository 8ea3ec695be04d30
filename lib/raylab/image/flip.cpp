#include "raylab/image/flip.h"

#include "raylab/image/color.h"
#include "raylab/image/color_spaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace raylab {

namespace {

using Color3 = glm::dvec3;
using Picture = std::vector<Color3>;  // row by row, in the colour space that the variable's name says
constexpr double pi = std::numbers::pi;

struct Grid {
    int width, height;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

// Converts to L*a*b* and applies Hunt's effect, equation (2).
Color3 hunt_lab_from_rgb(const Color3& rgb) {
    const Color3 lab = lab_from_rgb(rgb);
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

// ---- Filtering. All of FLIP's kernels are sums of products k(x) k'(y), so they are applied as a pass along rows, then
// one along columns.
using Kernel = std::vector<double>;  // odd length, centred

Picture pass(const Picture& from, Grid grid, int dx, int dy, const std::array<Kernel, 3>& kernels) {
    const int radius = static_cast<int>(kernels[0].size() / 2);
    Picture to(from.size(), Color3(0));
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            for (int i = -radius; i <= radius; ++i) {  // beyond the edge the picture's border is repeated
                const Color3& value = from[grid.index(std::clamp(x + i * dx, 0, grid.width - 1),
                                                      std::clamp(y + i * dy, 0, grid.height - 1))];
                const auto k = static_cast<std::size_t>(i + radius);
                to[grid.index(x, y)] += Color3(kernels[0][k], kernels[1][k], kernels[2][k]) * value;
            }
    return to;
}

template <class Function>
Kernel kernel(int radius, const Function& function) {
    Kernel weights;
    for (int i = -radius; i <= radius; ++i) weights.push_back(function(i));
    return weights;
}

double sum(const Kernel& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

// ---- The contrast sensitivity of the eye, equation (1): two Gaussians for each channel.
struct Gaussian {
    double a, b;
};
using TwoGaussians = std::array<Gaussian, 2>;
constexpr std::array<TwoGaussians, 3> sensitivity{TwoGaussians{{{1, 0.0047}, {0, 1e-5}}},        // achromatic
                                                  TwoGaussians{{{1, 0.0053}, {0, 1e-5}}},        // red-green
                                                  TwoGaussians{{{34.1, 0.04}, {13.5, 0.025}}}};  // blue-yellow
constexpr double widest = 0.04;  // the largest b: every kernel reaches three of its standard deviations

Picture filtered(const Picture& ycxcz, Grid grid, double pixels_per_degree) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
    Picture result(ycxcz.size(), Color3(0));
    Color3 total(0);
    for (std::size_t term = 0; term < 2; ++term) {
        std::array<Kernel, 3> along;
        Color3 weight(0);
        for (int c = 0; c < 3; ++c) {
            const auto [a, b] = sensitivity[static_cast<std::size_t>(c)][term];
            Kernel& gaussian = along[static_cast<std::size_t>(c)];
            gaussian =
                kernel(radius, [&](int i) { return std::exp(-pi * pi / b * std::pow(i / pixels_per_degree, 2)); });
            weight[c] = a * std::sqrt(pi / b);
            total[c] += weight[c] * sum(gaussian) * sum(gaussian);
        }
        if (weight == Color3(0, 0, 0)) continue;
        const Picture blurred = pass(pass(ycxcz, grid, 1, 0, along), grid, 0, 1, along);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * blurred[i];
    }
    for (Color3& value : result) value /= total;
    return result;
}

// ---- Colour difference.
double hyab(const Color3& p, const Color3& q) {  // equation (3)
    return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z);
}

double color_difference(const Color3& rgb, const Color3& other) {  // equation (4)
    constexpr double q_c = 0.7, p_c = 0.4, p_t = 0.95;
    static const double largest =
        std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), q_c);  // green against blue
    const double difference = std::pow(hyab(hunt_lab_from_rgb(rgb), hunt_lab_from_rgb(other)), q_c);
    if (difference < p_c * largest) return p_t / (p_c * largest) * difference;
    return p_t + (difference - p_c * largest) / (largest - p_c * largest) * (1 - p_t);
}

// ---- Edges and points, equation (5).
struct Features {
    std::vector<double> edges, points;  // for each pixel, the lengths of the gradient and of the second derivatives
};

Kernel balanced(Kernel weights) {
    double positive = 0, negative = 0;
    for (const double w : weights) (w > 0 ? positive : negative) += w;
    for (double& w : weights) w /= w > 0 ? positive : -negative;
    return weights;
}

Features features(const Picture& ycxcz, Grid grid, double pixels_per_degree) {
    constexpr double detector_width = 0.082;  // degrees
    const double sigma = 0.5 * detector_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    Kernel smooth = kernel(radius, [&](int i) { return std::exp(-i * i / (2 * sigma * sigma)); });
    const Kernel edge = balanced(kernel(radius, [&](int i) { return -i * std::exp(-i * i / (2 * sigma * sigma)); }));
    const Kernel point = balanced(
        kernel(radius, [&](int i) { return (i * i / (sigma * sigma) - 1) * std::exp(-i * i / (2 * sigma * sigma)); }));
    const double scale = 1 / sum(smooth);
    for (double& w : smooth) w *= scale;

    Picture grey(ycxcz.size());
    std::ranges::transform(ycxcz, grey.begin(), [](const Color3& c) { return Color3((c.x + 16) / 116); });
    // The three channels of one pass hold the edge filter, the point filter, and nothing.
    const Picture across = pass(pass(grey, grid, 1, 0, {edge, point, smooth}), grid, 0, 1, {smooth, smooth, smooth});
    const Picture down = pass(pass(grey, grid, 0, 1, {edge, point, smooth}), grid, 1, 0, {smooth, smooth, smooth});
    Features result;
    for (std::size_t i = 0; i < grey.size(); ++i) {
        result.edges.push_back(std::hypot(across[i].x, down[i].x));
        result.points.push_back(std::hypot(across[i].y, down[i].y));
    }
    return result;
}

double feature_difference(double edges, double points) {  // equation (6)
    constexpr double q_f = 0.5;
    return std::pow(std::max(std::abs(edges), std::abs(points)) / std::numbers::sqrt2, q_f);
}

Picture ycxcz_of(const Image& image) {
    Picture picture;
    picture.reserve(image.pixels().size());
    for (const Pixel& p : image.pixels())
        picture.push_back(ycxcz_from_rgb({unit_clamped(p.r), unit_clamped(p.g), unit_clamped(p.b)}));
    return picture;
}

}  // namespace

double ErrorMap::mean() const { return values.empty() ? 0 : sum(values) / static_cast<double>(values.size()); }

ErrorMap flip(const Image& reference, const Image& test, double pixels_per_degree) {
    assert(reference.width() == test.width() && reference.height() == test.height() && pixels_per_degree > 0);
    const Grid grid{reference.width(), reference.height()};
    const Picture a = ycxcz_of(reference), b = ycxcz_of(test);
    const Picture seen_a = filtered(a, grid, pixels_per_degree), seen_b = filtered(b, grid, pixels_per_degree);
    const Features in_a = features(a, grid, pixels_per_degree), in_b = features(b, grid, pixels_per_degree);
    const auto on_screen = [](const Color3& c) { return glm::clamp(rgb_from_ycxcz(c), 0.0, 1.0); };
    ErrorMap map{grid.width, grid.height, {}};
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double color = color_difference(on_screen(seen_a[i]), on_screen(seen_b[i]));
        const double feature = feature_difference(in_a.edges[i] - in_b.edges[i], in_a.points[i] - in_b.points[i]);
        map.values.push_back(std::pow(color, 1 - feature));  // equation (7)
    }
    return map;
}

}  // namespace raylab
