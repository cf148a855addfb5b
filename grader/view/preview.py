"""The left pane, drawn by OpenGL 3.3 into a texture: a mesh and boxes."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from grader.model.mesh import Bvh, Bytes, Mesh
from grader.view.boxes import corners_of, count_of
from grader.view.camera import Orbit, frame_of, projection
from grader.view.shades import BACKGROUND, DARKEST, light_of, tint

if TYPE_CHECKING:
    import moderngl

_SEEN = "#version 330 core\nuniform mat4 seen;\n"
_FACE_POINT = (
    _SEEN
    + """
in vec3 place;
uniform float scale;
out vec3 world;
void main() { world = scale * place; gl_Position = seen * vec4(place, 1); }
"""
)
_FACE_COLOUR = """#version 330 core
uniform vec3 light, tint;
uniform float darkest;
in vec3 world;
out vec4 pixel;
void main() {
    vec3 n = cross(dFdx(world), dFdy(world));
    float bright = abs(dot(normalize(n), light));
    pixel = vec4(tint * (darkest + (1. - darkest) * bright), 1);
}
"""
_BOX_POINT = (
    _SEEN
    + """
in vec3 low, high;
uniform int first;
flat out vec3 colour;
const int CORNER[24] = int[24](0,1,2,3,4,5,6,7, 0,2,1,3,4,6,5,7, 0,4,1,5,2,6,3,7);
vec3 hue(float h) {
    return clamp(abs(fract(h + vec3(0, 2. / 3., 1. / 3.)) * 6. - 3.) - 1., 0., 1.);
}
void main() {
    int corner = CORNER[gl_VertexID];
    vec3 place = mix(low, high, vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
    float level = floor(log2(float(gl_InstanceID + 1) + .5));
    colour = mix(vec3(1), hue(fract(1. - level * .14)), .75);
    bool used = gl_InstanceID >= first && low.x <= high.x;
    gl_Position = used ? seen * vec4(place, 1) : vec4(2, 2, 2, 1);
    gl_Position.z -= 4e-5 * gl_Position.w;
}
"""
)
_BOX_COLOUR = """#version 330 core
flat in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1); }
"""


@dataclass(frozen=True, slots=True)
class _Sheet:
    """What is drawn on."""

    texture: "moderngl.Texture"
    depth: "moderngl.Renderbuffer"
    frame: "moderngl.Framebuffer"


class Preview:
    """One mesh and one tree on the graphics card."""

    tint = tint((0.75, 0.72, 0.64))
    """(3,) float32, 0 to 255, the colour of the mesh."""

    def __init__(self, context: "moderngl.Context") -> None:
        """Prepare to draw.

        Args:
            context: OpenGL 3.3 or newer.
        """
        self._gl = context
        self._faces = context.program(vertex_shader=_FACE_POINT, fragment_shader=_FACE_COLOUR)
        self._boxes = context.program(vertex_shader=_BOX_POINT, fragment_shader=_BOX_COLOUR)
        self._held: dict[str, list[moderngl.Buffer | moderngl.VertexArray]] = {}
        self._meshes: dict[str, moderngl.VertexArray] = {}
        self._tree: moderngl.VertexArray | None = None
        self._nodes = 0
        self._sheet: _Sheet | None = None

    @property
    def texture(self) -> "moderngl.Texture | None":
        """What was drawn; None at first."""
        return self._sheet.texture if self._sheet else None

    def load(self, name: str, mesh: Mesh) -> None:
        """Take a mesh: `whole`, or `moving` for while the camera moves."""
        self.unload(name)
        if not len(mesh.faces):
            return
        points = self._gl.buffer(np.ascontiguousarray(mesh.vertices, np.float32))
        corners = self._gl.buffer(np.ascontiguousarray(mesh.faces, np.uint32))
        array = self._gl.vertex_array(
            self._faces, [(points, "3f", "place")], index_buffer=corners
        )
        self._meshes[name] = array
        self._held[name] = [array, points, corners]

    def unload(self, name: str) -> None:
        """Forget a mesh."""
        self._meshes.pop(name, None)
        for one in self._held.pop(name, []):
            one.release()

    def load_tree(self, tree: Bvh | None) -> None:
        """Take the boxes of a tree; what stands in it only says where lines go."""
        self.unload("tree")
        self._tree, self._nodes = None, 0
        if tree is None or not len(tree.end):
            return
        corners = corners_of(tree)
        held = self._gl.buffer(corners)
        self._tree = self._gl.vertex_array(self._boxes, [(held, "3f 3f/i", "low", "high")])
        self._nodes = len(corners)
        self._held["tree"] = [self._tree, held]

    def draw(
        self, orbit: Orbit, size: tuple[int, int], level: int, only: bool, moving: bool
    ) -> None:
        """Draw into the texture.

        Args:
            orbit: The camera.
            size: Width and height in pixels.
            level: Boxes down to this level are shown; -1 for none.
            only: Whether only those of this level are shown.
            moving: Whether the coarser mesh will do.
        """
        frame, gl = self._fitted(size).frame, self._gl
        frame.use()
        gl.viewport = (0, 0, *size)
        red, green, blue = (value / 255 for value in BACKGROUND)
        gl.clear(red, green, blue, 1.0, depth=1.0)
        gl.enable_only(gl.DEPTH_TEST)
        gl.depth_func = "<="
        seen = tuple(projection(orbit, *size).T.ravel().tolist())
        coarse = "moving" if moving and "moving" in self._meshes else "whole"
        if coarse in self._meshes:
            self._faces["seen"] = seen
            # Squares of what is as small or large as a mesh may be are no float any more.
            self._faces["scale"] = 1 / orbit.distance
            self._faces["light"] = tuple(light_of(frame_of(orbit)).tolist())
            self._faces["darkest"] = DARKEST
            self._faces["tint"] = tuple((self.tint / 255).tolist())
            self._meshes[coarse].render()
        first, past = count_of(self._nodes, level, only)
        if self._tree is not None and past:
            self._boxes["seen"] = seen
            self._boxes["first"] = first
            self._tree.render(gl.LINES, vertices=24, instances=past)

    def pixels(self) -> Bytes:
        """Return (H, W, 3) uint8 what was drawn last, from the top row on.

        Raises:
            AssertionError: Nothing was drawn yet.
        """
        if self._sheet is None:
            raise AssertionError("something was drawn")
        width, height = self._sheet.texture.size
        data = np.frombuffer(self._sheet.frame.read(components=3, alignment=1), np.uint8)
        return data.reshape(height, width, 3)[::-1].copy()

    def release(self) -> None:
        """Give everything back to the graphics card; nothing can be drawn any more."""
        for name in list(self._held):
            self.unload(name)
        self._fold()
        for program in (self._faces, self._boxes):
            program.release()

    def _fitted(self, size: tuple[int, int]) -> _Sheet:
        """Return something of this size to draw on."""
        old = self._sheet
        if old is not None and old.texture.size == size:
            return old
        self._fold()
        texture, depth = self._gl.texture(size, 4), self._gl.depth_renderbuffer(size)
        self._sheet = _Sheet(texture, depth, self._gl.framebuffer([texture], depth))
        return self._sheet

    def _fold(self) -> None:
        """Forget what was drawn on."""
        if self._sheet is not None:
            for one in (self._sheet.frame, self._sheet.texture, self._sheet.depth):
                one.release()
        self._sheet = None
