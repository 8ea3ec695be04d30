#pragma once

#include <stdexcept>

namespace raylab {

/// The exception that an exercise's stub throws until it is written.
class Unfinished : public std::logic_error {
public:
    Unfinished() : std::logic_error("not written yet") {}
};

}  // namespace raylab
