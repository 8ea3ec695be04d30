#include "raylab/scene/render_model.h"

#include <algorithm>
#include <array>

namespace raylab {

namespace {

constexpr std::array<std::string_view, 4> model_words{"auto", "whitted", "distributed",
                                                      "path"};  // in RenderModel's order

bool spreads(const Material& material) {
    const bool turns_light = material.kr > 0 || material.kt > 0;
    return material.emission != Color(0) || (turns_light && !std::holds_alternative<Sharp>(material.polish));
}

bool moves(const Scene& scene) {
    const auto& shutter = scene.camera.shutter;
    return shutter && shutter->open < shutter->close &&
           std::ranges::any_of(scene.objects, [](const Object& object) { return object.motion.has_value(); });
}

}  // namespace

std::string to_string(RenderModel model) { return std::string(model_words.at(static_cast<std::size_t>(model))); }

std::optional<RenderModel> render_model(std::string_view word) {
    const auto found = std::ranges::find(model_words, word);
    if (found == model_words.end()) return std::nullopt;
    return static_cast<RenderModel>(found - model_words.begin());
}

RenderModel chosen_model(const Scene& scene) {
    if (scene.model != RenderModel::automatic) return scene.model;
    const bool spread = scene.camera.lens || moves(scene) || std::ranges::any_of(scene.materials, spreads);
    return spread ? RenderModel::distributed : RenderModel::whitted;
}

}  // namespace raylab
