#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 07b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(trace::inputs, trace::outputs,
                        [](auto input, auto output) { trace::answer(&raylab::traced_color, input, output); });
}
