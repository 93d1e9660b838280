"""F3D. Its own lights, which cannot be replaced by one point light."""
import f3d

from view import view

v = view()
engine = f3d.Engine.create_egl()
engine.window.size = v.width, v.height
engine.options["ui.axis"] = False
engine.options["render.grid.enable"] = False
engine.scene.add(v.scene)
camera = engine.window.camera
camera.position, camera.focal_point, camera.view_up, camera.view_angle = v.eye, v.target, (0, 1, 0), v.fov
for _ in range(v.frames):
    picture = engine.window.render_to_image()
picture.save(v.output)
