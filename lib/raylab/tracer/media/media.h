#pragma once

#include "raylab/scene/scene.h"

#include <array>
#include <cstddef>

namespace raylab {

/// The transparent objects a ray is inside of, in the order it entered them. Where several overlap, the one whose
/// material has the highest priority is what the ray is in, and among equals the one entered last. (Schmidt and Budge:
/// Simple Nested Dielectrics in Ray Traced Images, JGT 7(2), 2002.)
class Media {
public:
    static constexpr std::size_t largest = 16;  // deeper nesting is not told apart

    // Copied at every transparent surface: what is there, mostly one or none, and not the room for more.
    Media() { inside_[0] = nullptr; }
    Media(const Media& other) { *this = other; }
    Media& operator=(const Media& other) {
        count_ = other.count_;
        inside_[0] = other.inside_[0];
        for (std::size_t i = 1; i < count_; ++i) inside_[i] = other.inside_[i];
        return *this;
    }

    Media entered(const Object* object) const {
        Media result = *this;
        if (result.count_ < largest) result.inside_[result.count_++] = object;
        return result;
    }

    Media left(const Object* object) const {
        Media result = *this;
        const std::size_t end = end_of(object);
        if (end == 0) return result;
        for (std::size_t i = end; i < count_; ++i) result.inside_[i - 1] = inside_[i];
        --result.count_;
        return result;
    }

    bool is_empty() const { return count_ == 0; }
    bool contains(const Object* object) const { return end_of(object) != 0; }

    /// The object whose matter the ray is in; null: empty space.
    const Object* current(const Scene& scene) const {
        const Object* best = count_ > 0 ? inside_[0] : nullptr;
        for (std::size_t i = 1; i < count_; ++i)
            if (priority(scene, inside_[i]) >= priority(scene, best)) best = inside_[i];
        return best;
    }

private:
    // The number of objects up to where this one was entered last; 0: it is not there.
    std::size_t end_of(const Object* object) const {
        std::size_t end = count_;
        while (end > 0 && inside_[end - 1] != object) --end;
        return end;
    }

    static int priority(const Scene& scene, const Object* object) { return scene.materials[object->front].priority; }

    std::array<const Object*, largest> inside_;  // the first count_
    std::size_t count_ = 0;
};

/// The index of refraction of what Media::current() says a ray is in.
inline double ior_of(const Object* current, const Scene& scene) {
    return current ? scene.materials[current->front].ior : 1;
}

}  // namespace raylab
