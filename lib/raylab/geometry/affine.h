#pragma once

#include "raylab/geometry/vector.h"

#include <array>

namespace raylab {

/// x -> linear x + translation, in floats. An instance's surface is the *exact* image of its float shape under this
/// map, whatever was rounded when the map itself was composed.
struct Affine {
    std::array<Vec3f, 3> columns{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};  // of the linear part
    Vec3f translation{0, 0, 0};

    // Written out, since it is asked at every hit: most transforms differ from the identity in their first number.
    bool is_identity() const {
        const auto& [x, y, z] = columns;
        return x.x == 1 && y.y == 1 && z.z == 1 && x.y == 0 && x.z == 0 && y.x == 0 && y.z == 0 && z.x == 0 &&
               z.y == 0 && translation == Vec3f{0, 0, 0};
    }
};

/// What the entries of a moving placement gain in a second: every point moves along a straight line at constant speed.
/// In floats, so that where an object stands at a float time has one exact answer.
struct Motion {
    std::array<Vec3f, 3> columns{Vec3f{0, 0, 0}, Vec3f{0, 0, 0}, Vec3f{0, 0, 0}};
    Vec3f translation{0, 0, 0};

    friend bool operator==(const Motion&, const Motion&) = default;
};

/// A list of transforms being composed in double: translate, scale (per axis), rotate (degrees about an axis); a shear
/// is given by its columns. a.then(b) applies a first.
struct AffineSteps {
    std::array<Vec3d, 3> columns{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    Vec3d translation{0, 0, 0};

    static AffineSteps translate(Vec3d by);
    static AffineSteps scale(Vec3d by);
    static AffineSteps rotate(Vec3d axis, double degrees);  // right-handed; Error for a zero axis
    AffineSteps then(const AffineSteps& next) const;

    /// Rounded once to floats: what the scene holds.
    Affine rounded() const;
    static AffineSteps of(const Affine& affine);
};

/// True if the exact determinant of the float map is zero: such a transform is refused.
bool is_singular(const Affine& affine);

Vec3d transform_point(const Affine& affine, const Vec3d& point);
Vec3d transform_vector(const Affine& affine, const Vec3d& vector);

}  // namespace raylab
