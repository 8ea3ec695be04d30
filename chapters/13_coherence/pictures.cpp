#include "pictures.h"

#include "first_hit.h"
#include "z_buffer.h"

#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/sampling/random.h"
#include "raylab/tracer/picture/first_hit_picture.h"
#include "raylab/tracer/picture/picture_accelerator.h"
#include "raylab/tracer/picture/whitted_picture.h"

namespace raylab::coherence {

namespace {

CameraFrame frame_of(const Scene& scene, const ChapterRun& run) {
    const int part = run.sized(1, 8);
    return camera_frame(scene.camera, {scene.image.width / part, scene.image.height / part}, scene.source);
}

Image traced(const Scene& scene, const ChapterRun& run, BufferUse use) {
    const CameraFrame frame = frame_of(scene, run);
    const EyePictureOptions options = chapter_rays(run);
    const WhittedOptions recursion{.depth = 32, .threshold = 1.0 / 256};  // where `raylab render` ends it here
    const PictureAccelerator accelerator("auto", scene, frame, recursion, options.samples, use);
    return whitted_picture(scene, accelerator.finds(), frame, recursion, options);
}

Color color_of(Primitive primitive) {
    const auto random = [&](std::uint64_t channel) {
        return 0.15 + 0.8 * random_number({7, primitive.object, primitive.part, channel});
    };
    return {random(0), random(1), random(2)};
}

}  // namespace

Image by_item_buffer(const Scene& scene, const ChapterRun& run) { return traced(scene, run, BufferUse::always); }

std::vector<std::string> other_pixels_header() { return {"picture", "pixels", "other than by a tree alone"}; }

std::vector<std::vector<std::string>> other_pixels_rows(const Scene& scene, const ChapterRun& run) {
    const Image picture = by_item_buffer(scene, run), by_tree = traced(scene, run, BufferUse::never);
    std::size_t other = 0;
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) other += !(picture.pixels()[i] == by_tree.pixels()[i]);
    return {{"colonnade", std::to_string(picture.pixels().size()), std::to_string(other)}};
}

Image items(const Scene& scene, const ChapterRun& run) {
    const CameraFrame frame = frame_of(scene, run);
    const auto behind = make_accelerator("list", scene);
    const ItemBuffer buffer(scene, frame, *behind);
    return eye_picture(frame, {.threads = run.threads}, [&](const Ray& ray) {
        Traversal traversal;
        const auto hit = buffer.closest(ray, traversal);
        return hit ? color_of(hit->primitive) : Color{0.95, 0.95, 0.95};
    });
}

Image items_kept(const Scene& scene, const ChapterRun& run) {
    const CameraFrame frame = frame_of(scene, run);
    const auto behind = make_accelerator("list", scene);
    const ItemBuffer buffer(scene, frame, *behind);
    CostMap map{frame.image.width, frame.image.height};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) map.costs.push_back(static_cast<double>(buffer.items(x, y).value_or(0)));
    return heat_map(map, "items a pixel");
}

Image wrong_items(const ChapterRun& run) {
    const auto scene = far_ball(run.sized(4, 2));
    const int side = run.sized(320, 120);
    Camera camera = scene->camera;
    camera.projection = Perspective{0.0065};  // the ball fills the picture
    const CameraFrame frame = camera_frame(camera, {side, side});
    const auto tree = make_accelerator("bvh", *scene);
    Image image = first_hit_picture(*scene, *tree, frame, FirstHitShading::light, {.threads = run.threads});
    const Items drawn = z_buffer<float>(*std::get<std::shared_ptr<const Mesh>>(scene->objects[0].shape), frame);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            Traversal traversal;
            const auto hit = tree->closest(eye_ray(frame, x + 0.5, y + 0.5), traversal);
            const auto& item = drawn[static_cast<std::size_t>(y * side + x)];
            const bool same = item.has_value() == hit.has_value() && (!item || *item == hit->primitive.part);
            if (!same) image.at(x, y) = {0.9f, 0.05f, 0.02f};
        }
    return enlarged(image, 2);  // one pixel of the wrong ones is hard to see
}

}  // namespace raylab::coherence
