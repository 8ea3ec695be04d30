#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 08` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(cells::inputs, cells::outputs,
                        [](auto input, auto output) { cells::answer(&raylab::light_cell, input, output); });
}
