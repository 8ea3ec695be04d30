#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 07c` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(fresnel_share::inputs, fresnel_share::outputs,
                        [](auto input, auto output) { fresnel_share::answer(&raylab::fresnel, input, output); });
}
