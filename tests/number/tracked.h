#pragma once

#include "raylab/experiment/adversarial/adversarial.h"

#include <gmpxx.h>

#include <cmath>

// Random expressions, computed exactly and as enclosures.

namespace raylab::tracked {

/// A number and an enclosure that must hold it, however it was computed.
template <class E>
struct Tracked {
    mpq_class exact;
    E enclosure;
};

template <class E>
class Leaves : public adversarial::Draw {
public:
    Leaves() : Draw(1) {}
    explicit Leaves(int exponent_limit) : Draw(1), lowest_(-exponent_limit), highest_(exponent_limit) {}

    // Any double a product of floats may be, subnormal ones and zero too; mostly near one, where cancellation lives.
    Tracked<E> leaf() {
        if (integer(0, 9) == 0) return of(0);
        if (integer(0, 3) == 0) return of(integer(-4, 4));
        const double mantissa = number(0, 1) * (integer(0, 1) ? 2 : -2);
        return of(std::ldexp(mantissa, integer(0, 3) ? integer(-30, 30) : integer(lowest_, highest_)));
    }

private:
    static Tracked<E> of(double x) { return {mpq_class(x), E(x)}; }
    int lowest_ = -1074, highest_ = 300;
};

template <class E>
Tracked<E> combined(int operation, const Tracked<E>& a, const Tracked<E>& b) {
    switch (operation) {
        case 0:
            return {a.exact + b.exact, a.enclosure + b.enclosure};
        case 1:
            return {a.exact - b.exact, a.enclosure - b.enclosure};
        case 2:
            return {-a.exact, -a.enclosure};
        case 3:
            if constexpr (requires { a.enclosure / b.enclosure; }) {
                return b.exact == 0 ? a : Tracked<E>{a.exact / b.exact, a.enclosure / b.enclosure};
            }
            [[fallthrough]];
        default:
            return {a.exact * b.exact, a.enclosure * b.enclosure};
    }
}

template <class E>
Tracked<E> expression(Leaves<E>& draw, int depth) {
    if (depth == 0) return draw.leaf();
    return combined(draw.integer(0, 7), expression(draw, depth - 1), expression(draw, depth - 1));
}

template <class E>
bool sign_is_right(const Tracked<E>& x) {
    const auto known = sign(x.enclosure);
    return !known || static_cast<int>(*known) == sgn(x.exact);
}

/// Of `count` expressions without under- and overflow: how many signs were not known, and how many values were zero.
struct Signless {
    int unknown = 0, zeros = 0;
};

template <class E>
Signless signless(int count) {
    Leaves<E> draw(100);
    Signless found;
    for (int i = 0; i < count; ++i) {
        const Tracked<E> x = expression(draw, 2);
        if (sgn(x.exact) == 0)
            ++found.zeros;
        else
            found.unknown += !sign(x.enclosure);
    }
    return found;
}

}  // namespace raylab::tracked
