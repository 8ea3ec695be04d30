#pragma once

#include <functional>

namespace raylab {

/// What a cell of a light buffer knows about the way from a point to the light. Entries have numbers from 0 on; an
/// entry with a larger number begins no less deep.
struct AskedLightList {
    double depth;  // of the point
    double
        filled;   // something fills the cell there: what is deeper than this is in full shadow; infinity: nothing does
    int entries;  // how many there are
    /// The depth at which an entry begins: nothing of it is less deep.
    std::function<double(int entry)> begin;
    /// Tests the way against an entry: the share of the light that it lets through, 1 where the way misses it, 0 where
    /// it is opaque.
    std::function<double(int entry)> through;
};

/// The share of the light that comes to the point through all that stands in its way. No entry is tested in vain. (The
/// list is Haines and Greenberg's, The Light Buffer, IEEE CG&A 6(9), 1986.) This is the slot of exercise 08b.
double light_through_list(const AskedLightList& list);

}  // namespace raylab
