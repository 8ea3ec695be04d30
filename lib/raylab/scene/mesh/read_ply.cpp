#include "raylab/scene/mesh/mesh_formats.h"
#include "raylab/scene/mesh/ply_values.h"
#include "raylab/scene/mesh_builder.h"

#include <algorithm>
#include <array>

namespace raylab {

namespace {

// The role of a property in a mesh.
enum class Role { x, y, z, nx, ny, nz, corners, none };
constexpr std::array<std::string_view, 6> coordinates{"x", "y", "z", "nx", "ny", "nz"};

Role role_of(const PlyProperty& property, const PlyElement& element) {
    if (element.name == "face" && property.count && property.type < PlyType::float32 &&
        (property.name == "vertex_indices" || property.name == "vertex_index"))
        return Role::corners;
    const auto coordinate = std::ranges::find(coordinates, property.name);
    if (element.name != "vertex" || property.count || coordinate == coordinates.end()) return Role::none;
    return static_cast<Role>(coordinate - coordinates.begin());
}

/// An element, and the roles of its properties.
struct Rows {
    PlyElement element;
    std::vector<Role> roles;

    explicit Rows(const PlyElement& of) : element(of) {
        for (const auto& property : element.properties) roles.push_back(role_of(property, element));
    }
    bool have(Role role) const { return std::ranges::find(roles, role) != roles.end(); }
    bool have_position() const { return have(Role::x) && have(Role::y) && have(Role::z); }
    bool have_normal() const { return have(Role::nx) && have(Role::ny) && have(Role::nz); }
};

// Reads the elements row by row.
template <PlyValues Values>
class PlyBody {
public:
    PlyBody(Values values, std::vector<Rows> parts, const MemoryLimit& limit)
        : values_(std::move(values)), parts_(std::move(parts)), builder_([this] { return values_.place(); }, limit) {}

    Mesh read() {
        const auto vertices = std::ranges::find_if(parts_, &Rows::have_position);
        if (vertices == parts_.end()) throw Error(values_.place(), "an element vertex with x, y and z", "none");
        if (std::ranges::none_of(parts_, [](const Rows& rows) { return rows.have(Role::corners); }))
            throw Error(values_.place(), "an element face with a list vertex_indices of integers", "none");
        vertex_count_ = static_cast<std::size_t>(std::max<std::int64_t>(0, vertices->element.count));
        for (const auto& rows : parts_) read_rows(rows);
        values_.end();
        return builder_.finish();
    }

private:
    void read_rows(const Rows& rows) {
        const auto& [name, count, properties] = rows.element;
        const auto row_count = builder_.count("rows of " + name, count, values_.begin(rows.element));
        for (std::size_t row = 0; row < row_count; ++row) {
            values_.begin_row(row);
            for (std::size_t i = 0; i < properties.size(); ++i) read_value(properties[i], rows.roles[i]);
            values_.end_row();
            if (rows.have_position()) builder_.vertex({numbers_[0], numbers_[1], numbers_[2]});
            if (rows.have_normal()) builder_.normal({numbers_[3], numbers_[4], numbers_[5]});
            if (rows.have(Role::corners)) builder_.polygon(corners_, vertex_count_);
        }
    }

    void read_value(const PlyProperty& property, Role role) {
        const auto count = property.count ? values_.length(*property.count, property.type) : std::size_t{1};
        if (role == Role::none) return values_.skip(property.type, count);
        if (role != Role::corners) {
            numbers_[static_cast<std::size_t>(role)] = values_.number(property.type);
            return;
        }
        corners_.clear();
        for (std::size_t i = 0; i < count; ++i) corners_.push_back(values_.integer(property.type));
    }

    Values values_;
    std::vector<Rows> parts_;
    MeshBuilder builder_;
    std::size_t vertex_count_ = 0;  // the count of the header, because faces may come first
    std::array<float, 6> numbers_{};
    std::vector<std::int64_t> corners_;
};

// The offset at which the bytes begin: after the line end of end_header. That line end is taken to be as long as the
// first line's, because a byte that looks like the second half of a line end may be the first of a number.
std::size_t body_begin(std::string_view bytes, std::string_view end_header) {
    const auto first = std::min(bytes.find_first_of("\r\n"), bytes.size());
    const auto last = bytes.find_first_of("\r\n", static_cast<std::size_t>(end_header.end() - bytes.begin()));
    if (last == bytes.npos) return bytes.size();
    return std::min(last + (bytes.substr(first, 2) == "\r\n" ? 2 : 1), bytes.size());
}

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& name, const MemoryLimit& limit) {
    TextLines lines(bytes, name);
    const auto header = read_ply_header(lines);
    const std::vector<Rows> parts(header.elements.begin(), header.elements.end());
    if (header.encoding == PlyEncoding::text) return PlyBody(PlyText(lines), parts, limit).read();
    const auto order = header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big;
    return PlyBody(PlyBytes(bytes, body_begin(bytes, lines.words()[0]), order, name), parts, limit).read();
}

}  // namespace raylab
