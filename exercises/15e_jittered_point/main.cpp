#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 15e` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(jitter::inputs, jitter::outputs,
                        [](auto input, auto output) { jitter::answer(&raylab::jittered_point, input, output); });
}
