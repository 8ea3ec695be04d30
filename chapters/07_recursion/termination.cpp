#include "termination.h"

#include "raylab/base/tiles.h"
#include "raylab/image/compare.h"
#include "raylab/report/finding.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>

#include <mutex>

namespace raylab::recursion {

namespace {

using Reflectance = WhittedOptions::Reflectance;

// A small picture of the chapter's scene, traced repeatedly by one thread.
class Subject {
public:
    Subject(std::string name, const Scene& scene, Reflectance reflectance, ImageSize size)
        : name_(std::move(name)),
          scene_(scene),
          reflectance_(reflectance),
          accelerator_(make_accelerator("auto", scene)),
          frame_(camera_frame(scene.camera, size, scene.source)),
          truth_(traced({.depth = true_depth}).image) {}

    Measurement measured(const std::string& method, const std::string& knob, const WhittedOptions& options) const {
        const auto pixels = truth_.pixels().size();
        const WhittedPicture picture = traced(options);
        const double secondary = static_cast<double>(picture.rays.secondary.cast);
        return {.method = method,
                .number = "double",
                .workload = name_,
                .knob = knob,
                .error = compare(picture.image, truth_).rmse,
                .nanoseconds = time_per_query(pixels, [&] { traced(options); }, {.repeats = 3}),
                .queries = pixels,
                .counts = {{"secondary rays a pixel", secondary / static_cast<double>(pixels)},
                           {"shadow rays a pixel",
                            static_cast<double>(picture.rays.shadow.cast) / static_cast<double>(pixels)}}};
    }

private:
    WhittedPicture traced(WhittedOptions options) const {
        options.reflectance = reflectance_;
        return counted_whitted_picture(scene_, *accelerator_, frame_, options, {.threads = 1});
    }

    std::string name_;
    const Scene& scene_;
    Reflectance reflectance_;
    std::unique_ptr<Accelerator> accelerator_;
    CameraFrame frame_;
    Image truth_;
};

}  // namespace

Experiment measure_termination(const ChapterRun& run) {
    Experiment experiment{.question = "termination",
                          .title = "When may the recursion stop?",
                          .error_axis = "RMSE against depth 15",
                          .rows = {},
                          .answer = answer_within(0.001)};
    const Scene scene = read_scene(run.scene);
    const ImageSize size = run.sized(ImageSize{120, 90}, ImageSize{40, 30});
    for (const auto& [name, reflectance] :
         {std::pair{"constant kr and kt", Reflectance::constant}, std::pair{"by Fresnel", Reflectance::fresnel}}) {
        const Subject subject(name, scene, reflectance, size);
        for (const int depth : {1, 2, 3, 4, 5, 6, 7, 9, 11, 13})
            experiment.rows.push_back(
                subject.measured("fixed depth", fmt::format("depth {}", depth), {.depth = depth}));
        for (const double threshold : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
            experiment.rows.push_back(subject.measured("energy threshold", fmt::format("throughput {:g}", threshold),
                                                       {.depth = true_depth, .threshold = threshold}));
    }
    return experiment;
}

Endings endings(const Scene& scene, const WhittedOptions& options, int threads) {
    const auto accelerator = make_accelerator("auto", scene);
    const CameraFrame frame = camera_frame(scene.camera, {80, 60}, scene.source);
    std::map<Ending, double> counts;
    double rays = 0, branches = 0;
    std::mutex mutex;
    for_each_tile(frame.image.width, frame.image.height, threads, "", [&](Tile tile) {
        std::map<Ending, double> here;
        double cast = 0, ended = 0;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x)
                for (const auto& node :
                     ray_tree(scene, *accelerator, options, eye_ray(frame, x + 0.5, y + 0.5)).nodes) {
                    if (node.kind == RayKind::shadow) continue;
                    const bool cut = node.ended == Ending::depth || node.ended == Ending::threshold ||
                                     node.ended == Ending::total_internal_reflection;
                    cast += !cut;
                    if (node.ended == Ending::branched) continue;
                    ++here[node.ended];
                    ++ended;
                }
        const std::scoped_lock lock(mutex);
        for (const auto& [ending, count] : here) counts[ending] += count;
        rays += cast;
        branches += ended;
    });
    for (auto& [ending, count] : counts) count *= 100 / branches;
    return {counts, rays / (frame.image.width * frame.image.height)};
}

}  // namespace raylab::recursion
