"""Does the file compile, and does `construct` loop instead of calling itself?"""

from grader.model.cases import BuildCase, SourceCase
from grader.model.verdict import Evidence, Example
from grader.verify.calls import CONSTRUCT, callees_of, is_pointer
from grader.verify.check import check, one
from grader.verify.mangled import STANDARD, TREE_WORK, is_lifetime, speaks_of_nodes
from grader.verify.walks import Callees, in_cycles, names_of, reachable, reverse


@check(BuildCase, "build.compiles")
def compiles(case: BuildCase) -> Evidence:
    """The file compiles and links with the given code."""
    examples = tuple(Example(text, "no error", "an error") for text in case.errors[:3])
    return Evidence(1, 1, examples) if examples else one(None)


@check(SourceCase, "source.construct-loops")
def construct_loops(case: SourceCase) -> Evidence:
    """`construct` uses a loop: no function that builds nodes calls itself, even indirectly.

    Recursion inside sorting helpers is allowed. Source: exercise sheet, part a, "using a loop,
    not recursion".
    """
    callees = callees_of(case.graph)
    called = reachable(callees, (CONSTRUCT,)) | {CONSTRUCT}
    for name in sorted(_recursive_builders(callees) & called):
        if not STANDARD.match(name) and not is_pointer(name):
            line = dict(case.graph.lines).get(name, 0)
            where = f"line {line}" if line else "a function that construct calls"
            text = f"{where}: this function calls itself, but construct must use a loop"
            example = Example(text, "a loop over the nodes", "recursion")
            return Evidence(1, 1, (example,), line=line)
    return one(None)


def _recursive_builders(callees: Callees) -> set[str]:
    """Functions that call themselves and build nodes on the way.

    Nodes that own their children are copied and destroyed recursively without a word of the
    student's: a circle through a constructor or destructor counts only if it works on nodes.
    """
    callers, names = reverse(callees), names_of(callees)
    # Each name is looked into once: a name may be long, and called from everywhere.
    lifetimes = set(filter(is_lifetime, names))
    lasting = {
        name: called - lifetimes for name, called in callees.items() if name not in lifetimes
    }
    plain = in_cycles(lasting) & reachable(callers, filter(speaks_of_nodes, names))
    return plain | in_cycles(callees) & reachable(callers, filter(TREE_WORK.match, names))
