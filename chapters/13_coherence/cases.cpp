#include "cases.h"

#include "first_hit.h"
#include "z_buffer.h"

#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"

#include <fmt/format.h>

namespace raylab::coherence {

namespace {

constexpr int picture_side = 128;

Scene scene_of(const std::shared_ptr<const Mesh>& mesh, const Camera& camera) {
    Scene scene{.camera = camera, .materials = {{}}};
    scene.objects.push_back({.shape = mesh});
    return scene;
}

/// One mesh and one camera: the triangle that each pixel's ray hits first, exactly.
class Trial {
public:
    explicit Trial(Scene scene)
        : scene_(std::move(scene)),
          frame_(camera_frame(scene_.camera, {picture_side, picture_side})),
          list_(make_accelerator("list", scene_)),
          truth_(first_items(*list_)) {}

    CaseRow fails(const std::string& method, const Items& items, double smallest) const {
        const double wrong = wrong_in(items);
        return {method, fmt::format("fails: another triangle in more than {:g} % of the pixels", smallest), seen(wrong),
                wrong > smallest};
    }
    CaseRow shown(const std::string& method, const Items& items) const {
        return {method, "nothing: shown, not judged", seen(wrong_in(items)), true};
    }
    CaseRow item_buffer_holds() const {
        const double wrong = wrong_in(first_items(ItemBuffer(scene_, frame_, *list_)));
        return {"item buffer, exact", "holds: the ray's triangle in every pixel", seen(wrong), wrong == 0};
    }
    template <Real T>
    Items drawn() const {
        return z_buffer<T>(*std::get<std::shared_ptr<const Mesh>>(scene_.objects[0].shape), frame_);
    }

private:
    static std::string seen(double wrong) {
        return wrong == 0 ? "none differs" : fmt::format("{:.3g} % differ", wrong);
    }

    Items first_items(const Accelerator& structure) const {
        Items items;
        for (int y = 0; y < picture_side; ++y)
            for (int x = 0; x < picture_side; ++x) {
                Traversal traversal;
                const auto hit = structure.closest(eye_ray(frame_, x + 0.5, y + 0.5), traversal);
                items.push_back(hit ? std::optional(hit->primitive.part) : std::nullopt);
            }
        return items;
    }
    double wrong_in(const Items& items) const {
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < truth_.size(); ++i) wrong += items[i] != truth_[i];
        return 100.0 * static_cast<double>(wrong) / static_cast<double>(truth_.size());
    }

    Scene scene_;
    CameraFrame frame_;
    std::unique_ptr<Accelerator> list_;
    Items truth_;
};

std::vector<CaseRow> judged(const Trial& trial, double smallest) {
    return {trial.fails("z-buffer, float", trial.drawn<float>(), smallest),
            trial.shown("z-buffer, double", trial.drawn<double>()), trial.item_buffer_holds()};
}

// Two sheets that intersect in the middle of the picture at a ten-thousandth of a degree, far away.
Scene crossing_sheets() {
    const auto sheet = [](float tilt) -> Triangle { return {{-40, -30, -tilt}, {40, -30, tilt}, {0, 50, 0}}; };
    return scene_of(mesh_of({sheet(0), sheet(1e-3f)}),
                    {.position = {3, 2, 500}, .target = {0, 0, 0}, .projection = Perspective{8}});
}

// A floor that continues below the eye and behind it.
Scene endless_floor() {
    const Vec3f a{-50, 0, -50}, b{50, 0, -50}, c{50, 0, 50}, d{-50, 0, 50};
    return scene_of(mesh_of({{a, b, c}, {a, c, d}}),
                    {.position = {0.3, 1.5, 5}, .target = {0, 0.5, 0}, .projection = Perspective{60}});
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun&) {
    return {
        {"ITEM-EDGE",
         "A ball through a telescope, from ten thousand radii away. Corners are rounded, and so is "
         "the ray: it does not go where a pixel's middle is, not even a double's.",
         [] {
             const Trial trial(*far_ball(3));
             return std::vector{trial.fails("z-buffer, float", trial.drawn<float>(), 0.1),
                                trial.fails("z-buffer, double", trial.drawn<double>(), 0.1), trial.item_buffer_holds()};
         }},
        {"ITEM-DEPTH",
         "Two sheets that cross, nearly in one plane. Which is nearer is a difference of nearly "
         "equal depths.",
         [] { return judged(Trial(crossing_sheets()), 1); }},
        {"ITEM-BEHIND", "A floor below the eye. Some corners lie behind it, where a projection turns things about.",
         [] {
             const Trial trial(endless_floor());
             return std::vector{trial.fails("z-buffer, float", trial.drawn<float>(), 10),
                                trial.fails("z-buffer, double", trial.drawn<double>(), 10), trial.item_buffer_holds()};
         }}};
}

}  // namespace raylab::coherence
