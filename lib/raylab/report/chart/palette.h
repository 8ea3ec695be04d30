#pragma once

#include <cstddef>
#include <string>

namespace raylab {

/// The look of a method in every chart: a colour that is hard to confuse (Okabe and Ito, 2008) and a shape, because
/// colour must never be the only distinction.
struct MarkerStyle {
    std::string color;  // "#d55e00"
    int filled;         // gnuplot's point types
    int hollow;
};

/// The look of the method with this index; 35 looks differ.
MarkerStyle style_of(std::size_t index);

/// The look of the reader's own method, `yours`, which no other method has.
MarkerStyle style_of_yours();

}  // namespace raylab
