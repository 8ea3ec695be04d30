#include "textbook_grid.h"

#include "raylab/accelerator/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace raylab::grids {

namespace {

constexpr double density = 8;
constexpr float infinity = std::numeric_limits<float>::infinity();

class TextbookGrid final : public Accelerator {
public:
    TextbookGrid(const Scene& scene, const TextbookOptions& options);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override;

private:
    using Place = std::array<int, 3>;
    struct Walk {
        std::array<float, 3> next, step;
        Place cell, direction;
    };

    Place place_of(const Vec3f& point) const;
    std::vector<std::uint32_t>& at(const Place& place);
    const std::vector<std::uint32_t>& at(const Place& place) const;
    std::optional<Walk> entered(const Ray& ray) const;
    void count_ray(const Ray& ray) const;
    bool asked_before(std::uint32_t i) const;

    TextbookOptions options_;
    Primitives primitives_;
    Vec3f low_{0}, side_{1};
    Place cells_{1, 1, 1};
    std::vector<std::vector<std::uint32_t>> lists_;
    mutable std::vector<std::uint64_t> mailboxes_;
    mutable std::uint64_t ray_ = 0;
    mutable Vec3f last_origin_{0}, last_direction_{0};
};

}  // namespace

TextbookGrid::TextbookGrid(const Scene& scene, const TextbookOptions& options) : options_(options), primitives_(scene) {
    Box all;
    for (std::size_t i = 0; i < primitives_.size(); ++i) all = unite(all, primitives_.bounds(i).value());
    const Vec3f sides = all.max - all.min;
    const double volume = double{sides.x} * double{sides.y} * double{sides.z};
    const double cell = std::cbrt(volume / (density * static_cast<double>(primitives_.size())));
    low_ = all.min;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        cells_[axis] = std::max(1, static_cast<int>(sides[i] / cell));
        side_[i] = sides[i] / static_cast<float>(cells_[axis]);
    }
    lists_.resize(static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) *
                  static_cast<std::size_t>(cells_[2]));
    mailboxes_.resize(primitives_.size(), 0);
    for (std::uint32_t i = 0; i < primitives_.size(); ++i) {
        const Box box = primitives_.bounds(i).value();
        const Place first = place_of(box.min), last = place_of(box.max);
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x) at({x, y, z}).push_back(i);
    }
}

TextbookGrid::Place TextbookGrid::place_of(const Vec3f& point) const {
    Place place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        place[axis] = std::clamp(static_cast<int>(std::floor((point[i] - low_[i]) / side_[i])), 0, cells_[axis] - 1);
    }
    return place;
}

const std::vector<std::uint32_t>& TextbookGrid::at(const Place& place) const {
    const auto x = static_cast<std::size_t>(place[0]), y = static_cast<std::size_t>(place[1]),
               z = static_cast<std::size_t>(place[2]);
    return lists_[x + static_cast<std::size_t>(cells_[0]) * (y + static_cast<std::size_t>(cells_[1]) * z)];
}

std::vector<std::uint32_t>& TextbookGrid::at(const Place& place) {
    return const_cast<std::vector<std::uint32_t>&>(std::as_const(*this).at(place));
}

std::optional<TextbookGrid::Walk> TextbookGrid::entered(const Ray& ray) const {
    float enter = std::max(0.0f, ray.range.min), leave = ray.range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const float high = low_[axis] + side_[axis] * static_cast<float>(cells_[static_cast<std::size_t>(axis)]);
        const float a = (low_[axis] - ray.origin[axis]) / ray.direction[axis],
                    b = (high - ray.origin[axis]) / ray.direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return std::nullopt;
    Walk walk{};
    walk.cell = place_of(ray.origin + ray.direction * enter);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const float d = ray.direction[i];
        walk.direction[axis] = d < 0 ? -1 : 1;
        const auto ahead = static_cast<float>(walk.cell[axis] + (d > 0 ? 1 : 0));
        walk.next[axis] = d == 0 ? infinity : (low_[i] + ahead * side_[i] - ray.origin[i]) / d;
        walk.step[axis] = d == 0 ? infinity : side_[i] / std::abs(d);
    }
    return walk;
}

void TextbookGrid::count_ray(const Ray& ray) const {
    const bool same_line = ray.origin == last_origin_ && ray.direction == last_direction_;
    last_origin_ = ray.origin;
    last_direction_ = ray.direction;
    if (options_.mailboxes == TextbookOptions::Mailboxes::of_pixels && same_line) return;
    ++ray_;
    if (options_.mailboxes == TextbookOptions::Mailboxes::of_8_bits) ray_ = ray_ % 256 == 0 ? 1 : ray_ % 256;
}

bool TextbookGrid::asked_before(std::uint32_t i) const {
    return options_.mailboxes != TextbookOptions::Mailboxes::none && std::exchange(mailboxes_[i], ray_) == ray_;
}

std::optional<Hit> TextbookGrid::closest(const Ray& ray, Traversal& traversal) const {
    count_ray(ray);
    using Boxes = TextbookOptions::Mailboxes;
    const bool keeps = options_.mailboxes != Boxes::none && options_.mailboxes != Boxes::without_hits;
    std::optional<Hit> best;
    auto walk = entered(ray);
    while (walk) {
        ++traversal.steps;
        const auto axis = static_cast<std::size_t>(std::ranges::min_element(walk->next) - walk->next.begin());
        const auto is_here = [&](const Hit& hit) {
            return options_.hits == TextbookOptions::Hits::anywhere || cast<float>(hit.t) <= walk->next[axis];
        };
        for (const std::uint32_t i : at(walk->cell)) {
            if (asked_before(i)) continue;
            Nearest nearest(ray);
            primitives_.test(i, ray, nearest, traversal);
            const auto hit = nearest.hit();
            if (hit && (keeps || is_here(*hit)) && (!best || hit->t < best->t)) best = hit;
        }
        if (best && is_here(*best)) return best;
        walk->cell[axis] += walk->direction[axis];
        if (walk->cell[axis] < 0 || walk->cell[axis] >= cells_[axis] || walk->next[axis] > ray.range.max) break;
        walk->next[axis] += walk->step[axis];
    }
    return best;
}

std::size_t TextbookGrid::bytes() const {
    std::size_t sum = primitives_.bytes() + mailboxes_.capacity() * sizeof(std::uint64_t);
    for (const auto& list : lists_) sum += sizeof(list) + list.capacity() * sizeof(std::uint32_t);
    return sum;
}

StructureMethod textbook_method(const std::string& name, const TextbookOptions& options) {
    return {name, "float", [options](const Scene& scene) { return std::make_unique<TextbookGrid>(scene, options); }};
}

}  // namespace raylab::grids
