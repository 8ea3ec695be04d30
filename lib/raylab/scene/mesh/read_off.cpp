#include "raylab/scene/mesh/mesh_formats.h"
#include "raylab/scene/mesh/text_lines.h"
#include "raylab/scene/mesh_builder.h"

#include <algorithm>

namespace raylab {

namespace {

// "[ST][C][N]OFF": what a vertex line holds in addition to its position.
struct VertexLayout {
    std::size_t texture = 0, colors = 0, normals = 0;  // how many numbers of each
};

bool take_prefix(std::string_view& word, std::string_view prefix) {
    if (!word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return true;
}

VertexLayout read_keyword(TextLines& lines) {
    lines.expect_next("OFF");
    VertexLayout layout;
    auto rest = lines.words()[0];
    if (take_prefix(rest, "ST")) layout.texture = 2;
    if (take_prefix(rest, "C")) layout.colors = 4;
    if (take_prefix(rest, "N")) layout.normals = 3;
    if (rest != "OFF") lines.refuse("OFF, or NOFF, COFF, STOFF, ... with positions of three coordinates");
    if (lines.words().size() > 1 && lines.words()[1] == "BINARY") lines.refuse("OFF in text", 1);
    return layout;
}

struct Counts {
    std::int64_t vertices, faces;
};

// Reads the counts from the keyword's own line or from the next. The third, of edges, is ignored: most writers give 0.
Counts read_counts(TextLines& lines) {
    std::size_t first = 1;
    if (lines.words().size() == 1) {
        lines.expect_next("the numbers of vertices, faces and edges");
        first = 0;
    }
    if (lines.words().size() < first + 2) lines.refuse("the numbers of vertices, faces and edges", first);
    return {lines.integer(first), lines.integer(first + 1)};
}

// Checks numbers that have to be present but are not used: colours, texture coordinates.
void pass_over_numbers(const TextLines& lines, std::size_t first, std::size_t largest, const std::string& expected) {
    if (lines.words().size() > first + largest) lines.refuse(expected, first + largest);
    for (auto word = first; word < lines.words().size(); ++word) lines.number(word);
}

void read_vertex(TextLines& lines, const VertexLayout& layout, MeshBuilder& builder) {
    lines.expect_next("a vertex");
    const auto wanted = 3 + layout.normals;
    if (lines.words().size() < wanted) lines.refuse_line("a vertex of " + std::to_string(wanted) + " numbers");
    builder.vertex(lines.vector(0));
    if (layout.normals > 0) builder.normal(lines.vector(3));
    pass_over_numbers(lines, wanted, layout.colors + layout.texture, "the end of the vertex");
}

void read_face(TextLines& lines, std::vector<std::int64_t>& corners, MeshBuilder& builder) {
    lines.expect_next("a face");
    const auto count = lines.integer(0);
    if (count < 3) lines.refuse("a face of at least 3 corners");
    if (static_cast<std::uint64_t>(count) >= lines.words().size())
        lines.refuse_line(std::to_string(count) + " indices");
    corners.clear();
    for (std::size_t corner = 1; corner <= static_cast<std::size_t>(count); ++corner)
        corners.push_back(lines.integer(corner));
    builder.polygon(corners, builder.vertex_count());
    pass_over_numbers(lines, corners.size() + 1, 4, "a colour of at most 4 numbers");
}

}  // namespace

Mesh read_off(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    TextLines lines(bytes, name, {.comment = '#'});
    MeshBuilder builder([&] { return lines.place(); }, limit);
    const auto layout = read_keyword(lines);
    const auto counts = read_counts(lines);
    // The shortest vertex is "0 0 0", the shortest face "3 0 1 2", each with the line's end.
    const auto vertices = builder.count("vertices", counts.vertices, (lines.bytes_left() + 1) / 6);
    const auto faces = builder.count("faces", counts.faces, (lines.bytes_left() + 1) / 8);
    for (std::size_t i = 0; i < vertices; ++i) read_vertex(lines, layout, builder);
    std::vector<std::int64_t> corners;
    for (std::size_t i = 0; i < faces; ++i) read_face(lines, corners, builder);
    lines.expect_end();
    return builder.finish();
}

}  // namespace raylab
