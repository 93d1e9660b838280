"""PyVista (VTK). One point light, no shadows."""
import pyvista

from view import view

v = view()
plotter = pyvista.Plotter(off_screen=True, window_size=(v.width, v.height), lighting="none")
plotter.import_gltf(v.scene)
if v.light:
    plotter.add_light(pyvista.Light(position=v.light, light_type="scene light", intensity=1.0, positional=True, cone_angle=180))
plotter.camera.position, plotter.camera.focal_point, plotter.camera.up = v.eye, v.target, (0, 1, 0)
plotter.camera.view_angle = v.fov
plotter.show(auto_close=False)
for _ in range(v.frames - 1):
    plotter.render()
    plotter.screenshot(return_img=True)
plotter.screenshot(v.output)
