#include "closed_mesh.h"

#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <array>
#include <string>

namespace raylab {

namespace {

using Corners = std::array<std::uint32_t, 3>;

Corners corners(const Mesh& mesh, std::size_t face) {
    const auto& [a, b, c] = mesh.faces[face];
    return {a, b, c};
}

/// For each vertex, the triangles that have it.
std::vector<std::vector<std::uint32_t>> faces_of_vertices(const Mesh& mesh) {
    std::vector<std::vector<std::uint32_t>> faces(mesh.vertices.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
        for (const auto corner : corners(mesh, face)) faces[corner].push_back(face);
    return faces;
}

/// The target of one ray: a point, and the vertices between which it lies.
struct Aim {
    Vec3d point;
    std::vector<std::uint32_t> vertices;
};

Aim aim(const Mesh& mesh, Target target, RandomSequence& random) {
    const auto face = static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.faces.size()) - 1));
    Corners corner = corners(mesh, face);
    const auto turn = random.whole(0, 2);
    std::ranges::rotate(corner, corner.begin() + turn);
    const auto at = [&](std::size_t i) { return convert<double>(mesh.vertices[corner[i]]); };
    if (target == Target::vertex) return {at(0), {corner[0]}};
    const double s = random.next();
    const Vec3d on_edge = at(0) + s * (at(1) - at(0));
    if (target == Target::edge) return {on_edge, {corner[0], corner[1]}};
    return {on_edge + random.next() * (at(2) - on_edge), {corner[0], corner[1], corner[2]}};
}

std::ptrdiff_t hits_of(const Shots& shots, std::span<const std::optional<TriangleHit>> answers, std::size_t shot) {
    const auto mine = answers.subspan(shots.first[shot], shots.first[shot + 1] - shots.first[shot]);
    return std::ranges::count_if(mine, [](const auto& answer) { return answer.has_value(); });
}

std::string name_of(Target target) {
    switch (target) {
        case Target::face:
            return "faces";
        case Target::edge:
            return "edges";
        case Target::vertex:
            return "vertices";
    }
    return "";
}

}  // namespace

Shots shots_inside(const Mesh& mesh, const Vec3d& center, const ShotOptions& options) {
    const auto faces_at = faces_of_vertices(mesh);
    Shots shots;
    shots.workload.name = name_of(options.target);
    shots.workload.about = "rays from inside a closed mesh, aimed at its " + shots.workload.name;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) shots.workload.data.push_back(mesh.triangle(face));

    auto& queries = shots.workload.queries;
    for (std::size_t i = 0; i < options.count; ++i) {
        RandomSequence random(options.seed, i);
        const Vec3f origin = convert<float>(center + 0.5 * random.next() * random.unit_vector());
        const auto [point, vertices] = aim(mesh, options.target, random);
        const Ray ray{origin, convert<float>(glm::normalize(point - convert<double>(origin)))};

        shots.first.push_back(queries.size());
        std::vector<std::uint32_t> asked;
        if (options.asked == Asked::all)
            for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) asked.push_back(face);
        else
            for (const auto vertex : vertices)
                asked.insert(asked.end(), faces_at[vertex].begin(), faces_at[vertex].end());
        std::ranges::sort(asked);
        asked.erase(std::ranges::unique(asked).begin(), asked.end());
        for (const auto face : asked) queries.push_back({ray, face});
    }
    shots.first.push_back(queries.size());
    return shots;
}

Leaks count_leaks(const Shots& shots, std::span<const std::optional<TriangleHit>> answers) {
    std::size_t none = 0, many = 0;
    const std::size_t count = shots.first.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto hits = hits_of(shots, answers, i);
        none += hits == 0;
        many += hits > 1;
    }
    const double million = 1e6 / static_cast<double>(count);
    return {static_cast<double>(none) * million, static_cast<double>(many) * million};
}

std::optional<std::size_t> first_leak(const Shots& shots, std::span<const std::optional<TriangleHit>> answers,
                                      Leak kind) {
    for (std::size_t i = 0; i + 1 < shots.first.size(); ++i) {
        const auto hits = hits_of(shots, answers, i);
        if (kind == Leak::none ? hits == 0 : hits > 1) return i;
    }
    return std::nullopt;
}

Mesh moved(Mesh mesh, const Vec3d& by) {
    for (auto& vertex : mesh.vertices) vertex = convert<float>(convert<double>(vertex) + by);
    return mesh;
}

}  // namespace raylab
