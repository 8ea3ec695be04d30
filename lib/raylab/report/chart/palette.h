#pragma once

#include <cstddef>
#include <string>

namespace raylab {

/// How a method looks in every chart: a colour nobody confuses (Okabe and Ito, 2008) and a shape, since colour is
/// never the only sign.
struct Look {
    std::string color;  // "#d55e00"
    int filled;         // gnuplot's point types
    int hollow;
};

/// The look of the index-th method; 35 differ.
Look look_of(std::size_t index);

/// The look of the reader's own method, `yours`: no other has it.
Look look_of_yours();

}  // namespace raylab
