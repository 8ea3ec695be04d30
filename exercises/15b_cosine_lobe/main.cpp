#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 15b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(cosine_lobe::inputs, cosine_lobe::outputs,
                        [](auto input, auto output) { cosine_lobe::answer(&raylab::cosine_direction, input, output); });
}
