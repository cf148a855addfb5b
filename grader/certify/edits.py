"""Which small edits turn a right submission into one with a mistake?

Edits are found in the syntax tree, so that they hit code and never a comment, a string or half
a name. Whether the result compiles is for the compiler to say.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from grader.certify.confusions import NAMES, OPERATORS
from grader.errors import MissingTool

try:
    import tree_sitter_cpp
    from tree_sitter import Language, Node, Parser
except ImportError as fault:
    raise MissingTool(
        "tree-sitter is not installed; mutants need it: pip install -e '.[dev]'"
    ) from fault

_COPIES = {"declaration", "parameter_list"}
_LISTS = {"argument_list", "initializer_list", "subscript_argument_list"}
_OPERATIONS = {"binary_expression", "assignment_expression", "update_expression"}
_ORDERED = {"-", "/", "<<", ">>", "%"}
_STATEMENTS = {"expression_statement", "continue_statement", "break_statement"}


@dataclass(frozen=True, slots=True)
class Edit:
    """Bytes `begin` to `end` of a source become something else."""

    kind: str
    """What sort of mistake it is: `operator`, `constant` and so on."""

    begin: int
    end: int
    text: bytes

    def applied(self, source: bytes) -> bytes:
        """The edited source."""
        return source[: self.begin] + self.text + source[self.end :]


def edits(source: bytes) -> list[Edit]:
    """Every edit of a C++ source, in the order of the text; never two that are equal."""
    root = Parser(Language(tree_sitter_cpp.language())).parse(source).root_node
    found = {
        (edit.begin, edit.end, edit.text): edit
        for node in _nodes(root)
        for rule in _RULES
        for edit in rule(node)
    }
    return sorted(found.values(), key=lambda one: (one.begin, one.end, one.text))


def _nodes(root: Node) -> Iterator[Node]:
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.type not in {"preproc_include", "comment"}:
            yield node
            waiting += node.children


def _operator(node: Node) -> Iterator[Edit]:
    """Another operator."""
    operator = node.child_by_field_name("operator")
    if operator and node.type in _OPERATIONS:
        for other in OPERATORS.get(_text(operator), ()):
            yield _instead("operator", operator, other.encode())


def _operands(node: Node) -> Iterator[Edit]:
    """The operands the other way round."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = node.child_by_field_name("operator")
    if left and right and operator and _text(operator) in _ORDERED:
        yield _swapped("operands", left, right)


def _constant(node: Node) -> Iterator[Edit]:
    """One more, one less, twice as much, or nothing."""
    if node.type == "number_literal":
        text = node.text or b""
        others = [b"(%s + 1)" % text, b"(%s - 1)" % text, b"(%s * 2)" % text, b"0"]
        # Of 0 and 1 some of these are the same number, and twice 0 is no edit.
        others = others[: {b"0": 2, b"1": 2}.get(text, 4)]
        for other in others:
            yield _instead("constant", node, other)


def _name(node: Node) -> Iterator[Edit]:
    """What it is easily confused with."""
    if node.child_count == 0:
        for other in NAMES.get(_text(node), ()):
            yield _instead("name", node, other.encode())


def _condition(node: Node) -> Iterator[Edit]:
    """The opposite, always, or never."""
    if node.type in {"if_statement", "while_statement"}:
        clause = node.child_by_field_name("condition")
        value = clause.child_by_field_name("value") if clause else None
        if value:
            yield _instead("condition", value, b"!(%s)" % (value.text or b""))
            yield _instead("condition", value, b"false")
            if node.type == "if_statement":
                yield _instead("condition", value, b"true")


def _junction(node: Node) -> Iterator[Edit]:
    """Only one of two conditions."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = node.child_by_field_name("operator")
    if operator and left and right and _text(operator) in {"&&", "||"}:
        yield _instead("condition", node, left.text or b"")
        yield _instead("condition", node, right.text or b"")


def _sign(node: Node) -> Iterator[Edit]:
    """Without its `!`, `-` or `~`."""
    operator = node.child_by_field_name("operator")
    if node.type == "unary_expression" and operator and _text(operator) in {"!", "-", "~"}:
        yield _instead("sign", operator, b"")


def _dropped(node: Node) -> Iterator[Edit]:
    """A statement less; an `else` less; nothing returned."""
    if node.type in _STATEMENTS:
        yield _instead("dropped", node, b";")
    elif node.type == "else_clause":
        yield _instead("dropped", node, b"")
    elif node.type == "return_statement" and node.named_child_count:
        yield _instead("dropped", node, b"return {};")


def _order(node: Node) -> Iterator[Edit]:
    """Two statements that follow each other, exchanged."""
    if node.type == "compound_statement":
        yield from _neighbours(
            "order", [one for one in node.named_children if not one.is_extra]
        )


def _arguments(node: Node) -> Iterator[Edit]:
    """Two arguments that follow each other, exchanged."""
    if node.type in _LISTS:
        yield from _neighbours("arguments", node.named_children)


def _branches(node: Node) -> Iterator[Edit]:
    """The two results of a condition, exchanged."""
    one, other = (node.child_by_field_name(name) for name in ("consequence", "alternative"))
    if node.type == "conditional_expression" and one and other:
        yield _swapped("branches", one, other)


def _copied(node: Node) -> Iterator[Edit]:
    """A copy instead of a reference."""
    if node.type != "reference_declarator" or not node.parent or not node.parent.parent:
        return
    if node.parent.type == "for_range_loop" or node.parent.parent.type in _COPIES:
        yield _instead("copied", node.children[0], b"")


_RULES: tuple[Callable[[Node], Iterator[Edit]], ...] = (
    _operator,
    _operands,
    _constant,
    _name,
    _condition,
    _junction,
    _sign,
    _dropped,
    _order,
    _arguments,
    _branches,
    _copied,
)


def _neighbours(kind: str, nodes: Sequence[Node]) -> Iterator[Edit]:
    for one, other in pairwise(nodes):
        if one.text != other.text:
            yield _swapped(kind, one, other)


def _swapped(kind: str, one: Node, other: Node) -> Edit:
    """Exchange two children of a node and keep what stands between them."""
    whole, start = (one.parent.text, one.parent.start_byte) if one.parent else (b"", 0)
    between = (whole or b"")[one.end_byte - start : other.start_byte - start]
    text = (other.text or b"") + between + (one.text or b"")
    return Edit(kind, one.start_byte, other.end_byte, text)


def _instead(kind: str, node: Node, text: bytes) -> Edit:
    return Edit(kind, node.start_byte, node.end_byte, text)


def _text(node: Node) -> str:
    return (node.text or b"").decode(errors="replace")
