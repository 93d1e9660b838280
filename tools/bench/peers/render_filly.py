"""filly (Filament). One point light, no shadows."""
import math

import filly
from PIL import Image

from view import view

v = view()
with filly.Renderer() as renderer:
    scene = renderer.create_scene()
    scene.load(v.scene)
    if v.light:
        # In cd, as the picture shows. The light ends at `range`, so that lies beyond what the camera sees.
        scene.add_point_light(position=v.light, intensity=v.intensity, range=v.far)
    camera = renderer.create_camera()
    camera.set_perspective(fov_y_deg=v.fov, near=v.near, far=v.far)
    camera.position = v.eye
    camera.look_at(v.target)
    camera.exposure = math.log2(1 / 1.2)  # EV100 at which a radiance of 1 is white
    scene.camera = camera
    target = renderer.create_render_target(width=v.width, height=v.height)
    for _ in range(v.frames):
        renderer.render(scene, target)
        pixels = target.read()
    Image.fromarray(pixels[..., :3]).save(v.output)
