"""Panda3D with simplepbr. One point light, no shadows: with `enable_shadows` its first frame ends by signal 11 in software GL."""
import simplepbr
from direct.showbase.ShowBase import ShowBase
from panda3d.core import GraphicsOutput, Point3, PointLight, Texture, loadPrcFileData

from view import view

v = view()
loadPrcFileData("", f"window-type offscreen\nload-display p3headlessgl\nwin-size {v.width} {v.height}\naudio-library-name null\n"
                    "gl-version 3 2\nsync-video false")
base = ShowBase()
simplepbr.init(msaa_samples=0, enable_shadows=False)


def z_up(p):
    """Panda3D's Z points up, glTF's Y."""
    return Point3(p[0], -p[2], p[1])


base.loader.loadModel(v.scene).reparentTo(base.render)
if v.light:
    light = PointLight("light")
    light.setColor((v.intensity, v.intensity, v.intensity, 1))
    light.setAttenuation((0, 0, 1))
    light_path = base.render.attachNewNode(light)
    light_path.setPos(z_up(v.light))
    base.render.setLight(light_path)
base.setBackgroundColor(0, 0, 0)
base.disableMouse()
base.camLens.setAspectRatio(v.width / v.height)
base.camLens.setMinFov(v.fov)
base.camLens.setNearFar(v.near, v.far)
base.camera.setPos(z_up(v.eye))
base.camera.lookAt(z_up(v.target))
copy = Texture()
base.win.addRenderTexture(copy, GraphicsOutput.RTMCopyRam)
for _ in range(v.frames):
    base.taskMgr.step()
copy.write(v.output)
