#include "shadow_rays.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/tiles.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::shadows {

namespace {

double ulp_at(const Vec3d& p) {
    const float size = cast<float>(largest_coordinate(p));
    return double{std::nextafter(size, std::numeric_limits<float>::infinity())} - size;
}

// A floor in a general position (along an axis every method looks better than it is), a sphere and a faceted one on it,
// a screen that stands on it and a coin slightly above it.
class Stage {
public:
    explicit Stage(const Situation& situation)
        : scale_(situation.scale), eye_(situation.eye), center_(Vec3d{1, 0.7, -0.4} * situation.away) {
        gap_ = std::max(1e-4 * scale_, 12 * ulp_at(center_ + Vec3d(4 * scale_)));
        scene_.materials = {{}};
        add_square({0, 0, 0}, east_ * 4.0, north_ * 4.0);
        scene_.objects.push_back({.shape = Sphere{convert<float>(at(1.2, 0.8, 0.8)), cast<float>(0.8 * scale_)}});
        const Mesh faceted = icosphere(1);
        for (std::size_t face = 0; face < faceted.faces.size(); ++face) {
            const auto [a, b, c] = faceted.triangle(face);
            const auto moved = [&](const Vec3f& v) {
                return convert<float>(at(-1.3, 0.9, 0.6) + convert<double>(v) * (0.6 * scale_));
            };
            scene_.objects.push_back({.shape = Triangle{moved(a), moved(b), moved(c)}});
        }
        add_square(screen_ + up_ * (0.6 + gap_ / scale_), east_ * 0.8, up_ * 0.6);
        add_square(coin_ + up_ * (gap_ / scale_), east_ * 0.4, north_ * 0.4);
    }

    const Scene& scene() const { return scene_; }

    /// A ray that hits anywhere, close to the screen's foot, or between coin and floor; and a light.
    Ray ray(RandomSequence& random) const {
        const double chosen = random.next();
        if (chosen < 0.5) return to_floor(random.between(-3, 3) * east_ + random.between(-3, 3) * north_, random);
        if (chosen < 0.75) {
            const double behind = std::pow(10, random.between(-4, -1));
            return to_floor(screen_ + east_ * random.between(-0.7, 0.7) + north_ * behind, random);
        }
        const Vec3d under = coin_ + east_ * random.between(-0.3, 0.3) + north_ * random.between(-0.3, 0.3);
        return {convert<float>(at(under) + up_ * (gap_ / 2)),
                convert<float>(random.unit_vector_across(up_) * 0.5 - up_)};
    }
    Vec3d light(RandomSequence& random) const {
        return at(east_ * random.between(-2, 2) - north_ * random.between(0.5, 3) + up_ * random.between(0.3, 4));
    }

private:
    Vec3d at(const Vec3d& p) const { return center_ + p * scale_; }
    Vec3d at(double east, double north, double up) const { return at(east_ * east + north_ * north + up_ * up); }

    Ray to_floor(const Vec3d& p, RandomSequence& random) const {
        const Vec3d eye = at(p) + glm::normalize(random.unit_vector_across(up_) + up_ * 1.2 + north_) * (scale_ * eye_);
        const Vec3f origin = convert<float>(eye);
        return {origin, convert<float>(at(p) - convert<double>(origin))};
    }

    void add_square(const Vec3d& middle, const Vec3d& u, const Vec3d& v) {
        const auto corner = [&](double x, double y) { return convert<float>(at(middle + u * x + v * y)); };
        scene_.objects.push_back({.shape = Triangle{corner(-1, -1), corner(1, -1), corner(1, 1)}});
        scene_.objects.push_back({.shape = Triangle{corner(-1, -1), corner(1, 1), corner(-1, 1)}});
    }

    const Vec3d up_ = glm::normalize(Vec3d{1, 3, 2});
    const Vec3d east_ = glm::normalize(cross(up_, Vec3d{0, 0, 1}));
    const Vec3d north_ = cross(east_, up_);
    const Vec3d screen_ = north_ * -1.5, coin_ = east_ * 0.4 + north_ * -0.5;
    double scale_, eye_, gap_ = 0;
    Vec3d center_;
    Scene scene_;
};

/// A question whose answer does not depend on the rounding of a start; absent where the ray misses, the light is behind
/// the surface, or an edge is near.
struct Drawn {
    ShadowQuestion question;
    Shade truth;
};

std::optional<Drawn> drawn(const Stage& stage, const Accelerator& accelerator, const ShadowOracle& oracle,
                           RandomSequence random) {
    constexpr double lowest = 1e-3;  // sine of the light's height angle
    const Ray ray = stage.ray(random);
    Traversal traversal;
    const auto hit = accelerator.closest(ray, traversal);
    if (!hit) return std::nullopt;
    const SurfacePoint at = surface_point(stage.scene(), ray, *hit);
    const Vec3d light = stage.light(random), way = light - at.position;
    if (!(dot(facing(at.normal, convert<double>(ray.direction)), way) > lowest * glm::length(way))) return std::nullopt;
    const ShadowQuestion question{ray, *hit, light};
    const auto truth = oracle.around(question);
    return truth ? std::optional(Drawn{question, *truth}) : std::nullopt;
}

}  // namespace

std::vector<Situation> situations() {
    return {{"a metre", "a scene some metres large, at the origin", 1, 0, 4},
            {"a millimetre", "the same a thousand times smaller", 1e-3, 0, 4},
            {"a kilometre", "the same a thousand times larger", 1e3, 0, 4},
            {"1 km away", "some metres large, a kilometre from the origin", 1, 1e3, 4},
            {"100 km away", "a kilometre large, a hundred kilometres from the origin", 1e3, 1e5, 4},
            {"far eye", "some metres large, at the origin, seen from kilometres away", 1, 0, 4e3}};
}

JudgedWorkload shadow_workload(const Situation& situation, std::size_t questions, const ChapterRun& run) {
    const Stage stage(situation);
    const auto accelerator = make_accelerator("auto", stage.scene());
    const ShadowOracle oracle(stage.scene());
    const std::size_t tries = 4 * questions;
    std::vector<std::optional<Drawn>> all(tries);
    for_each_piece(tries, 500, run.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            all[i] = drawn(stage, *accelerator, oracle, RandomSequence(run.seed, i));
    });
    JudgedWorkload judged{{situation.name, situation.about, {stage.scene()}, {}}, {}};
    for (const auto& one : all) {
        if (!one || judged.truth.size() == questions) continue;
        judged.workload.queries.push_back(one->question);
        judged.truth.push_back(one->truth);
    }
    return judged;
}

WrongShadows wrong_shadows(std::span<const Shade> answers, std::span<const Shade> truth) {
    WrongShadows wrong;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (answers[i] != truth[i]) ++(truth[i] == Shade::lit ? wrong.acne : wrong.lost_contact);
    const double per_million = 1e6 / static_cast<double>(truth.size());
    return {wrong.acne * per_million, wrong.lost_contact * per_million};
}

WrongShadows wrong_shadows(const ShadowMethod& method, const JudgedWorkload& judged) {
    std::vector<Shade> answers(judged.truth.size());
    method.answer(method.prepare(judged.workload.data), judged.workload.data, judged.workload.queries, answers);
    return wrong_shadows(answers, judged.truth);
}

Experiment measure_shadow_rays(const ChapterRun& run) {
    Experiment experiment{
        .question = "shadow_ray", .title = "Is a point lit?", .error_axis = "wrong answers [ppm]", .rows = {}};
    for (const Situation& situation : situations()) {
        const auto judged = shadow_workload(situation, run.sized<std::size_t>(50'000, 4'000), run);
        for (const ShadowMethod& method : shadow_methods(run))
            experiment.rows.push_back(measure(
                method, judged.workload,
                [&](std::span<const Shade> answers) {
                    const auto wrong = wrong_shadows(answers, judged.truth);
                    return Judgement{.error = wrong.all(),
                                     .error_bound = 3e6 / static_cast<double>(answers.size()),
                                     .counts = {{"acne ppm", wrong.acne}, {"lost contact ppm", wrong.lost_contact}}};
                },
                {.repeats = run.sized(5, 3), .shortest = run.timing().shortest}));
    }
    return experiment;
}

}  // namespace raylab::shadows
