// This file has no include guard. It is included inside a namespace, behind the three functions of coordinates that the
// formula calls: by triangle_filter.h for the baseline, and by bvh8_locate-inl.h for every instruction set. So each has
// the formula compiled for its own instructions; that of another set could not be inlined (GCC: "target specific option
// mismatch").

// The volumes whose signs tell on which side of a triangle's edges a ray with direction d passes, and the triangle's
// own: d (b x c), d (c x a), d (a x b) and a (b x c). The vertices are seen from the ray's origin.
template <class Coordinates>
[[gnu::always_inline]] inline auto triangle_volumes(const Coordinates& d, const Coordinates& a, const Coordinates& b,
                                                    const Coordinates& c) {
    const Coordinates bc = turned_cross(b, c), turned_d = turned(d);
    return sums_of_coordinates(turned_d * bc, turned_d * turned_cross(c, a), turned_d * turned_cross(a, b),
                               turned(a) * bc);
}
