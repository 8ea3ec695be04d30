#include "raylab/base/bytes.h"
#include "raylab/base/small_letters.h"
#include "raylab/scene/mesh/mesh_formats.h"
#include "raylab/scene/mesh/text_lines.h"
#include "raylab/scene/mesh_builder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <tuple>
#include <vector>

namespace raylab {

namespace {

// A binary file has 80 bytes of any content, the number of facets, and the facets.
constexpr std::size_t first_facet = 84;
constexpr std::size_t facet_size = 50;  // a normal, three vertices, and two unused bytes
// The memory for each byte of the file: the 50 bytes of a facet give three corners of 16 bytes in a list that has just
// doubled while its old half is copied.
constexpr double max_growth = 3.0 * 3 * 16 / facet_size;

std::size_t facet_count(std::string_view bytes) { return number_at<std::uint32_t>(bytes, 80, std::endian::little); }

bool has_binary_size(std::string_view bytes) {
    return bytes.size() >= first_facet && bytes.size() == first_facet + facet_size * facet_count(bytes);
}

// "solid" alone proves nothing, because many binary files begin so. But those hold a NUL, which no text does: in their
// number of facets already, if it is below 2^24.
bool is_text(std::string_view bytes) {
    TextLines lines(bytes, {});
    return bytes.find('\0') == bytes.npos && lines.next() && equal_ignoring_case(lines.words()[0], "solid");
}

/// Turns facets into faces: equal vertices become one, in order of appearance. It sorts instead of hashing, because for
/// a known hash function one can write a file in which all vertices have the same hash.
class FacetMerger {
public:
    explicit FacetMerger(MeshBuilder& builder) : builder_(builder) {}

    void facet(const std::array<Vec3f, 3>& vertices) {
        for (const auto& vertex : vertices)
            corners_.push_back({builder_.finite(vertex), static_cast<std::uint32_t>(corners_.size())});
    }

    Mesh finish() {
        const auto vertices = vertex_of_corner();
        for (const auto& [position, index] : corners_) builder_.vertex(position);
        for (std::size_t i = 0; i < vertices.size(); i += 3)
            builder_.polygon(std::array<std::int64_t, 3>{vertices[i], vertices[i + 1], vertices[i + 2]},
                             builder_.vertex_count());
        return builder_.finish();
    }

private:
    struct Corner {
        Vec3f position;
        std::uint32_t index;  // of the corner in the file; its 2 GiB hold fewer than 2^32

        auto numbers() const { return std::tuple(position.x, position.y, position.z); }  // 0 and -0 are equal
    };

    // The vertex of each corner. Of equal corners only the first is kept, so that corners_ become the vertices.
    std::vector<std::uint32_t> vertex_of_corner() {
        std::ranges::sort(corners_, {}, [](const Corner& c) { return std::tuple(c.numbers(), c.index); });
        std::vector<std::uint32_t> vertices(corners_.size());
        std::size_t kept = 0;
        for (const Corner& corner : corners_) {
            if (kept == 0 || corners_[kept - 1].numbers() != corner.numbers()) corners_[kept++] = corner;
            vertices[corner.index] = corners_[kept - 1].index;
        }
        corners_.resize(kept);
        std::ranges::sort(corners_, {}, &Corner::index);
        std::uint32_t next = 0;
        // A corner that is no vertex of its own equals an earlier corner.
        for (std::uint32_t i = 0; i < vertices.size(); ++i)
            vertices[i] = next < kept && corners_[next].index == i ? next++ : vertices[vertices[i]];
        return vertices;
    }

    MeshBuilder& builder_;
    std::vector<Corner> corners_;
};

Mesh read_binary(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    if (bytes.size() < first_facet)
        throw Error({name}, "an STL file: 'solid' in text, or at least 84 bytes",
                    std::to_string(bytes.size()) + " bytes");
    const auto count = facet_count(bytes);
    if (!has_binary_size(bytes))
        throw Error({name},
                    std::to_string(first_facet + facet_size * count) + " bytes for the " + std::to_string(count) +
                        " facets it promises",
                    std::to_string(bytes.size()));
    std::size_t facet = 0;
    const auto begin = [&] { return first_facet + facet_size * facet; };
    MeshBuilder builder(
        [&] {
            return Place{name, 0, "byte " + std::to_string(begin()) + " (facet " + std::to_string(facet) + ")"};
        },
        limit);
    FacetMerger merger(builder);
    for (; facet < count; ++facet) {
        const auto number = [&](std::size_t i) {
            return number_at<float>(bytes, begin() + 4 * i, std::endian::little);
        };
        const auto vector = [&](std::size_t i) { return Vec3f{number(i), number(i + 1), number(i + 2)}; };
        merger.facet({vector(3), vector(6), vector(9)});  // the numbers 0 to 2 are the normal
    }
    return merger.finish();
}

bool begins_with(const TextLines& lines, std::initializer_list<std::string_view> words) {
    return lines.words().size() >= words.size() &&
           std::ranges::equal(lines.words() | std::views::take(words.size()), words, equal_ignoring_case);
}

// Throws an Error unless the line holds these words, and then as many more.
void expect(const TextLines& lines, std::initializer_list<std::string_view> words, std::size_t numbers) {
    if (!begins_with(lines, words) || lines.words().size() != words.size() + numbers)
        lines.refuse_line(fmt::format("'{}'{}", fmt::join(words, " "), numbers > 0 ? " and 3 numbers" : " alone"));
}

void expect_next(TextLines& lines, std::initializer_list<std::string_view> words, std::size_t numbers) {
    lines.expect_next(*words.begin());
    expect(lines, words, numbers);
}

// Reads a facet from its line "facet normal" on. The normal's numbers are not parsed, because for a facet without area
// they may be invalid.
void read_text_facet(TextLines& lines, FacetMerger& merger) {
    expect(lines, {"facet", "normal"}, 3);
    expect_next(lines, {"outer", "loop"}, 0);
    std::array<Vec3f, 3> vertices;
    for (auto& vertex : vertices) {
        expect_next(lines, {"vertex"}, 3);
        vertex = lines.vector(1);
    }
    merger.facet(vertices);
    expect_next(lines, {"endloop"}, 0);
    expect_next(lines, {"endfacet"}, 0);
}

// A text file holds one or more of "solid NAME", facets, "endsolid NAME".
Mesh read_text(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    TextLines lines(bytes, name);
    MeshBuilder builder([&] { return lines.place(); }, limit);
    FacetMerger merger(builder);
    while (lines.next()) {
        if (!begins_with(lines, {"solid"})) lines.refuse_line("'solid', or the end of the file");
        for (lines.expect_next("a facet or endsolid"); !begins_with(lines, {"endsolid"});
             lines.expect_next("a facet or endsolid"))
            read_text_facet(lines, merger);
    }
    return merger.finish();
}

}  // namespace

Mesh read_stl(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    check_memory({.bytes = max_growth * static_cast<double>(bytes.size()),
                  .what = "a mesh",
                  .why = std::to_string(bytes.size()) + " bytes of STL"},
                 limit, {name});
    return is_text(bytes) ? read_text(bytes, name, limit) : read_binary(bytes, name, limit);
}

}  // namespace raylab
