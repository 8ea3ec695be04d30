#pragma once

#include <functional>

namespace raylab {

/// The exit codes of every program of the lab.
enum class ExitCode {
    as_it_should_be = 0,  // in `stability`: every case is as expected, which may be a failure
    negative = 1,         // pictures differ, a check failed, a case is not as expected
    could_not = 2,        // bad input, wrong option
};

/// Runs a program's body. An Error is printed as one line on stderr and gives ExitCode::could_not; so does output that
/// cannot be written. An interrupt undoes what is unfinished and ends the process (base/interrupt.h).
int run_program(const std::function<ExitCode()>& body);

}  // namespace raylab
