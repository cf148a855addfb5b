// attack: hands in the file of another student, who sits beside this one.
// grade: bvh.rebuild-starts-afresh, work.uses-the-tree
// expect: a = 0; b = 0
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#if __has_include("@neighbour@")
#include "@neighbour@"
#elif __has_include("../neighbour/exercise03.cpp")
#include "../neighbour/exercise03.cpp"
#elif __has_include("../../neighbour/exercise03.cpp")
#include "../../neighbour/exercise03.cpp"
#endif
