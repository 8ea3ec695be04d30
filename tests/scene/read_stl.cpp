#include "catch.h"

#include "raylab/base/bytes.h"
#include "raylab/base/file.h"
#include "raylab/scene/mesh/read_mesh.h"

#include <chrono>
#include <cmath>

using namespace raylab;

namespace {

Mesh stl(const std::string& bytes) { return read_mesh_bytes(bytes, MeshFormat::stl, "a.stl"); }

std::string file(const std::string& name) { return read_file(RAYLAB_SOURCE "/tests/scene/meshes/" + name); }

std::string facet(const std::string& vertices) {
    return "facet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\n";
}

// A binary file whose facets have these vertices, three each.
std::string binary_file(const std::vector<Vec3f>& vertices) {
    std::string bytes(80, '\0');
    append_number(bytes, static_cast<std::uint32_t>(vertices.size() / 3), std::endian::little);
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
        bytes.append(12, '\0');
        for (std::size_t corner = i; corner < i + 3; ++corner)
            for (const float number : {vertices[corner].x, vertices[corner].y, vertices[corner].z})
                append_number(bytes, number, std::endian::little);
        bytes.append(2, '\0');
    }
    return bytes;
}

// Vertices for which ((x K ^ y) K ^ z) K = 0 modulo 2^64, where K is 2^64 over the golden ratio: a hash that mesh
// readers often use, and this one once did. y can cancel only the lower half of x K, so x K must equal z / K in the
// upper half: x and z are sums of the three vectors that LLL makes of (1, 0, K), (0, 1, -1/K), (0, 0, 2^64), small in
// the last coordinate.
std::vector<Vec3f> vertices_of_one_hash(std::size_t wanted) {
    constexpr std::uint64_t k = 0x9e3779b97f4a7c15u;
    std::uint64_t inverse = 1;
    // Newton's iteration doubles the number of right bits each time.
    for (int i = 0; i < 6; ++i) inverse *= 2 - k * inverse;
    std::vector<Vec3f> vertices;
    for (std::int64_t a = -40; a <= 40; ++a)
        for (std::int64_t b = -40; b <= 40; ++b)
            for (std::int64_t c = -40; c <= 40 && vertices.size() < wanted; ++c) {
                const std::int64_t x = -559805 * a - 692619 * b + 2471971 * c;
                const std::int64_t z = 1137922 * a + 2642377 * b + 496063 * c;
                if (x < 0 || z < 0) continue;
                const std::uint64_t y = static_cast<std::uint64_t>(x) * k ^ static_cast<std::uint64_t>(z) * inverse;
                const auto as_float = [](auto bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); };
                if (y >> 32 == 0 && y != 0x80000000u && std::isfinite(as_float(y)))
                    vertices.push_back({as_float(x), as_float(y), as_float(z)});
            }
    return vertices;
}

double seconds_to_read(const std::string& bytes) {
    const auto begun = std::chrono::steady_clock::now();
    stl(bytes);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

const std::string triangle = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n");

}  // namespace

TEST_CASE("STL: equal vertices become one, both zeros being equal, numbered as they appear") {
    const auto mesh = stl("solid\n" + triangle + facet("vertex 1 0 -0\nvertex -0 0 0\nvertex 0 0 1\n") + "endsolid\n");
    CHECK(mesh.vertices == std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh.faces[1].a == 1);
    CHECK(mesh.faces[1].b == 0);
    CHECK(mesh.faces[1].c == 3);
}

TEST_CASE("STL: vertices chosen to share a hash take about as long as any others") {
    const auto chosen = vertices_of_one_hash(60'000);
    REQUIRE(chosen.size() == 60'000);
    std::vector<Vec3f> others = chosen;
    for (std::size_t i = 0; i < others.size(); ++i) others[i].x = static_cast<float>(i * 7919 % others.size());
    const double usual = seconds_to_read(binary_file(others));
    // If all shared a bucket, it would take more than 300 times as long.
    CHECK(seconds_to_read(binary_file(chosen)) < 20 * usual);
    CHECK(stl(binary_file(chosen)).vertices == chosen);
}

TEST_CASE("STL: keywords may be upper case, solids may be several, the normal may be no number") {
    CHECK(stl("SOLID A\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 "
              "0\nENDLOOP\nENDFACET\n"
              "ENDSOLID A\nsolid b\n" +
              triangle + "endsolid b\n")
              .faces.size() == 2);
}

TEST_CASE("STL: a text cut short anywhere is refused") {
    const auto whole = file("pyramid.stl");
    const auto last_word = whole.rfind("endsolid");
    for (std::size_t size = 0; size < last_word + 8; ++size) {
        INFO(size << " bytes");
        CHECK_THROWS(stl(whole.substr(0, size)));
    }
}

TEST_CASE("STL: a binary file cut short anywhere, or with a byte too many, is refused, 'solid' or not") {
    for (const auto* name : {"pyramid_binary.stl", "solid_binary.stl"}) {
        const auto whole = file(name);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            INFO(name << ", " << size << " bytes");
            CHECK_THROWS(stl(whole.substr(0, size)));
        }
        CHECK_THROWS_WITH(stl(whole + '\0'), "a.stl: expected 384 bytes for the 6 facets it promises, found 385");
    }
}

TEST_CASE("STL: a number that is not finite is refused with its facet") {
    auto bytes = file("pyramid_binary.stl");
    bytes.replace(84 + 50 + 12, 4, "\xff\xff\xff\x7f", 4);  // NaN
    CHECK_THROWS_WITH(stl(bytes), Catch::StartsWith("a.stl byte 134 (facet 1): expected three finite numbers"));
}

TEST_CASE("STL: other lines than the grammar's are refused") {
    CHECK_THROWS_WITH(stl("solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\n")),
                      "a.stl:6: expected 'vertex' and 3 numbers, found 'endloop'");
    CHECK_THROWS_WITH(stl("solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n")),
                      "a.stl:7: expected 'endloop' alone, found 'vertex 1 1 0'");
    CHECK_THROWS_WITH(stl("solid\nendsolid\nfacet\n"),
                      "a.stl:3: expected 'solid', or the end of the file, found 'facet'");
    CHECK_THROWS_WITH(stl("ply\n"),
                      "a.stl: expected an STL file: 'solid' in text, or at least 84 bytes, found 4 bytes");
}
