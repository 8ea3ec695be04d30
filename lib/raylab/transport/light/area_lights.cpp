#include "raylab/transport/light/area_lights.h"

#include "raylab/base/error.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

bool emits(const Scene& scene, const Object& object) {
    const auto shines = [&](std::size_t material, Sides hidden) {
        return object.sides != hidden && scene.materials[material].emission != Color(0);
    };
    return shines(object.front, Sides::back) || shines(object.back, Sides::front);
}

// In proportion to watts: the sum of the channels of what leaves both sides.
double power(const LightPiece& piece) {
    const Color sum = piece.front + piece.back;
    const LightShape& shape = piece.turning ? turned_shape(piece, 0) : piece.shape;
    return (sum.r + sum.g + sum.b) * std::visit([](const auto& s) { return s.area(); }, shape);
}

// Calls what(shape, moved) with the piece's shape and with how far it stands from there at a time.
template <class What>
auto at_time(const LightPiece& piece, float time, const What& what) {
    const auto call = [&](const LightShape& any, const Vec3d& moved) {
        return std::visit([&](const auto& shape) { return what(shape, moved); }, any);
    };
    if (piece.turning) [[unlikely]]
        return call(turned_shape(piece, time), Vec3d(0));
    return call(piece.shape, double{time} * piece.velocity);
}

// An eighth of the samples is divided among the lights equally: a weak one may be the only one that is near.
constexpr double equal_share = 0.125;

}  // namespace

AreaLights::AreaLights(const Scene& scene) {
    std::vector<double> object_powers, powers;
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        first_of_.push_back(none);
        if (!emits(scene, object)) continue;
        const auto pieces = light_pieces(scene, number);
        if (!pieces) {
            unsampled_.push_back(object.path);
            continue;
        }
        first_of_.back() = pieces_.size();
        double sum = 0;
        for (const LightPiece& piece : *pieces) {
            pieces_.push_back(piece);
            powers.push_back(power(piece));
            sum += powers.back();
        }
        if (!(sum > 0)) throw Error({scene.source, 0, object.path}, "a light of finite area", "one of no area");
        if (!std::isfinite(sum))
            throw Error({scene.source, 0, object.path}, "a light whose area and emission give a finite power",
                        "one that overflows");
        object_powers.push_back(sum);
    }
    double all = 0;
    for (const double sum : object_powers) all += sum;
    const auto lights = static_cast<double>(object_powers.size());
    double end = 0;
    for (std::size_t i = 0, light = 0; i < pieces_.size(); ++i) {
        if (i > 0 && pieces_[i].primitive.object != pieces_[i - 1].primitive.object) ++light;
        const double share = powers[i] * ((1 - equal_share) / all + equal_share / (lights * object_powers[light]));
        chances_.push_back(share);
        ends_.push_back(end += share);
    }
}

std::optional<LightSample> AreaLights::sample(const Vec3d& from, double choice, const std::array<double, 2>& numbers,
                                              float time) const {
    if (empty()) return std::nullopt;
    const auto found = std::ranges::upper_bound(ends_, choice * ends_.back());
    const auto number = static_cast<std::size_t>(std::min(found, ends_.end() - 1) - ends_.begin());
    const LightPiece& piece = pieces_[number];
    // Seen from a light that moves, it is the lit point that stands elsewhere.
    return at_time(piece, time, [&](const auto& shape, const Vec3d& moved) -> std::optional<LightSample> {
        const Vec3d seen_from = from - moved;
        const auto sampled = shape.sample(seen_from, numbers);
        if (!sampled) return std::nullopt;
        const auto& [point, normal, pdf] = *sampled;
        const Vec3d way = point - seen_from;
        const double distance = glm::length(way);
        const Color& radiance = dot(normal, way) < 0 ? piece.front : piece.back;
        if (radiance == Color(0) || !(pdf > 0 && std::isfinite(pdf)) || !(distance > 0)) return std::nullopt;
        return LightSample{point + moved,          normal,         way / distance, distance, radiance,
                           pdf * chances_[number], piece.primitive};
    });
}

double AreaLights::pdf(const Vec3d& from, Primitive primitive, const Vec3d& point, float time) const {
    if (primitive.object >= first_of_.size() || first_of_[primitive.object] == none) return 0;
    const std::size_t number = first_of_[primitive.object] + primitive.part;
    const LightPiece& piece = pieces_[number];
    const double pdf = at_time(
        piece, time, [&](const auto& shape, const Vec3d& moved) { return shape.pdf(from - moved, point - moved); });
    return std::isfinite(pdf) ? pdf * chances_[number] : 0;
}

}  // namespace raylab
