#include "alike.h"

#include "catch.h"
#include "povray.h"

#include "raylab/tracer/picture/whitted_picture.h"

using namespace raylab;

void check_alike(Scene scene, int depth, const SamePicture& same) {
    scene.model = RenderModel::whitted;  // in the others, POV-Ray's picture has area lights and a lens
    const auto theirs = povray_picture(scene, {.depth = depth});
    if (!theirs) return;
    const auto accelerator = make_accelerator("bvh", scene);
    const Image ours = whitted_picture(scene, *accelerator, camera_frame(scene.camera, scene.image), {.depth = depth});
    for (const auto& objection : objections(compare(*theirs, ours, same), same)) FAIL_CHECK(objection);
}
