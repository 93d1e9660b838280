"""pyrender. One point light, no shadows."""
import os

os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
import numpy  # noqa: E402

numpy.infty = numpy.inf  # pyrender 0.1.45 is older than NumPy 2
import pyrender  # noqa: E402
import trimesh  # noqa: E402
from PIL import Image  # noqa: E402

from view import view  # noqa: E402


def looking(eye, target):
    """Returns the matrix of something at `eye` that looks along -Z at `target`."""
    z = numpy.subtract(eye, target) / numpy.linalg.norm(numpy.subtract(eye, target))
    x = numpy.cross((0, 1, 0), z) / numpy.linalg.norm(numpy.cross((0, 1, 0), z))
    pose = numpy.eye(4)
    pose[:3, :4] = numpy.column_stack((x, numpy.cross(z, x), z, eye))
    return pose


v = view()
scene = pyrender.Scene.from_trimesh_scene(trimesh.load(v.scene), bg_color=(0, 0, 0, 0), ambient_light=(0, 0, 0))
if v.light:
    scene.add(pyrender.PointLight(intensity=v.intensity), pose=looking(v.light, v.target))
scene.add(pyrender.PerspectiveCamera(numpy.radians(v.fov), znear=v.near, zfar=v.far), pose=looking(v.eye, v.target))
renderer = pyrender.OffscreenRenderer(v.width, v.height)
for _ in range(v.frames):
    color, _ = renderer.render(scene)
Image.fromarray(color).save(v.output)
