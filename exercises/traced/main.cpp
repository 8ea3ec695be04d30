#include "answering.h"
#include "traced_numbers.h"

// The textbook's tracer with a student's function in it: it prints nodes of ray trees of the traced scene. `raylab
// check` starts it where the function failed, to find the first ray that goes wrong.
int main() {
    using namespace raylab::grading;
    const auto traced = traced_scene();
    return answer_cases(traced_inputs, traced_outputs,
                        [&](auto input, auto output) { write_traced(traced, input, output); });
}
