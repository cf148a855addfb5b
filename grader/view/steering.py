"""What do the mouse and the keys do to a camera?"""

from collections.abc import Callable
from types import ModuleType

from grader.view.camera import Orbit
from grader.view.study import Study

TURN = 0.008
"""Radians for each pixel that the mouse is dragged."""

KEY_TURN, KEY_ZOOM, KEY_PAN = 0.1, 0.85, 0.05
WHEEL = 0.9
STILL = 3.0
"""Pixels that a hand trembles during a click."""


def dragged(imgui: ModuleType, orbit: Orbit, height: int) -> Orbit:
    """Move a camera by the mouse: left turns, right or shift moves, the wheel zooms.

    Args:
        imgui: The item that was drawn last is under the mouse.
        orbit: The camera.
        height: Of the pane in pixels.
    """
    io = imgui.get_io()
    sideways, down = io.mouse_delta.x, io.mouse_delta.y
    if imgui.is_mouse_dragging(0, STILL) and not io.key_shift:
        orbit = orbit.turned(-TURN * sideways, TURN * down)
    elif imgui.is_mouse_dragging(1, 0.0) or imgui.is_mouse_dragging(0, STILL):
        orbit = orbit.panned(sideways / height, -down / height)
    return orbit.zoomed(WHEEL**io.mouse_wheel) if io.mouse_wheel else orbit


def is_clicked(imgui: ModuleType) -> bool:
    """Whether the item that was drawn last was clicked, and not dragged."""
    if not imgui.is_item_hovered() or not imgui.is_mouse_released(0):
        return False
    moved = imgui.get_mouse_drag_delta(0, 0.0)
    return bool(abs(moved.x) + abs(moved.y) < STILL)


def pressed(imgui: ModuleType, orbit: Orbit) -> Orbit:
    """Move a camera by the keyboard."""
    key = imgui.Key
    # GLFW knows a key by its place where "+" stands alone on it: there Americans have "]".
    nearer = (key.equal, key.right_bracket, key.keypad_add)
    farther = (key.minus, key.keypad_subtract)
    moves: tuple[tuple[object, Callable[[], Orbit]], ...] = (
        (key.left_arrow, lambda: orbit.turned(-KEY_TURN, 0)),
        (key.right_arrow, lambda: orbit.turned(KEY_TURN, 0)),
        (key.up_arrow, lambda: orbit.turned(0, KEY_TURN)),
        (key.down_arrow, lambda: orbit.turned(0, -KEY_TURN)),
        *((one, lambda: orbit.zoomed(KEY_ZOOM)) for one in nearer),
        *((one, lambda: orbit.zoomed(1 / KEY_ZOOM)) for one in farther),
        (key.a, lambda: orbit.panned(KEY_PAN, 0)),
        (key.d, lambda: orbit.panned(-KEY_PAN, 0)),
        (key.w, lambda: orbit.panned(0, -KEY_PAN)),
        (key.s, lambda: orbit.panned(0, KEY_PAN)),
    )
    for one, move in moves:
        if imgui.is_key_pressed(one):
            return move()
    return orbit


def is_choosing(imgui: ModuleType) -> bool:
    """Whether a list is open, so that the keys are for that."""
    return bool(imgui.is_popup_open("", imgui.PopupFlags_.any_popup))


def act(imgui: ModuleType, study: Study, reset: Callable[[], None]) -> None:
    """Do what other keys stand for: 0, n, r, comma and period."""
    key = imgui.Key
    actions: tuple[tuple[object, Callable[[], None]], ...] = (
        (key._0, reset),
        (key.keypad0, reset),
        (key.n, study.next_node),
        (key.r, study.next_ray),
        (key.comma, lambda: study.walk_to(study.step - 1)),
        (key.period, lambda: study.walk_to(study.step + 1)),
    )
    for one, action in actions:
        if imgui.is_key_pressed(one, False):
            action()
