#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 06` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(shadow::inputs, shadow::outputs,
                        [](auto input, auto output) { shadow::answer(&raylab::in_shadow, input, output); });
}
