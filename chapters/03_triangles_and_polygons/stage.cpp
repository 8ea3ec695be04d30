#include "stage.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/read_scene.h"

namespace raylab {

Scene scene_with_mesh(const std::filesystem::path& scene_file) {
    Scene scene = read_scene(scene_file);
    Object object;
    Mesh mesh;
    if (const auto file = demo_mesh("elephant")) {
        mesh = read_mesh(*file);
    } else {
        mesh = trefoil_knot(0.4, 8);
        // The knot is 4 metres wide, and becomes half a metre, like the elephant.
        object.placement = AffineSteps::scale(Vec3d(0.12)).rounded();
    }
    object.shape = std::make_shared<const Mesh>(std::move(mesh));
    object.path = "mesh";
    object.front = object.back = scene.materials.size() - 1;  // the last material of the file is meant for it
    scene.objects.push_back(std::move(object));
    return scene;
}

}  // namespace raylab
