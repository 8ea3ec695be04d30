#include "raylab/scene/toml/read_toml.h"

#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/group.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/mesh_builder.h"
#include "raylab/scene/toml/documents.h"
#include "raylab/scene/toml/names.h"
#include "raylab/scene/toml/read_parts.h"
#include "raylab/scene/toml/scene_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace raylab::toml_file {

namespace {

namespace fs = std::filesystem;

class Reader {
public:
    explicit Reader(const MemoryLimit& limit) : limit_(limit) {}

    Scene read(const std::vector<Document>& documents) {
        scene_.source = documents.back().file;  // a file comes after those it includes, so this is the scene file
        for (const auto& document : documents) {
            if (document.path != documents.back().path) scene_.files_read.push_back(document.path);
            read_once(document);
        }
        for (const auto& document : documents) read_names(document);
        for (const auto& document : documents) read_objects(document);
        check_camera();
        check_ends();
        scene_.objects = flatten(groups_, top_, scene_.camera.shutter, limit_);
        if (plain_is_used_) scene_.materials.push_back({.name = "plain grey"});
        return std::move(scene_);
    }

private:
    static Node root(const Document& document) { return {document.root, scene_format(), document.file}; }

    // The parts that a scene has once, whichever of its files gives them.
    void read_once(const Document& document) {
        const auto node = root(document);
        for (const auto* key : {"render", "image", "camera", "background"})
            if (node.has(key)) parts_.add(key, node.place(key));
        if (node.has("render")) scene_.model = read_model(node.table("render"));
        if (node.has("image")) scene_.image = read_image(node.table("image"));
        if (node.has("camera")) scene_.camera = read_camera(node.table("camera"));
        if (node.has("camera") || camera_place_.empty()) camera_place_ = to_string(node.place("camera"));
        if (node.has("background")) scene_.background = read_background(node.table("background"));
    }

    // Materials and groups may be used before they are defined, so their names come first.
    void read_names(const Document& document) {
        const auto node = root(document);
        for (const auto& [name, material] : node.named("material")) {
            materials_.add(name, material.place());
            scene_.materials.push_back(read_material(material, name));
        }
        for (const auto& [name, group] : node.named("group")) {
            group_names_.add(name, group.place());
            groups_.push_back({.name = name});
        }
    }

    void read_objects(const Document& document) {
        const auto node = root(document);
        for (const auto& light : node.tables("light")) scene_.lights.push_back(read_light(light));
        for (const auto& [name, group] : node.named("group"))
            add_members(groups_[group_names_.find(name, group.place())], group, "shapes", "instances", document.path);
        add_members(top_, node, "shape", "instance", document.path);
    }

    void add_members(Group& group, const Node& node, const char* shapes, const char* instances, const fs::path& path) {
        struct Member {
            int line;
            std::variant<GroupShape, Instance> value;
        };
        std::vector<Member> members;
        for (const auto& shape : node.tables(shapes)) members.push_back({shape.place().line, read_member(shape, path)});
        for (const auto& instance : node.tables(instances))
            members.push_back({instance.place().line, read_instance(instance)});
        std::ranges::stable_sort(members, {}, &Member::line);
        for (auto& member : members) group.members.push_back(std::move(member.value));
    }

    GroupShape read_member(const Node& node, const fs::path& path) {
        Object object;
        if (node.tag() == "mesh") {
            object.shading = read_shading(node);
            object.shape = mesh(node, path);
        } else {
            object.shape = read_shape(node);
        }
        read_materials(node, object);
        if (node.text("sides") != "both") object.sides = node.text("sides") == "front" ? Sides::front : Sides::back;
        return {.kind = node.tag(),
                .object = std::move(object),
                .steps = read_transform(node),
                .motion = read_motion(node),
                .end = read_end(node),
                .place = node.place(node.has("transform_end") ? "transform_end" : "transform")};
    }

    Instance read_instance(const Node& node) {
        return {.group = group_names_.find(node.text("of"), node.place("of")),
                .steps = read_transform(node),
                .motion = read_motion(node),
                .end = read_end(node),
                .place = node.place()};
    }

    static std::optional<Vec3d> read_motion(const Node& node) {
        if (!node.has("motion")) return std::nullopt;
        return node.vector("motion");
    }

    std::optional<AffineSteps> read_end(const Node& node) {
        if (!node.has("transform_end")) return std::nullopt;
        if (node.has("motion")) throw Error(node.place("transform_end"), "motion or transform_end", "both");
        if (!first_end_) first_end_ = node.place("transform_end");
        return read_transform(node, "transform_end");
    }

    // At time 0 things stand where the file has them, so they need time to get elsewhere.
    void check_ends() const {
        const auto& shutter = scene_.camera.shutter;
        if (first_end_ && shutter && shutter->close == 0)
            throw Error(*first_end_, "a shutter that closes at another time than 0, at which `transform` holds",
                        fmt::format("[{}, {}]", shutter->open, shutter->close));
    }

    void read_materials(const Node& node, Object& object) {
        const auto find = [&](const Node& table, const char* key) {
            return materials_.find(table.text(key), table.place(key));
        };
        if (!node.has("material")) {
            object.front = object.back = materials_.size();  // after all named materials
            plain_is_used_ = true;
        } else if (std::holds_alternative<std::string>(node.value("material").data)) {
            object.front = object.back = find(node, "material");
        } else {
            const auto sides = node.choice("material");
            object.front = find(sides, "front");
            object.back = find(sides, "back");
        }
    }

    Shape mesh(const Node& node, const fs::path& scene_path) {
        const auto path = scene_path.parent_path() / node.text("file");
        std::error_code problem;
        if (!fs::is_regular_file(path, problem))
            throw Error(node.place("file"), "a mesh file", "none at \"" + path.string() + '"');
        const auto file = fs::weakly_canonical(path, problem);
        auto& mesh = meshes_[file];
        if (!mesh) {
            mesh = std::make_shared<const Mesh>(read_mesh(path, limit_));
            limit_ = what_is_left(limit_, bytes_of(*mesh));
            scene_.files_read.push_back(path);
        }
        if (!node.has("shading") || !mesh->normals.empty() || read_shading(node) == Shading::flat) return mesh;
        auto& smooth = smooth_meshes_[file];
        if (!smooth) smooth = std::make_shared<const Mesh>(with_vertex_normals(*mesh));
        return smooth;
    }

    static Shading read_shading(const Node& node) {
        if (!node.has("shading")) return Shading::phong;
        const auto& word = node.text("shading");
        return word == "flat" ? Shading::flat : word == "gouraud" ? Shading::gouraud : Shading::phong;
    }

    void check_camera() const { camera_frame(scene_.camera, scene_.image, camera_place_); }

    MemoryLimit limit_;  // what is left of the limit
    Scene scene_;
    std::string camera_place_;
    std::optional<Place> first_end_;  // where the files say first that something moves so
    Names parts_{"part of a scene"};
    Names materials_{"material"};
    Names group_names_{"group"};
    std::vector<Group> groups_;
    Group top_;
    std::map<fs::path, std::shared_ptr<const Mesh>> meshes_;
    std::map<fs::path, std::shared_ptr<const Mesh>> smooth_meshes_;  // those whose normals had to be computed
    bool plain_is_used_ = false;
};

}  // namespace

Scene read(std::string_view text, const fs::path& path, const MemoryLimit& limit) {
    return Reader(limit).read(load_documents(text, path, limit));
}

}  // namespace raylab::toml_file
