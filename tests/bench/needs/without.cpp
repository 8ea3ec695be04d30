#include "without.h"

#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/only_needed.h"
#include "raylab/tracer/picture/picture_accelerator.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/whitted/whitted_stage.h"

using namespace raylab;

namespace {

constexpr EyePictureOptions one_thread{.threads = 1};

struct WithoutRecursion : WhittedModel {
    static constexpr bool recursion = false, media = false;
};
struct WithoutShadowRays : WhittedModel {
    static constexpr bool shadow_rays = false;
};
struct WithoutAnyRay : WithoutRecursion {
    static constexpr bool shadow_rays = false;
};
struct WithoutMedia : WhittedModel {
    static constexpr bool media = false;
};

template <class Model>
Image drawn_by(const NeedlessPicture& picture, const Accelerator& accelerator) {
    const WhittedStage<Model> stage(picture.scene, accelerator, picture.frame(), picture.options);
    return eye_picture_by_tiles(picture.frame(), one_thread,
                                [&](const auto& draw) { stage.trace_tile(NoObserver{}, draw); });
}

// Spheres, a cone and a cylinder on a floor, with changed materials.
template <class Change>
NeedlessPicture still_life(const std::string& feature, const Change& change, WhittedOptions options = {}) {
    Scene scene = read_scene(RAYLAB_SOURCE "/tests/bench/mirror_and_glass.toml");
    scene.image = {160, 120};
    for (Material& material : scene.materials) change(material);
    options = only_needed(scene, options);
    return {feature, std::move(scene), options};
}

void make_diffuse(Material& material) { material.kr = material.kt = 0; }
void make_opaque(Material& material) { material.kt = 0; }

}  // namespace

std::vector<NeedlessPicture> needless_pictures() {
    const WhittedOptions no_shadows{.shadows = WhittedOptions::Shadows::none};
    return {still_life("recursion", make_diffuse),
            still_life(
                "shadow rays", [](Material&) {}, no_shadows),
            still_life("both", make_diffuse, no_shadows), still_life("media", make_opaque),
            still_life("item buffer", [](Material&) {})};
}

[[gnu::noinline]] Image drawn_by_renderer(const NeedlessPicture& picture) {
    const PictureAccelerator accelerator("auto", picture.scene, picture.frame(), picture.options, one_thread.samples);
    return whitted_picture(picture.scene, accelerator.finds(), picture.frame(), picture.options, one_thread);
}

[[gnu::noinline]] Image drawn_without(const NeedlessPicture& picture) {
    const auto accelerator = make_accelerator("auto", picture.scene);
    if (picture.feature == "recursion") return drawn_by<WithoutRecursion>(picture, *accelerator);
    if (picture.feature == "shadow rays") return drawn_by<WithoutShadowRays>(picture, *accelerator);
    if (picture.feature == "both") return drawn_by<WithoutAnyRay>(picture, *accelerator);
    if (picture.feature == "media") return drawn_by<WithoutMedia>(picture, *accelerator);
    return whitted_picture(picture.scene, *accelerator, picture.frame(), picture.options, one_thread);
}
