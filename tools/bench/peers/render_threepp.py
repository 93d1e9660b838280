"""threepp: the port of three.js. One point light, no shadows."""
import threepp as tp
from PIL import Image

from view import view

v = view()
canvas = tp.Canvas("bench", v.width, v.height, antialiasing=0, vsync=False, headless=True)
renderer = tp.GLRenderer(canvas)
scene = tp.Scene()
scene.add(tp.GLTFLoader().load(v.scene).scene)
if v.light:
    light = tp.PointLight(tp.Color(1, 1, 1), v.intensity)
    light.position.set(*v.light)
    scene.add(light)
camera = tp.PerspectiveCamera(v.fov, v.width / v.height, v.near, v.far)
camera.position.set(*v.eye)
camera.look_at(tp.Vector3(*v.target))
for _ in range(v.frames):
    renderer.render(scene, camera)
    pixels = renderer.read_pixels()
Image.fromarray(pixels[..., :3]).save(v.output)
