#pragma once

#include "raylab/scene/scene.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace raylab {

/// The transparent objects a ray is inside of, in the order it entered them. Where several overlap, the one whose material
/// has the highest priority is what the ray is in, and among equals the one entered last. (Schmidt and Budge: Simple Nested
/// Dielectrics in Ray Traced Images, JGT 7(2), 2002.)
class Media {
public:
    static constexpr std::size_t most = 16;  // deeper nesting is not told apart

    // Copied at every transparent surface: what is there, mostly nothing, and not the room for more.
    Media() {}
    Media(const Media& other) { *this = other; }
    Media& operator=(const Media& other) {
        count_ = other.count_;
        std::copy_n(other.inside_.begin(), count_, inside_.begin());
        return *this;
    }

    Media entered(const Object* object) const {
        Media result = *this;
        if (result.count_ < most) result.inside_[result.count_++] = object;
        return result;
    }

    Media left(const Object* object) const {
        Media result = *this;
        const auto begin = result.inside_.begin(), end = begin + static_cast<std::ptrdiff_t>(count_);
        const auto found = std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(begin), object);
        if (found == std::make_reverse_iterator(begin)) return result;
        std::copy(found.base(), end, found.base() - 1);
        --result.count_;
        return result;
    }

    bool contains(const Object* object) const {
        return std::find(inside_.begin(), inside_.begin() + static_cast<std::ptrdiff_t>(count_), object) !=
               inside_.begin() + static_cast<std::ptrdiff_t>(count_);
    }

    /// The object whose matter the ray is in; null: empty space.
    const Object* current(const Scene& scene) const {
        const Object* best = nullptr;
        for (std::size_t i = 0; i < count_; ++i)
            if (!best || priority(scene, inside_[i]) >= priority(scene, best)) best = inside_[i];
        return best;
    }

    double ior(const Scene& scene) const {
        const Object* object = current(scene);
        return object ? scene.materials[object->front].ior : 1;
    }

private:
    static int priority(const Scene& scene, const Object* object) { return scene.materials[object->front].priority; }

    std::array<const Object*, most> inside_;  // the first count_
    std::size_t count_ = 0;
};

}  // namespace raylab
