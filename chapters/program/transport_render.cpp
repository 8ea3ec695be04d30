#include "transport_render.h"

#include "ray_counts.h"
#include "sampling_progress.h"
#include "transport_words.h"

#include "raylab/base/error.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/sampled_files.h"
#include "raylab/image/picture_name.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/memory_need.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/render_model.h"
#include "raylab/transport/path/expected_error.h"
#include "raylab/transport/path/transport_picture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

nlohmann::ordered_json to_json(const AskedScene& asked, const SampledImage& image, const TransportCounts& counts,
                               double expected_error, double build_seconds) {
    nlohmann::ordered_json json{{"model", to_string(asked.scene.model)},
                                {"expected_error", expected_error},
                                {"summands", image.at(0, 0).count}};
    json.update(to_json(counts.rays, counts.traversal));
    json.update({{"seconds", counts.seconds}, {"build_seconds", build_seconds}});
    return json;
}

std::string summary(const TransportCounts& counts) {
    const auto& rays = counts.rays;
    return fmt::format("{} eye rays, {} shadow rays, {} others in {:.3g} s: {:.4g} rays a second\n", rays.primary.cast,
                       rays.shadow.cast, rays.secondary.cast, counts.seconds, rate(all_cast(rays), counts.seconds));
}

std::string joined(const std::vector<std::string>& words) {
    return "raylab render " + fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

ExitCode render_transport(const Arguments& arguments, const AskedScene& asked, const std::vector<std::string>& words,
                          Outputs& outputs) {
    const Scene& scene = asked.scene;
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    refuse_whitted_words(arguments);
    const AskedTransport how = asked_transport(arguments, scene);
    check_memory(picture_need(scene, scene.image), asked.limit, {scene.source});
    SamplingProgress progress(how, identity(how, scene), scene.image);
    if (arguments.has("--resume")) {
        if (!output || std::filesystem::path(*output).extension() != ".exr")
            throw Error("expected --resume with -o FILE.exr, which keeps the sums, found another output");
        if (std::filesystem::exists(*output)) progress.go_on_from(read_sampled(*output, asked.limit), *output);
    }

    const auto begun = std::chrono::steady_clock::now();
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    const double rays = 1.0 * scene.image.width * scene.image.height * how.sampler.count;
    const std::string chosen = chosen_accelerator(arguments.text("--accelerator"), scene, rays);
    const auto accelerator = make_accelerator(chosen, scene, {.threads = threads_of(arguments)});
    const TransportPicture picture(scene, *accelerator, frame, how.options, how.filter);
    const double build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();

    const auto store = [&] {
        if (std::filesystem::path(*output).extension() == ".exr")
            write_sampled({progress.image(), progress.texts(joined(words))}, outputs[*output]);
        else
            write_image(progress.image().mean(), outputs[*output]);
        outputs.commit();
    };
    const bool is_adaptive = how.spending == AskedTransport::Spending::adaptive;
    const bool keeps_sums = output && std::filesystem::path(*output).extension() == ".exr";
    const bool on_the_way = output && outputs.replaces(*output);
    const SamplingProgress::Storing storing{on_the_way ? std::function<void()>(store) : nullptr,
                                            keeps_sums && !is_adaptive ? "; --resume goes on with them" : ""};
    const TransportCounts counts = is_adaptive ? progress.run_adaptively(picture, threads_of(arguments), storing)
                                               : progress.run(picture, threads_of(arguments), storing);
    if (output) store();

    const double error = progress.image().relative_error();
    if (json) write_json(json_text(to_json(asked, progress.image(), counts, error, build_seconds)), outputs[*json]);
    if (json != "-") {
        for (const auto& path : picture.unsampled())
            outputs.say(path + " emits, and only rays that hit it by chance find its light\n");
        outputs.say(summary(counts) + progress.words() + "\n" + choice_words(arguments, scene, chosen));
    }
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
