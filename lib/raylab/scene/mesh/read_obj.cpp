#include "raylab/scene/mesh/mesh_formats.h"
#include "raylab/scene/mesh/text_lines.h"
#include "raylab/scene/mesh_builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace raylab {

namespace {

// Keywords that do not matter for polygons: texture coordinates, groups, materials, display, points and lines.
constexpr std::array<std::string_view, 16> passed_over{"vt",       "g",        "s",      "o",         "mg", "usemtl",
                                                       "mtllib",   "usemap",   "maplib", "p",         "l",  "bevel",
                                                       "c_interp", "d_interp", "lod",    "shadow_obj"};

// OBJ gives a normal to each corner of each face; a Mesh has one for each vertex. This class keeps the normals as long
// as the corners of each vertex agree.
class CornerNormals {
public:
    CornerNormals(const std::vector<Vec3f>& normals, MeshBuilder& builder) : normals_(normals), builder_(builder) {}

    void corner(std::size_t vertex, std::optional<std::size_t> normal) {
        while (vertex >= of_vertex_.size()) builder_.keep(of_vertex_, {});
        auto& known = of_vertex_[vertex];
        agree_ = agree_ && normal && (!known || normals_[*known] == normals_[*normal]);
        known = normal;
    }

    /// Gives each vertex its normal; zero to one that no face has. Gives none where a corner has none, or a vertex has
    /// two.
    void give_to_vertices() const {
        if (!agree_) return;
        for (std::size_t vertex = 0; vertex < builder_.vertex_count(); ++vertex) {
            const bool known = vertex < of_vertex_.size() && of_vertex_[vertex];
            builder_.normal(known ? normals_[*of_vertex_[vertex]] : Vec3f{0, 0, 0});
        }
    }

private:
    const std::vector<Vec3f>& normals_;
    MeshBuilder& builder_;
    std::vector<std::optional<std::size_t>> of_vertex_;
    bool agree_ = true;
};

class ObjReader {
public:
    ObjReader(std::string_view bytes, const std::string& name, const MemoryLimit& limit)
        : lines_(bytes, name, {.comment = '#', .backslash = TextLayout::Backslash::joins_lines}),
          builder_([this] { return lines_.place(); }, limit) {}

    Mesh read() {
        while (lines_.next()) read_line();
        corner_normals_.give_to_vertices();
        return builder_.finish();
    }

private:
    void read_line() {
        const auto keyword = lines_.words()[0];
        if (keyword == "v") return builder_.vertex(three_numbers());
        if (keyword == "vn") return builder_.keep(normals_, three_numbers());
        if (keyword == "f") return read_face();
        if (keyword == "vt") ++texture_count_;
        if (std::ranges::find(passed_over, keyword) == passed_over.end())
            lines_.refuse("v, vn, f or another keyword of OBJ's polygons");
    }

    // Reads a vertex; a weight or a colour may follow, and is ignored.
    Vec3f three_numbers() const {
        const auto found = lines_.words().size() - 1;
        if (found < 3) lines_.refuse_line("3 numbers");
        for (std::size_t word = 4; word <= found; ++word) lines_.number(word);
        return lines_.vector(1);
    }

    void read_face() {
        corners_.clear();
        for (std::size_t word = 1; word < lines_.words().size(); ++word) {
            const auto [vertex, texture, normal] = parts(word);
            corners_.push_back(static_cast<std::int64_t>(index(word, vertex, builder_.vertex_count(), "vertices")));
            if (!texture.empty()) index(word, texture, texture_count_, "texture coordinates");
            corner_normals_.corner(
                static_cast<std::size_t>(corners_.back()),
                normal.empty() ? std::nullopt : std::optional(index(word, normal, normals_.size(), "normals")));
        }
        builder_.polygon(corners_, builder_.vertex_count());
    }

    // "v", "v/vt", "v//vn" or "v/vt/vn".
    std::array<std::string_view, 3> parts(std::size_t word) const {
        std::array<std::string_view, 3> found;
        auto rest = lines_.words()[word];
        for (auto& part : found) {
            const auto slash = rest.find('/');
            part = rest.substr(0, slash);
            if (slash == rest.npos) return found;
            rest.remove_prefix(slash + 1);
        }
        lines_.refuse("v, v/vt, v//vn or v/vt/vn", word);
    }

    // An index, which counts from 1, or backward from the last one so far as -1. The result counts from 0.
    std::size_t index(std::size_t word, std::string_view text, std::size_t count, std::string_view of_what) const {
        const auto known = static_cast<std::int64_t>(count);
        std::int64_t value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = problem == std::errc{} && end == text.data() + text.size();
        if (!whole || value == 0 || value > known || value < -known)
            lines_.refuse("an index of the " + std::to_string(count) + " " + std::string(of_what) +
                              " above, from 1 or from -1 back",
                          word);
        return static_cast<std::size_t>(value > 0 ? value - 1 : known + value);
    }

    TextLines lines_;
    MeshBuilder builder_;
    std::vector<Vec3f> normals_;
    CornerNormals corner_normals_{normals_, builder_};
    std::size_t texture_count_ = 0;
    std::vector<std::int64_t> corners_;
};

}  // namespace

Mesh read_obj(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    return ObjReader(bytes, name, limit).read();
}

}  // namespace raylab
