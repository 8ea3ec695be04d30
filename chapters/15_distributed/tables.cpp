#include "tables.h"

#include "spread_picture.h"

#include "raylab/experiment/sampler_error/sampler_error.h"
#include "raylab/radiosity/radiosity_picture.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

namespace raylab::spread {

std::vector<std::string> slope_header() {
    return {"sampler", "smooth", "edge at all angles", "edge along an axis", "RMSE, 256 samples, smooth"};
}

std::vector<std::vector<std::string>> slope_rows(const ChapterRun& run) {
    const int seeds = run.sized(200, 20);
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : sampler_names()) {
        const SamplerKind kind = sampler_kind(name);
        const auto slope = [&](const SquareIntegrand& integrand) {
            return fmt::format("{:.2f}", sampler_slope(kind, integrand, seeds));
        };
        rows.push_back({name, slope(smooth_integrand()), slope(disc_integrand()), slope(step_integrand()),
                        fmt::format("{:.1e}", sampler_rmse(kind, 256, smooth_integrand(), seeds))});
    }
    return rows;
}

namespace {

// The mean of the pixels in which neither picture shows the light: its edge is a matter of the pixel's samples.
Color mean_beside_light(const Image& image, const Image& other) {
    constexpr float light = 1;  // nothing else is so bright
    Color sum(0);
    int pixels = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Pixel& pixel = image.pixels()[i];
        if (pixel.r > light || other.pixels()[i].r > light) continue;
        sum += Color(pixel.r, pixel.g, pixel.b);
        ++pixels;
    }
    return sum / static_cast<double>(pixels);
}

}  // namespace

std::vector<std::string> box_header() { return {"by", "red", "green", "blue", "green against paths"}; }

std::vector<std::vector<std::string>> box_rows(const ChapterRun& run) {
    const Scene scene = read_scene(source_folder() / "chapters/14_radiosity/scene.toml");
    const ImageSize size = run.sized(ImageSize{120, 120}, ImageSize{24, 24});
    const Image by_paths =
        spread_picture(scene, size, {.sampler = {SamplerKind::sobol, run.sized(64, 4)}, .options = paths()}, run);
    const auto row = [&](const std::string& name, const Image& image) {
        const Color mean = mean_beside_light(image, by_paths), truth = mean_beside_light(by_paths, image);
        return std::vector<std::string>{name, fmt::format("{:.4f}", mean.r), fmt::format("{:.4f}", mean.g),
                                        fmt::format("{:.4f}", mean.b),
                                        fmt::format("{:+.1f} %", 100 * (mean.g / truth.g - 1))};
    };
    std::vector<std::vector<std::string>> rows{row("paths, 64 a pixel", by_paths)};
    for (const std::size_t patches : run.sized<std::vector<std::size_t>>({150, 600, 2500}, {150})) {
        const SceneRadiosity solved =
            scene_radiosity(scene, {.patches = patches, .form_factors = {.threads = run.threads}});
        const Image image =
            radiosity_picture(solved.view(), camera_frame(scene.camera, size), RadiosityShading::vertices,
                              {.samples = {.per_side = 4}, .threads = run.threads});
        rows.push_back(row(fmt::format("radiosity, {} patches", patches), image));
    }
    return rows;
}

}  // namespace raylab::spread
