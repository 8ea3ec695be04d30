#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 09b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(tree::inputs, tree::outputs,
                        [](auto input, auto output) { tree::answer(&raylab::nearest_in_tree, input, output); });
}
