#pragma once

namespace raylab {

/// The first of the users beyond all of a system, as which root runs foreign code: each process is one of its own, by
/// its number, and owns nothing but the folder that it works in.
constexpr unsigned first_lone_user = 2'000'000'000;

}  // namespace raylab
