#include "raylab/scene/mesh/read_mesh.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/small_letters.h"
#include "raylab/scene/mesh/mesh_formats.h"
#include "raylab/scene/mesh/text_lines.h"

#include <cassert>
#include <limits>

namespace raylab {

namespace {

constexpr std::size_t largest_file = std::numeric_limits<std::int32_t>::max();

}  // namespace

MeshFormat mesh_format(const std::filesystem::path& path) {
    const std::string extension = in_small_letters(path.extension().string());
    if (extension == ".off") return MeshFormat::off;
    if (extension == ".obj") return MeshFormat::obj;
    if (extension == ".ply") return MeshFormat::ply;
    if (extension == ".stl") return MeshFormat::stl;
    throw Error({path.string()}, "a mesh file that ends in .off, .obj, .ply or .stl", in_quotes(extension));
}

Mesh read_mesh(const std::filesystem::path& path, const MemoryLimit& limit) {
    const auto format = mesh_format(path);
    return read_mesh_bytes(read_file(path, largest_file), format, path.string(), limit);
}

Mesh read_mesh_bytes(std::string_view bytes, MeshFormat format, const std::string& name, const MemoryLimit& limit) {
    assert(bytes.size() <= largest_file);
    switch (format) {
        case MeshFormat::off:
            return read_off(bytes, name, limit);
        case MeshFormat::obj:
            return read_obj(bytes, name, limit);
        case MeshFormat::ply:
            return read_ply(bytes, name, limit);
        case MeshFormat::stl:
            return read_stl(bytes, name, limit);
    }
    assert(false);
    return {};
}

}  // namespace raylab
