#include "without.h"

#include "raylab/scene/read_scene.h"
#include "raylab/transport/path/transport_stage.h"

using namespace raylab;

namespace {

constexpr Sampler sampler{.kind = SamplerKind::sobol, .count = 4, .seed = 1};

struct WithoutLens : TransportModel {
    static constexpr bool lens = false;
};
struct WithoutTime : TransportModel {
    static constexpr bool time = false;
};
struct WithoutAreaLights : TransportModel {
    static constexpr bool area_lights = false;
};

// The kinds of lobes are fewer, too.
struct WithoutGloss : TransportModel {
    using Lobes = LobesOf<std::variant<DiffuseLobe>, 1>;

    static Lobes lobes(const Material& material, const Color& diffuse, const Vec3d& wo, const Interface& interface,
                       FacetShares shares) {
        return sharp_lobes<Lobes>(material, diffuse, wo, interface, shares);
    }
};

struct WithoutAll : WithoutGloss {
    static constexpr bool lens = false, time = false, area_lights = false;
};

NeedlessSpread still_life(const std::string& feature, Followed followed) {
    Scene scene = read_scene(RAYLAB_SOURCE "/tests/bench/mirror_and_glass.toml");
    scene.image = {120, 90};
    for (Material& material : scene.materials) material.emission = Color(0);
    return {feature, std::move(scene), {.followed = followed, .depth = 5}};
}

template <class Model>
Image drawn_by(const NeedlessSpread& picture, const Accelerator& accelerator) {
    const CameraFrame frame = camera_frame(picture.scene.camera, picture.scene.image);
    const TransportStage<Model> stage(picture.scene, accelerator, frame, picture.options, PixelFilter::box);
    SampledImage image(frame.image.width, frame.image.height);
    const auto all = [](int, int) { return SamplesOfPixel{{0, sampler.count}, sampler.count}; };
    stage.add(image, sampler, all, Summand::sample, 1, {});
    return image.mean();
}

}  // namespace

// "nothing" is a control: the same model, compiled once more.
std::vector<NeedlessSpread> needless_spreads() {
    return {still_life("nothing", Followed::sharp_and_glossy),
            still_life("lens", Followed::sharp_and_glossy),
            still_life("time", Followed::sharp_and_glossy),
            still_life("gloss", Followed::sharp_and_glossy),
            still_life("area lights", Followed::sharp_and_glossy),
            still_life("all of these", Followed::sharp_and_glossy),
            still_life("all, by paths", Followed::all)};
}

[[gnu::noinline]] Image drawn_by_renderer(const NeedlessSpread& picture) {
    const auto accelerator = make_accelerator("auto", picture.scene);
    const CameraFrame frame = camera_frame(picture.scene.camera, picture.scene.image);
    const TransportPicture spread(picture.scene, *accelerator, frame, picture.options);
    SampledImage image(frame.image.width, frame.image.height);
    spread.add(image, sampler, {0, sampler.count}, Summand::sample, 1);
    return image.mean();
}

[[gnu::noinline]] Image drawn_without(const NeedlessSpread& picture) {
    const auto accelerator = make_accelerator("auto", picture.scene);
    if (picture.feature == "nothing") return drawn_by<TransportModel>(picture, *accelerator);
    if (picture.feature == "lens") return drawn_by<WithoutLens>(picture, *accelerator);
    if (picture.feature == "time") return drawn_by<WithoutTime>(picture, *accelerator);
    if (picture.feature == "gloss") return drawn_by<WithoutGloss>(picture, *accelerator);
    if (picture.feature == "area lights") return drawn_by<WithoutAreaLights>(picture, *accelerator);
    return drawn_by<WithoutAll>(picture, *accelerator);
}
