#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 05b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(local::inputs, local::outputs,
                        [](auto input, auto output) { local::answer(&raylab::local_color, input, output); });
}
