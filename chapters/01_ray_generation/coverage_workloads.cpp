#include "coverage_workloads.h"

#include "raylab/experiment/pixel_coverage.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/picture_point.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace raylab::ray_generation {

namespace {

constexpr ImageSize size{128, 96};
// In a workload; a level edge has a single height, so many of them are needed to be fair to a grid.
constexpr int triangle_count = 96;

using Corners = std::array<glm::dvec2, 3>;

// A triangle in space, in floats, whose picture has approximately these corners.
Triangle behind(const CameraFrame& frame, const Corners& corners, RandomSequence& random) {
    const auto point = [&](const glm::dvec2& at) {
        const double across = (2 * at.x / size.width - 1) * frame.half_width;
        const double upward = (1 - 2 * at.y / size.height) * frame.half_height;
        const double depth = random.between(3, 9);
        return convert<float>(frame.eye + depth * (frame.forward + across * frame.right + upward * frame.up));
    };
    return {point(corners[0]), point(corners[1]), point(corners[2])};
}

// The exact picture of its float corners: straight edges stay straight in a picture.
Corners outline(const CameraFrame& frame, const Triangle& triangle) {
    const auto at = [&](const Vec3f& corner) {
        const auto p = picture_point(frame, convert<double>(corner));
        assert(p);
        return glm::dvec2(p->x, p->y);
    };
    return {at(triangle.a), at(triangle.b), at(triangle.c)};
}

// The range of pixels, inside 0 to `count`, that the extent of three coordinates may reach; the last one is excluded.
std::pair<int, int> pixels_between(double a, double b, double c, int count) {
    const auto [smallest, largest] = std::minmax({a, b, c});
    return {static_cast<int>(std::clamp(std::floor(smallest), 0.0, 1.0 * count)),
            static_cast<int>(std::clamp(std::ceil(largest), 0.0, 1.0 * count))};
}

// At most `most` of the pixels that the triangles' edges cross, evenly spread.
Coverage edge_pixels(std::string name, std::string about, std::vector<Triangle> data, std::size_t largest) {
    const CameraFrame frame = coverage_camera();
    std::vector<PixelQuery> all;
    for (std::uint32_t i = 0; i < data.size(); ++i) {
        const Corners corners = outline(frame, data[i]);
        const auto columns = pixels_between(corners[0].x, corners[1].x, corners[2].x, size.width);
        const auto rows = pixels_between(corners[0].y, corners[1].y, corners[2].y, size.height);
        for (int y = rows.first; y < rows.second; ++y)
            for (int x = columns.first; x < columns.second; ++x) {
                const double covered = pixel_coverage(corners, x, y);
                if (covered > 1e-6 && covered < 1 - 1e-6) all.push_back({i, x, y});
            }
    }
    Coverage workload{std::move(name), std::move(about), std::move(data), {}};
    const std::size_t count = std::min(largest, all.size());
    for (std::size_t k = 0; k < count; ++k) workload.queries.push_back(all[k * all.size() / count]);
    return workload;
}

}  // namespace

CameraFrame coverage_camera() { return camera_frame({.position = {0.3, 1.2, 5}, .target = {0, 1, 0}}, size); }

std::vector<double> true_coverages(const Coverage& workload) {
    const CameraFrame frame = coverage_camera();
    std::vector<double> truth;
    for (const auto& [triangle, x, y] : workload.queries)
        truth.push_back(pixel_coverage(outline(frame, workload.data[triangle]), x, y));
    return truth;
}

std::vector<Coverage> coverage_workloads(const ChapterRun& run) {
    const std::size_t largest = run.sized<std::size_t>(3000, 600);
    const CameraFrame frame = coverage_camera();
    RandomSequence random(run.seed, 0);
    const auto anywhere = [&] {
        const double x = random.between(5, size.width - 5.0);
        return glm::dvec2(x, random.between(5, size.height - 5.0));
    };
    std::vector<Triangle> slanted, level, slivers;
    for (int i = 0; i < triangle_count; ++i) {
        const glm::dvec2 a = anywhere(), b = anywhere(), c = anywhere();
        slanted.push_back(behind(frame, {a, b, c}, random));
        // The third corner lies so far below the picture that the sides are parallel to its columns.
        const glm::dvec2 left = 0.5 * a;
        level.push_back(behind(frame, {left, left + glm::dvec2(60, 0), left + glm::dvec2(30, 1e5)}, random));
        const glm::dvec2 along = glm::normalize(b - a);
        slivers.push_back(behind(frame, {a, b, a + 0.33 * glm::dvec2(-along.y, along.x)}, random));
    }
    return {edge_pixels("slanted edges", "pixels crossed by the edges of random triangles", slanted, largest),
            edge_pixels("level edges", "pixels crossed by edges along the rows and columns", level, largest),
            edge_pixels("slivers", "triangles a third of a pixel wide", slivers, largest)};
}

}  // namespace raylab::ray_generation
