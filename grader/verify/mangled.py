"""What the mangled name of a function says of it. Names are read, never run or printed."""

import re

STANDARD = re.compile(r"_ZN?K?(St|Sa|Ss|9__gnu_cxx)|_Zn|_Zd")
"""Functions of the standard library, and the operators new and delete."""

TREE_TYPES = re.compile(
    r"(?<!\d)3BVH4Node|^(?>.*?(?<!\d)3BVH).*NS\w?_4Node"
    r"|_ZN?K?3BVH14getFaceIndices|_ZN4AABB6extend"
)
"""Mangled names that speak of nodes, or make boxes grow: whoever calls these builds the tree.

A sorting helper only touches faces and centres. It may keep a face's box beside the face, and
read the node whose faces it sorts. Only the first `3BVH` is tried: all would take the square of
a name's length.
"""

READ_NODES = re.compile(
    r"[RPOI]K(St6vectorI)?N(3BVH|S\w?_)4NodeE(St6vectorIS\w_)?(SaIS\w_EE)?"
    r"|^_ZNKSt6vectorIN3BVH4NodeESaIS\w_EE"
)
"""Nodes that are only read: they, or the vector that holds them, are constant.

What a constant span, iterator or pointer leads to is not.
"""

BACK = re.compile(r"[RPOI]S[0-9A-Z]{0,9}_")
"""A reference, a pointer or a container of something that a name spelled out before.

More than nine digits stand nowhere: looking for an end at each S would take the square too.
"""

TOKEN = re.compile(r"S[0-9A-Z]{0,9}_|T\d*_|L[a-z]n?\d+E|(?P<length>\d+)|.")
"""Pieces of a mangled name; an identifier is its length and that many letters.

Source: Itanium C++ ABI, section 5.1, "External Names (a.k.a. Mangling)".
"""

TREE_WORK = re.compile(
    r"_ZN4AABB6extend|_ZNK?3BVH14getFaceIndices"
    r"|_ZNSt6vectorIN3BVH4NodeESaIS\w?_EE(ix|2at|4back|6(resize|assign|insert)"
    r"|7emplace|9push_back|12emplace_back)"
)
"""Mangled names of what no copy and no clean-up of a tree ever calls."""

LIFETIME = re.compile(r"[CD][0-5]|aS[EI](?!_)")
"""Constructors, destructors and assignments in mangled names."""


def speaks_of_nodes(name: str) -> bool:
    """Whether a function may change nodes or makes boxes grow, and does not only sort.

    Where it was written does not count: the comparator inside `split(Node&)`, and a quicksort
    that is made for this comparator, carry the name of `split` in theirs.
    """
    at, words = 2, []
    while (token := TOKEN.match(name, at)) and token[0] != "Z":
        at = token.end() + int((token["length"] or "0")[:6])
        words += [name[token.end() : at]] if token["length"] else []
    own = name[:at]
    # `S_` is the first class that is named: the function's own one, if it has one.
    if words[: 1 if own.startswith("_ZN") else 2][-1:] != ["BVH"]:
        own = own.replace("NS_4Node", "")
    rest = READ_NODES.sub("", own)
    # `f(const Node&, Node&)` spells nodes out only once.
    return TREE_TYPES.search(own if BACK.search(rest) else rest) is not None


def is_lifetime(name: str) -> bool:
    """Tell whether a function constructs, copies, assigns or destroys a student's object."""
    at = 2
    while not STANDARD.match(name) and (token := TOKEN.match(name, at)):
        at = token.end() + int((token["length"] or "0")[:6])
        if LIFETIME.match(token[0] + name[at : at + 3]):
            return True
    return False
