#include "raylab/experiment/generate/generate.h"

#include "catch.h"
#include "mesh_bits.h"

#include <array>
#include <map>
#include <string>

using namespace raylab;

namespace {

struct Named {
    std::string name;
    Mesh mesh;
    std::size_t triangles;
    double volume;     // of the smooth surface; 0: not known in closed form
    int euler_number;  // vertices - edges + faces: 2 for a sphere, 0 for a torus
};

std::vector<Named> meshes() {
    constexpr double pi = 3.14159265358979323846;
    return {{"icosphere", icosphere(5), 20 * 1024, 4 * pi / 3, 2},
            {"torus", torus(0.25, 7), 2 * 128 * 128, 2 * pi * pi * 0.25 * 0.25, 0},
            {"bumpy sphere", bumpy_sphere(5), 20 * 1024, 0, 2},
            {"trefoil knot", trefoil_knot(0.5, 7), 2 * 128 * 128, 0, 0}};
}

// Six times what the triangle and the origin span.
double six_volumes(const Triangle& t) {
    return dot(convert<double>(t.a), cross(convert<double>(t.b), convert<double>(t.c)));
}

double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) sum += six_volumes(mesh.triangle(face)) / 6;
    return sum;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, int> directed_edges(const Mesh& mesh) {
    std::map<Edge, int> edges;
    for (const auto& [a, b, c] : mesh.faces)
        for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) ++edges[edge];
    return edges;
}

}  // namespace

TEST_CASE("generated meshes have as many triangles as they promise") {
    for (const auto& [name, mesh, triangles, _, euler] : meshes()) {
        INFO(name);
        CHECK(mesh.faces.size() == triangles);
    }
    CHECK(icosphere(0).faces.size() == 20);
    CHECK(torus(0.5, 2).faces.size() == 32);
    CHECK(trefoil_knot(0.5, 4).faces.size() == 512);
}

TEST_CASE("generated meshes are closed, each edge between two triangles that agree on the outside") {
    for (const auto& [name, mesh, _, __, euler_number] : meshes()) {
        INFO(name);
        const auto edges = directed_edges(mesh);
        bool closed = true;
        for (const auto& [edge, times] : edges)
            closed = closed && times == 1 && edges.contains({edge.second, edge.first});
        CHECK(closed);
        CHECK(static_cast<int>(mesh.vertices.size() + mesh.faces.size()) - static_cast<int>(edges.size() / 2) ==
              euler_number);
    }
}

TEST_CASE("generated meshes enclose their volume, outside out") {
    for (const auto& [name, mesh, _, exact, euler] : meshes()) {
        INFO(name);
        if (exact > 0) CHECK_THAT(volume(mesh), WithinRel(exact, 2e-3));  // the facets cut corners
        CHECK(volume(mesh) > 0);
    }
}

TEST_CASE("no triangle of a generated mesh is degenerate") {
    for (const auto& [name, mesh, _, __, euler] : meshes()) {
        INFO(name);
        bool all_have_area = true;
        for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
            const auto t = mesh.triangle(face);
            const Vec3d normal =
                cross(convert<double>(t.b) - convert<double>(t.a), convert<double>(t.c) - convert<double>(t.a));
            all_have_area = all_have_area && dot(normal, normal) > 0;
        }
        CHECK(all_have_area);
    }
}

TEST_CASE("a trefoil's tube stays within four of the origin and does not touch itself") {
    const auto mesh = trefoil_knot(0.5, 7);
    const std::size_t rings = 512, ring = 32;
    double farthest = 0, nearest = 100;
    std::vector<Vec3d> centers(rings, Vec3d{0, 0, 0});
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto v = convert<double>(mesh.vertices[i]);
        farthest = std::max(farthest, std::sqrt(dot(v, v)));
        centers[i / ring] += v / double(ring);
    }
    for (std::size_t i = 0; i < rings; ++i)
        for (std::size_t j = i + rings / 8; j < i + rings - rings / 8; ++j) {
            const auto between = centers[i] - centers[j % rings];
            nearest = std::min(nearest, std::sqrt(dot(between, between)));
        }
    CHECK(farthest < 4);
    CHECK(nearest > 1.0);  // two radii
}

TEST_CASE("generated meshes are the same bits everywhere") {
    CHECK(fingerprint(icosphere(4)) == 0xb5f0547a7475d765);
    CHECK(fingerprint(torus(0.3, 6)) == 0x8df34d9bf7106c21);
    CHECK(fingerprint(bumpy_sphere(4)) == 0xac393436627dd5bd);
    CHECK(fingerprint(trefoil_knot(0.4, 6)) == 0x7dead9439558837e);
}
