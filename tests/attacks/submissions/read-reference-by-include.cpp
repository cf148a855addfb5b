// attack: hands in the model solution by its path on the grader's disk.
// grade: bvh.rebuild-starts-afresh, work.uses-the-tree
// expect: a = 0; b = 0
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#if __has_include("@reference@")
#include "@reference@"
#elif __has_include("../../reference/src/exercise03.cpp")
#include "../../reference/src/exercise03.cpp"
#elif __has_include("@checkout@/tests/submissions/right/own-everything.cpp")
#include "@checkout@/tests/submissions/right/own-everything.cpp"
#endif
