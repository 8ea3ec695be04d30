#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// A primitive may lie in many cells of a grid, but a ray needs to be tested against it only once. Here are three ways
// to remember that: each tells whether primitive i has been tested before, for this ray.

namespace raylab {

/// Remembers nothing.
struct NoMailboxes {
    static constexpr bool hit_before(std::size_t) { return false; }
};

/// A mailbox for every primitive holds the id of the last ray that was tested against it (Arnaldi, Priol and Bouatouch,
/// The Visual Computer 3(2), 1987; Amanatides and Woo, Eurographics 1987). An id has 64 bits: at 10^9 rays a second it
/// wraps around after 584 years. The mailboxes belong to the caller, so that threads do not share them. Every query
/// counts as a new ray, because a primitive that is missed in one range may be hit in another.
class Mailboxes {
public:
    void next_ray(std::size_t primitives) {
        if (last_ray_.size() < primitives) last_ray_.resize(primitives, 0);
        ++ray_;
    }
    bool hit_before(std::size_t i) { return std::exchange(last_ray_[i], ray_) == ray_; }
    std::size_t bytes() const { return last_ray_.capacity() * sizeof(std::uint64_t); }

private:
    std::uint64_t ray_ = 0;  // the first ray has the id 1
    std::vector<std::uint64_t> last_ray_;
};

/// A cache of the last few primitives that one ray was tested against; the low bits of a primitive's number choose the
/// place. A primitive that was overwritten costs another test; in return no memory for each primitive is needed.
class SmallMailbox {
public:
    SmallMailbox() { last_.fill(none); }
    bool hit_before(std::size_t i) {
        const auto number = static_cast<std::uint32_t>(i);
        return std::exchange(last_[i % last_.size()], number) == number;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::array<std::uint32_t, 8> last_;
};

}  // namespace raylab
