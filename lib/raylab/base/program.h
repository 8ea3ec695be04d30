#pragma once

#include <functional>

namespace raylab {

/// What every program of the lab answers with.
enum class ExitCode {
    as_it_should_be = 0,  // in `stability`: every case as expected, expected failures included
    negative = 1,         // differs, failed, unexpected
    could_not = 2,        // bad input, bad option
};

/// Runs a program's body. An Error becomes one line on stderr and ExitCode::could_not, and so does output that is lost. An
/// interrupt undoes what is unfinished and ends the process (base/interrupt.h).
int run_program(const std::function<ExitCode()>& body);

}  // namespace raylab
