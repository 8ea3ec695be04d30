#include "raylab/scene/pov/write_pov.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/background.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/pov/area_light.h"
#include "raylab/scene/pov/light.h"
#include "raylab/scene/pov/object.h"
#include "raylab/scene/pov/shape.h"
#include "raylab/scene/pov/texture.h"
#include "raylab/scene/pov/words.h"
#include "raylab/scene/render_model.h"

#include <map>
#include <set>

namespace raylab {

namespace {

using pov::vector;

std::string head(const Scene& scene) {
    std::string text = "// Written by raylab export. To render it:\n";
    text +=
        fmt::format("//   povray +Iscene.pov +Oscene.exr +FE +W{} +H{} -D -A\n", scene.image.width, scene.image.height);
    for (const auto& difference : pov_differences(scene)) text += "// " + difference + "\n";
    return text + "#version 3.7;\n";
}

// POV-Ray's gradient runs from 0 to 1 and begins again, so this one begins at the nadir: the horizon is at a half. What
// is curved between horizon and zenith consists of so many pieces that they are seen in no picture of 8 bits.
std::string background(const Background& background) {
    const std::string color = "color rgb " + vector(background.color);
    if (!background.zenith) return "background { " + color + " }\n";
    constexpr int pieces = 32;
    std::string map = "[0 " + color + "]";
    for (int i = 0; i <= pieces; ++i) {
        const double rise = 1.0 * i / pieces;
        map += fmt::format(" [{} color rgb {}]", (1 + rise) / 2,
                           vector(sky_color(background.color, *background.zenith, rise)));
    }
    return "sky_sphere { pigment { gradient y color_map { " + map + " } scale 2 translate -y } }\n";
}

std::string global_settings(const Scene& scene, const PovOptions& options) {
    return fmt::format("global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout {} ambient_light rgb {} }}\n",
                       options.depth, options.adc_bailout, vector(scene.background.ambient)) +
           background(scene.background);
}

// POV-Ray's aperture is four times the radius of its lens. With variance 0 it traces all of the rays.
std::string lens(const Scene& scene, const CameraFrame& frame, int samples) {
    const auto& lens = scene.camera.lens;
    if (!lens || !(lens->radius > 0) || chosen_model(scene) == RenderModel::whitted) return "";
    return fmt::format("\n  aperture {} blur_samples {} confidence 0.999 variance 0\n  focal_point ", 4 * lens->radius,
                       samples) +
           vector(frame.eye + lens->focus * frame.forward);
}

// POV-Ray is left-handed only in its camera's default `right`: with right, up and direction given as they are in the
// scene, coordinates need no mirroring.
std::string camera(const Scene& scene, const PovOptions& options) {
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    const bool parallel = frame.projection == CameraFrame::Projection::orthographic;
    return std::string("camera {\n  ") + (parallel ? "orthographic" : "perspective") + "\n  location " +
           vector(frame.eye) + "\n  direction " + vector(frame.forward) + "\n  right " +
           vector(2 * frame.half_width * frame.right) + "\n  up " + vector(2 * frame.half_height * frame.up) +
           lens(scene, frame, options.samples) + "\n}\n";
}

// Each mesh is declared once, however many objects share it.
class Meshes {
public:
    explicit Meshes(const Scene& scene) {
        for (const auto& object : scene.objects)
            if (object.sides != Sides::both) one_sided_.insert(as_mesh(object.shape));
        for (const auto& object : scene.objects)
            if (const Mesh* mesh = as_mesh(object.shape)) declare(*mesh);
    }

    const std::string& text() const { return text_; }
    std::string name(const Shape& shape) const {
        const Mesh* mesh = as_mesh(shape);
        return mesh ? names_.at(mesh) : "";
    }

private:
    void declare(const Mesh& mesh) {
        const auto [entry, is_new] = names_.try_emplace(&mesh, fmt::format("Mesh_{}", names_.size()));
        const auto shadow = one_sided_.contains(&mesh) ? pov::MeshShadow::by_texture : pov::MeshShadow::opaque;
        if (is_new) text_ += "#declare " + entry->second + " = " + pov::mesh(mesh, shadow) + "\n";
    }

    std::set<const Mesh*> one_sided_;  // meshes of which some object shows one side only
    std::map<const Mesh*, std::string> names_;
    std::string text_;
};

}  // namespace

std::string to_pov(const Scene& scene, const PovOptions& options) {
    std::string text = head(scene) + global_settings(scene, options) + camera(scene, options);
    for (const auto& light : scene.lights) text += pov::light(light, scene.camera);
    for (const auto& object : scene.objects) text += pov::area_light(object, scene, options.samples);
    text += pov::declared_textures();
    for (std::size_t i = 0; i < scene.materials.size(); ++i) text += pov::declared_material(scene.materials[i], i);
    const Meshes meshes(scene);
    text += meshes.text();
    for (const auto& object : scene.objects) text += pov::object(object, scene, meshes.name(object.shape));
    return text;
}

}  // namespace raylab
