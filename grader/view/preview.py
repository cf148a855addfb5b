"""The left pane, drawn by OpenGL 3.3 into a texture: a mesh, marked faces and boxes."""

from typing import TYPE_CHECKING

import numpy as np

from grader.model.mesh import Bvh, Bytes, Doubles, Integers, Mesh
from grader.view.boxes import MOST_BOXES, corners_of, count_of
from grader.view.camera import Orbit, frame_of, projection
from grader.view.shades import BACKGROUND, DARKEST, light_of, tint

if TYPE_CHECKING:
    import moderngl

MARK = (255.0, 178.0, 0.0)

_SEEN = "#version 330 core\nuniform mat4 seen;\n"
_FACE_POINT = (
    _SEEN
    + """
in vec3 place;
out vec3 world;
void main() { world = place; gl_Position = seen * vec4(place, 1); }
"""
)
_FACE_COLOUR = """#version 330 core
uniform vec3 light, tint, middle;
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
uniform int first, shown;
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
uniform float alpha;
flat in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, alpha); }
"""


class Preview:
    """One mesh and one tree on the graphics card."""

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
        self._frame: moderngl.Framebuffer | None = None
        self.texture: moderngl.Texture | None = None
        """What was drawn; None at first."""

    def load(self, name: str, mesh: Mesh) -> None:
        """Take a mesh: `whole`, `moving` (while the camera moves) or `marked`."""
        self._drop(name)
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
        self._drop(name)

    def load_tree(self, tree: Bvh | None) -> None:
        """Take the boxes of a tree; whatever stands in it, nothing is drawn outside of it."""
        self._drop("tree")
        self._tree, self._nodes = None, 0
        if tree is None or not len(tree.end):
            return
        corners = corners_of(tree)
        held = self._gl.buffer(corners)
        self._tree = self._gl.vertex_array(self._boxes, [(held, "3f 3f/i", "low", "high")])
        self._nodes = len(corners)
        self._held["tree"] = [self._tree, held]

    def mark(self, mesh: Mesh, faces: Integers) -> None:
        """Mark faces of a mesh."""
        self.load("marked", Mesh(mesh.vertices, mesh.faces[faces]))

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
        self._fit(size)
        gl, frame = self._gl, self._frame
        frame.use()
        gl.viewport = (0, 0, *size)
        frame.clear(*(value / 255 for value in BACKGROUND), 1.0, depth=1.0)
        gl.enable_only(gl.DEPTH_TEST)
        gl.depth_func = "<="
        seen = projection(orbit, *size).T.tobytes()
        self._faces["seen"].write(seen)
        self._faces["light"].value = tuple(light_of(frame_of(orbit)))
        self._faces["darkest"].value = DARKEST
        coarse = "moving" if moving and "moving" in self._meshes else "whole"
        self._draw_mesh(coarse, self.tint)
        if not moving:
            gl.depth_func = "<="
            self._draw_mesh("marked", np.array(MARK))
        first, count = count_of(self._nodes, level, only)
        if self._tree is not None and count:
            self._draw_boxes(seen, first, count)

    tint = tint((0.75, 0.72, 0.64))
    """(3,) float32, 0 to 255, the colour of the mesh."""

    def _draw_mesh(self, name: str, colour: Doubles) -> None:
        if name in self._meshes:
            self._faces["tint"].value = tuple(float(value) / 255 for value in colour)
            self._meshes[name].render()

    def _draw_boxes(self, seen: bytes, first: int, count: int) -> None:
        gl, boxes = self._gl, self._boxes
        boxes["seen"].write(seen)
        boxes["first"].value = first
        gl.enable(gl.BLEND)
        gl.blend_func = gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA
        boxes["alpha"].value = 1.0
        self._tree.render(gl.LINES, vertices=24, instances=count)
        gl.disable(gl.BLEND)

    def pixels(self) -> Bytes:
        """Return (H, W, 3) uint8 what was drawn last, from the top row on."""
        width, height = self.texture.size
        data = np.frombuffer(self._frame.read(components=3, alignment=1), np.uint8)
        return data.reshape(height, width, 3)[::-1].copy()

    def _fit(self, size: tuple[int, int]) -> None:
        if self.texture is not None and self.texture.size == size:
            return
        if self._frame is not None:
            self._frame.release()
            self.texture.release()
            self._depth.release()
        self.texture = self._gl.texture(size, 4)
        self._depth = self._gl.depth_renderbuffer(size)
        self._frame = self._gl.framebuffer([self.texture], self._depth)

    def _drop(self, name: str) -> None:
        self._meshes.pop(name, None)
        for one in self._held.pop(name, []):
            one.release()


__all__ = ["MOST_BOXES", "Preview"]
