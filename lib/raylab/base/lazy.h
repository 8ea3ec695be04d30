#pragma once

#include <functional>
#include <optional>
#include <utility>

namespace raylab {

/// A value that is computed where it is first asked for, and not at all where it is not. Not for several threads.
template <class T>
class Lazy {
public:
    explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}

    const T& operator()() const {
        if (!value_) value_.emplace(make_());
        return *value_;
    }

private:
    std::function<T()> make_;
    mutable std::optional<T> value_;
};

}  // namespace raylab
