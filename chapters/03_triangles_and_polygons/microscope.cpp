#include "microscope.h"

#include "judge.h"

#include "raylab/image/draw.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

constexpr int cell_size = 16;  // in pixels

/// The float that is `steps` floats further.
float stepped(float value, int steps) {
    const float end = std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(steps));
    for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, end);
    return value;
}

Ray aimed(const Vec3f& origin, const Vec3f& target) { return {origin, target - origin}; }

TriangleWorkload rays_through(const Specimen& specimen, int cells) {
    TriangleWorkload workload{.name = "microscope", .about = "", .data = specimen.triangles, .queries = {}};
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            Ray ray = specimen.ray;
            ray.direction.x = stepped(ray.direction.x, x - cells / 2);
            ray.direction.y = stepped(ray.direction.y, cells / 2 - y);
            for (std::uint32_t i = 0; i < specimen.triangles.size(); ++i) workload.queries.push_back({ray, i});
        }
    return workload;
}

/// The triangles that a ray hits.
struct Sight {
    std::size_t hits = 0, which = 0;
};

void fill(Image& image, int x, int y, const Pixel& color) {
    for (int j = 0; j < cell_size; ++j)
        for (int i = 0; i < cell_size; ++i) image.at(x * cell_size + i, y * cell_size + j) = color;
}

void draw_cell(Image& image, int x, int y, const Sight& sight) {
    const std::array<Pixel, 6> colors = {ink::sky_blue, ink::orange, ink::green, ink::yellow, ink::purple, ink::blue};
    const double left = x * cell_size, top = y * cell_size, middle = cell_size / 2.0;
    if (sight.hits == 0) {
        fill(image, x, y, ink::black);
        draw_circle(image, {left + middle, top + middle}, 0.25 * cell_size, 2, ink::white);
        return;
    }
    if (sight.hits > 1) {
        fill(image, x, y, ink::white);
        draw_cross(image, {left + middle, top + middle}, 0.5 * cell_size, 2, ink::black);
        return;
    }
    fill(image, x, y, colors[sight.which % colors.size()]);
    const double angle = std::numbers::pi * (0.25 + static_cast<double>(sight.which) / 2);
    const Point2 reach{0.3 * cell_size * std::cos(angle), 0.3 * cell_size * std::sin(angle)};
    draw_line(image, {left + middle - reach.x, top + middle - reach.y},
              {left + middle + reach.x, top + middle + reach.y}, 1.4, ink::black);
}

}  // namespace

Specimen shared_edge() {
    const Vec3f p{-0.81f, -0.67f, 0.13f}, q{0.73f, 0.92f, -0.21f};
    const Vec3f left{-0.95f, 0.88f, 0.35f}, right{0.97f, -0.79f, 0.18f};
    return {{{p, q, left}, {q, p, right}}, aimed({0.31f, -0.27f, 2.9f}, p + 0.43f * (q - p))};
}

Specimen shared_vertex() {
    const Vec3f center{0.12f, -0.07f, 0.05f};
    std::vector<Vec3f> rim;
    for (int i = 0; i < 6; ++i) {
        const float angle = 0.3f + static_cast<float>(i) * 2 * std::numbers::pi_v<float> / 6;
        rim.push_back(center + Vec3f{std::cos(angle), std::sin(angle), 0.17f * std::sin(3 * angle + 1)});
    }
    Specimen specimen{{}, aimed({0.31f, -0.27f, 2.9f}, center)};
    for (std::size_t i = 0; i < 6; ++i) specimen.triangles.push_back({center, rim[i], rim[(i + 1) % 6]});
    return specimen;
}

Image microscope(const TriangleMethod& method, const Specimen& specimen, int cells) {
    const auto answers = answers_of(method, rays_through(specimen, cells));
    Image image(cells * cell_size, cells * cell_size);
    std::size_t query = 0;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            Sight sight;
            for (std::size_t i = 0; i < specimen.triangles.size(); ++i)
                if (answers[query++]) {
                    ++sight.hits;
                    sight.which = i;
                }
            draw_cell(image, x, y, sight);
        }
    return image;
}

}  // namespace raylab
