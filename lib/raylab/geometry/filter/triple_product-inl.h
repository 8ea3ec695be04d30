// This file has no include guard. It is included inside a namespace: by triangle_filter.h for the baseline, where
// coordinates are numbers, and by bvh8_locate-inl.h for every instruction set, where they are of three edges side by
// side. So each has the formula compiled for its own instructions; that of another set could not be inlined (GCC:
// "target specific option mismatch"). The bits are the same.

// d (p x q).
template <class Coordinates>
[[gnu::always_inline]] inline auto triple_product(const Coordinates& d, const Coordinates& p, const Coordinates& q) {
    return d.x * (p.y * q.z - q.y * p.z) + d.y * (p.z * q.x - q.z * p.x) + d.z * (p.x * q.y - q.x * p.y);
}
