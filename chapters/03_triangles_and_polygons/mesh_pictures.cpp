#include "mesh_pictures.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/barycentric.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/tracer/picture/eye_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace raylab {

namespace {

const Color leak{1, 0.85, 0.2};

/// The nearest hit by a method's answers about all triangles, given by its index.
struct Nearest {
    std::size_t face;
    TriangleHit hit;
};

std::optional<Nearest> nearest(const std::vector<std::optional<TriangleHit>>& answers) {
    std::optional<Nearest> first;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i] && (!first || answers[i]->t < first->hit.t)) first = Nearest{i, *answers[i]};
    return first;
}

Vec3d unit_normal(const Triangle& triangle) {
    const auto [a, b, c] = in<double>(triangle);
    return glm::normalize(cross(b - a, c - a));
}

/// Dark colours, so that light shows, and different for neighbours, so that facets show.
Color dark(std::size_t face) {
    const double turn = std::fmod(0.618034 * static_cast<double>(face), 1.0);
    return Color{0.010, 0.014, 0.025} + turn * Color{0.04, 0.06, 0.09};
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Each edge with the two triangles that share it.
std::map<Edge, std::vector<std::uint32_t>> shared_edges(const Mesh& mesh) {
    std::map<Edge, std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
        const auto& [a, b, c] = mesh.faces[i];
        for (const Edge& edge : {Edge(std::minmax(a, b)), Edge(std::minmax(b, c)), Edge(std::minmax(c, a))})
            faces[edge].push_back(i);
    }
    return faces;
}

}  // namespace

Image mesh_picture(const TriangleMethod& method, const Mesh& mesh, const CameraFrame& frame, int threads) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) triangles.push_back(mesh.triangle(i));
    const std::any state = method.prepare ? method.prepare(triangles) : std::any();

    return eye_picture(frame, {.threads = threads, .label = "mesh"}, [&](const Ray& ray) {
        std::vector<TriangleQuery> queries;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) queries.push_back({ray, i});
        std::vector<std::optional<TriangleHit>> answers(queries.size());
        method.answer(state, triangles, queries, answers);
        const auto first = nearest(answers);
        return first ? dark(first->face) : leak;
    });
}

Vec3d leakiest_point(const TriangleMethod& method, const Mesh& mesh, const Vec3f& eye) {
    constexpr int rays_per_edge = 50;
    Vec3d point{0, 0, 0};
    int largest = -1;
    for (const auto& [edge, faces] : shared_edges(mesh)) {
        const Vec3d from = convert<double>(mesh.vertices[edge.first]), to = convert<double>(mesh.vertices[edge.second]);
        const std::vector<Triangle> triangles = {mesh.triangle(faces[0]), mesh.triangle(faces[1])};
        std::vector<TriangleQuery> queries;
        for (int i = 0; i < rays_per_edge; ++i) {
            const Vec3d target = from + (i + 0.5) / rays_per_edge * (to - from);
            const Ray ray{eye, convert<float>(glm::normalize(target - convert<double>(eye)))};
            for (const std::uint32_t side : {0u, 1u}) queries.push_back({ray, side});
        }
        std::vector<std::optional<TriangleHit>> answers(queries.size());
        method.answer({}, triangles, queries, answers);
        int leaks = 0;
        for (std::size_t i = 0; i < answers.size(); i += 2) leaks += !answers[i] && !answers[i + 1];
        if (leaks > largest) point = 0.5 * (from + to);
        largest = std::max(largest, leaks);
    }
    return point;
}

Image ball_picture(Interpolated interpolated, ImageSize size, int threads) {
    const Mesh mesh = icosphere(1);
    const CameraFrame frame =
        camera_frame({.position = {0, 0, 4}, .target = {0, 0, 0}, .projection = Perspective{32}}, size);
    const std::array<Color, 3> primaries = {Color{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    return eye_picture(frame, {.samples = {SamplePattern::jittered, 3}, .threads = threads}, [&](const Ray& ray) {
        std::vector<std::optional<TriangleHit>> answers(mesh.faces.size());
        DecisionCounts decisions;
        for (std::size_t i = 0; i < mesh.faces.size(); ++i)
            if (const auto hit = intersect(ray, mesh.triangle(i), decisions))
                answers[i] = TriangleHit{hit->t, hit->u, hit->v};
        const auto first = nearest(answers);
        if (!first) return Color(1);

        const auto [a, b, c] = in<double>(mesh.triangle(first->face));
        const auto& [t, u, v] = first->hit;
        if (interpolated == Interpolated::colors) return interpolate(primaries[0], primaries[1], primaries[2], u, v);
        const Vec3d normal = interpolated == Interpolated::normals
                                 ? glm::normalize(interpolate(a, b, c, u, v))  // the exact normal of a unit sphere
                                 : unit_normal(mesh.triangle(first->face));
        return (normal + Vec3d(1)) * 0.5;
    });
}

}  // namespace raylab
