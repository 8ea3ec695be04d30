#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 11` starts it and judges what it says.
int main() {
    using namespace raylab::grading;
    return answer_cases(next_cell::inputs, next_cell::outputs,
                        [](auto input, auto output) { next_cell::answer(&raylab::point_in_next_cell, input, output); });
}
