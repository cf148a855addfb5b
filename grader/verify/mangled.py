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
    r"[RPOI]K(St6vectorI)?N(3BVH|S\w?_)4NodeE(St6vectorIS\w_)?|^_ZNKSt6vectorIN3BVH4NodeEE"
)
"""Nodes that are only read: they, or the vector that holds them, are constant.

What a constant span, iterator or pointer leads to is not.
"""

COPY = re.compile(r"N(3BVH|S\w?_)4NodeE")
"""A node; it is a copy, which nobody else sees change, if it stands there for itself."""

READ = "!"
"""Stands in a name where a node was that is only read, or a copy."""

ALLOCATOR = re.compile(r"SaIS\w?_E")
"""What the library adds to a container; its elements are named before."""

BACK = re.compile(r"[RPOI]S[0-9A-Z]{0,9}_")
"""A reference, a pointer or a container of something that a name spelled out before.

More than nine digits stand nowhere: looking for an end at each S would take the square too.
"""

TOKEN = re.compile(r"S[0-9A-Z]{0,9}_|(T|A|Dv)\d*_|L[a-z]n?\d+E|(?P<length>\d+)|.")
"""Pieces of a mangled name; an identifier is its length and that many letters.

Source: Itanium C++ ABI, section 5.1, "External Names (a.k.a. Mangling)".
"""

OPENING = frozenset("NIXJF")
"""Tokens that an `E` closes."""

HALF = re.compile(r"[RPOKVCGM_]|A\d*_")
"""Tokens after which a type goes on: what follows is no parameter for itself."""

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
    own = ALLOCATOR.sub("", own)
    rest = READ_NODES.sub(READ, _without_copies(own))
    # `f(const Node&, Node&)` spells nodes out only once; what comes before means others.
    back = BACK.search(rest.partition(READ)[2])
    return TREE_TYPES.search(own if back else rest) is not None


def _without_copies(name: str) -> str:
    """Mark nodes that are given by value, unless a node may lie in something else as well.

    Nor in templates, which name what they return.
    """
    at, depth, last = 2, 0, ""
    has_head = is_marked = False
    pieces = [name[:at]]
    while token := TOKEN.match(name, at):
        is_whole = not HALF.fullmatch(last) and depth == 0 and has_head
        copy = COPY.match(name, at) if is_whole else None
        if depth < 0 or (is_marked and not is_whole and BACK.match(f"R{token[0]}")):
            return name
        is_marked |= copy is not None
        end = copy.end() if copy else token.end() + int((token["length"] or "0")[:6])
        pieces.append(READ if copy else name[at:end])
        if not copy:
            depth += (token[0] in OPENING) - (token[0] == "E")
        last, at = token[0], end
        if not has_head and depth == 0 and (token["length"] or last == "E"):
            has_head = True
            if "I" in pieces or name.startswith("I", at):
                return name
    return "".join(pieces)


def is_lifetime(name: str) -> bool:
    """Tell whether a function constructs, copies, assigns or destroys a student's object."""
    at = 2
    while not STANDARD.match(name) and (token := TOKEN.match(name, at)):
        at = token.end() + int((token["length"] or "0")[:6])
        if LIFETIME.match(token[0] + name[at : at + 3]):
            return True
    return False
