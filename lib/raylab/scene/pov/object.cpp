#include "raylab/scene/pov/object.h"

#include "raylab/geometry/containment.h"
#include "raylab/scene/pov/area_light.h"
#include "raylab/scene/pov/shape.h"
#include "raylab/scene/pov/texture.h"
#include "raylab/scene/pov/words.h"

namespace raylab::pov {

namespace {

// A path contains names that the scene's author chose; a comment must not go beyond its line.
std::string comment(std::string path) {
    for (char& letter : path)
        if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
    return "// " + path + "\n";
}

bool transmits(const Scene& scene, std::size_t material) { return scene.materials[material].kt > 0; }

// Whether one texture suffices: the inside of a closed opaque surface is invisible from outside, so its front alone
// will do.
bool shows_one_texture(const Object& object, const Scene& scene) {
    if (object.sides == Sides::both) return object.front == object.back;
    return object.sides == Sides::front && is_closed(object.shape) && !is_translucent(object, scene);
}

std::string textures(const Object& object, const Scene& scene) {
    const auto of = [&](std::size_t index) { return texture_on(object, scene.materials[index], index); };
    const std::string unseen = "texture { Unseen }";
    const std::string front = object.sides == Sides::back ? unseen : of(object.front);
    if (shows_one_texture(object, scene)) return "  " + front + "\n";
    return "  " + front + "\n  interior_" + (object.sides == Sides::front ? unseen : of(object.back)) + "\n";
}

std::string shadow_textures(const Object& object) {
    if (object.sides == Sides::both) return "  texture { Opaque }\n";
    const bool front = object.sides == Sides::front;
    return fmt::format("  texture {{ {} }}\n  interior_texture {{ {} }}\n", front ? "Opaque" : "Unseen",
                       front ? "Unseen" : "Opaque");
}

// POV-Ray has one index of refraction for each object: it gets that of the front's material, or that of the back's
// where only the back transmits.
std::string interior(const Object& object, const Scene& scene) {
    const bool by_back = !transmits(scene, object.front) && transmits(scene, object.back);
    return fmt::format("  interior {{ ior {} }}\n", scene.materials[by_back ? object.back : object.front].ior);
}

}  // namespace

std::string declared_textures() {
    return "#declare Unseen = texture { pigment { color rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 } }\n"
           "#declare Opaque = texture { pigment { color rgb 0 } finish { ambient 0 diffuse 0 } }\n";
}

std::string object(const Object& object, const Scene& scene, const std::string& mesh_name) {
    const std::string place = placed_shape(object.shape, object.placement, mesh_name) + "\n";
    const std::string text = comment(object.path) + place + textures(object, scene);
    if (!is_translucent(object, scene)) {
        const bool shines_through = object.sides != Sides::both && !shows_one_texture(object, scene);
        const bool shines =
            is_light(object, scene) && says_area_light(object);  // points of it must not be hidden by it
        return text + (shines_through ? "  interior { ior 1 }\n" : "") + (shines ? "  no_shadow\n}\n" : "}\n");
    }
    return text + interior(object, scene) + "  no_shadow\n}\n" + place + shadow_textures(object) +
           "  no_image no_reflection\n}\n";
}

bool is_translucent(const Object& object, const Scene& scene) {
    return (object.sides != Sides::back && transmits(scene, object.front)) ||
           (object.sides != Sides::front && transmits(scene, object.back));
}

}  // namespace raylab::pov
