#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// A primitive may lie in many cells of a grid, but a ray need be tested against it once. Three ways to remember that:
// each says of primitive i whether it has been asked about it before, for this ray.

namespace raylab {

/// Remembers nothing.
struct NoMailboxes {
    static constexpr bool met_before(std::size_t) { return false; }
};

/// The id of the last ray it met on every primitive (Arnaldi, Priol and Bouatouch, The Visual Computer 3(2), 1987; Amanatides
/// and Woo, Eurographics 1987). An id has 64 bits: at 10^9 rays a second it comes round after 584 years. It belongs to the
/// caller, so that threads do not share it, and every question is a new ray: what was missed in one range may be hit in another.
class Mailboxes {
public:
    void next_ray(std::size_t primitives) {
        if (last_ray_.size() < primitives) last_ray_.resize(primitives, 0);
        ++ray_;
    }
    bool met_before(std::size_t i) { return std::exchange(last_ray_[i], ray_) == ray_; }
    std::size_t bytes() const { return last_ray_.capacity() * sizeof(std::uint64_t); }

private:
    std::uint64_t ray_ = 0;  // the first is 1
    std::vector<std::uint64_t> last_ray_;
};

/// The last few primitives that one ray has met, each in the place that its number has: a cache. It forgets, which costs a
/// test; it needs no memory a primitive.
class SmallMailbox {
public:
    SmallMailbox() { last_.fill(none); }
    bool met_before(std::size_t i) {
        const auto number = static_cast<std::uint32_t>(i);
        return std::exchange(last_[i % last_.size()], number) == number;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::array<std::uint32_t, 8> last_;
};

}  // namespace raylab
