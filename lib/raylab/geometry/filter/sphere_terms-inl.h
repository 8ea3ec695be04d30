// This file has no include guard. It is included inside a namespace, behind the function times(number, factor) that the
// formula calls: by sphere_filter.h for one sphere, and by row_spheres-inl.h for four at once and every instruction set
// (see triple_product-inl.h).

// A ray and a sphere: F(t) = a t^2 + 2 b t + c, negative inside, in plain doubles, and bounds on what rounding did to c
// and to the discriminant.
template <class Number>
struct SphereTerms {
    Number b, distance, c, c_error, discriminant, discriminant_error;  // distance is the square of the origin's
};

// Of the ray's direction d and the way f from the sphere's center to its origin; a is d.d.
//
// The discriminant b^2 - a c is a r^2 - |d x f|^2 by Lagrange's identity, which cancels less. Each coordinate of f
// carries one rounding; r r and the squares of d are exact (48 bits). Counting roundings per monomial, with u = 2^-53
// and one to spare in each for the bounds' own rounding:
//   a: 2 (sums)                                      b: f 1, product 1, sums 2: 4 u |f|.|d|, at most 4 u sqrt(a f.f)
//   c: f 2, product 1, sums 2: 5 u f.f, and 2 u |c|: at most 8 u (f.f + r^2)
//   discriminant: a r^2: 2 + 2; |d x f|^2: each coordinate of d x f errs by 3 u s, s = |d_i f_j| + |d_j f_i|, its
//   square by 7 u s^2 with its own rounding, the sum by 9, the difference by 10, and s.s is at most 2 a f.f (Cauchy):
//   12 u a (r^2 + 2 f.f), at most 24 u a (f.f + r^2)
// Products of four floats stay between 2^-596 and 2^519: nothing under- or overflows.
template <class Number>
[[gnu::always_inline]] inline SphereTerms<Number> sphere_terms(Number dx, Number dy, Number dz, Number fx, Number fy,
                                                               Number fz, Number a, Number squared_radius) {
    const Number distance = fx * fx + fy * fy + fz * fz, b = dx * fx + dy * fy + dz * fz;
    const Number x = dy * fz - fy * dz, y = dz * fx - fz * dx, z = dx * fy - fx * dy;  // the moment d x f
    const Number error = times(distance + squared_radius, 8 * 0x1p-53);
    const Number discriminant = a * squared_radius - (x * x + y * y + z * z);
    return {b, distance, distance - squared_radius, error, discriminant, times(a * error, 3)};
}
