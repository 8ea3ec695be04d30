#include "stage.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/read_scene.h"

namespace raylab {

Stage set_stage(const std::filesystem::path& scene_file) {
    Stage stage{read_scene(scene_file), "elephant", 0};
    Object object;
    Mesh mesh;
    if (const auto file = demo_mesh(stage.mesh)) {
        mesh = read_mesh(*file);
    } else {
        stage.mesh = "knot";
        mesh = trefoil_knot(0.4, 8);
        // The knot is 4 metres wide, and becomes half a metre, like the elephant.
        object.placement = AffineSteps::scale(Vec3d(0.12)).rounded();
    }
    stage.triangles = mesh.faces.size();
    object.shape = std::make_shared<const Mesh>(std::move(mesh));
    object.path = stage.mesh;
    object.front = object.back = stage.scene.materials.size() - 1;  // the last material of the file is meant for it
    stage.scene.objects.push_back(std::move(object));
    return stage;
}

}  // namespace raylab
