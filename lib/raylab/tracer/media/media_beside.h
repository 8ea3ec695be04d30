#pragma once

#include "raylab/tracer/media/media.h"
#include "raylab/tracer/shading/shading_point.h"

namespace raylab {

/// The media on both sides of a transparent surface that a ray has come to in these media. A ray that leaves what it
/// never entered has been inside from the start.
class MediaBeside {
public:
    [[gnu::always_inline]] MediaBeside(const Scene& scene, const ShadingPoint& here, const Media& arrived_in)
        : scene_(scene),
          inside_(here.front || arrived_in.contains(here.at.object) ? Media{} : arrived_in.entered(here.at.object)),
          before_(inside_.is_empty() ? arrived_in : inside_),
          behind_(here.front ? before_.entered(here.at.object) : before_.left(here.at.object)),
          matter_before_(before_.current(scene)),
          matter_behind_(behind_.current(scene)) {}
    MediaBeside(const MediaBeside&) = delete;
    MediaBeside& operator=(const MediaBeside&) = delete;

    const Media& before() const { return before_; }  // where the ray comes from
    const Media& behind() const { return behind_; }

    /// Whether the surface lies inside of a stronger medium.
    bool is_hidden() const { return matter_before_ == matter_behind_; }

    double ior_before() const { return ior_of(matter_before_, scene_); }
    double ior_behind() const { return ior_of(matter_behind_, scene_); }

private:
    const Scene& scene_;
    Media inside_;         // if that was not known
    const Media& before_;  // mostly as the ray has it: copying takes its time
    Media behind_;
    const Object *matter_before_, *matter_behind_;
};

}  // namespace raylab
