"""Everything that a glTF file can move: a reed that bends by its skin, a ball that morphs, a lamp that travels and
brightens, a sign that goes out, stones that are instances; and a coat of paint to choose."""
import math

from .geometry import box, cylinder, floor, rectangle, sphere
from .gltf import ARRAY_BUFFER, Document
from .vector import looking, rotation_about

FILE = "motion.gltf"

HEIGHT, JOINTS = 1.2, 3  # of the reed [m], and how many parts it bends in
SECONDS = 2.0  # of the animation


def reed(document, material):
    """A tall box in slices. Each slice follows the two joints that it is between, the ends one."""
    slices = 24
    geometry = box(0.16, 1.0, 0.16)
    positions, normals, joints, weights, indices = [], [], [], [], []
    for side in range(4):  # the walls of the box, without its ends
        corners = geometry.positions[4 * side:4 * side + 4]
        first = len(positions)
        for row in range(slices + 1):
            y = HEIGHT * row / slices
            along = (JOINTS - 1) * row / slices
            joint = min(int(along), JOINTS - 2)
            share = along - joint
            share = share * share * (3 - 2 * share)
            for corner in corners[:2]:
                positions.append((corner[0], y, corner[2]))
                normals.append(geometry.normals[4 * side])
                joints.append((joint, joint + 1, 0, 0))
                weights.append((1 - share, share, 0.0, 0.0))
            if row:
                a = first + 2 * row - 2
                indices += [a, a + 1, a + 3, a, a + 3, a + 2]
    attributes = {"POSITION": document.float_accessor(positions, has_bounds=True),
                  "NORMAL": document.float_accessor(normals), "JOINTS_0": document.byte_accessor(joints, ARRAY_BUFFER),
                  "WEIGHTS_0": document.float_accessor(weights)}
    return document.add("meshes", {"name": "reed", "primitives": [
        {"attributes": attributes, "indices": document.index_accessor(indices), "material": material}]})


def add_reed(document, material, animation):
    part = HEIGHT / (JOINTS - 1)
    nodes = []
    for joint in range(JOINTS):
        place = {"translation": (-0.75, 0.0, -0.1) if joint == 0 else (0.0, part, 0.0)}
        nodes.append(document.node(f"joint {joint}", nodes[-1] if nodes else None, **place))
    rest = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -part * joint, 0, 1] for joint in range(JOINTS)]
    skin = document.add("skins", {"name": "reed", "joints": nodes, "skeleton": nodes[0],
                                  "inverseBindMatrices": document.float_accessor(rest, False, None)})
    document.node("reed", mesh=reed(document, material), skin=skin)
    for joint in nodes[1:]:
        turns = [rotation_about((0, 0, 1), angle) for angle in (0, -40, 0, 30, 0)]
        document.channel(animation, (joint, "rotation"), [0.0, 0.5, 1.0, 1.5, 2.0], turns)


def add_ball(document, material, animation):
    """Its first target is a nose, which few vertices take part in; its second flattens it."""
    ball = sphere(0.3, 32)
    nose, flat, flat_normals = [], [], []
    for position, normal in zip(ball.positions, ball.normals):
        ahead = max(0.0, normal[2] - 0.8) / 0.2
        nose.append((0.0, 0.0, 0.35 * ahead * ahead))
        flat.append((0.4 * position[0], -0.5 * position[1], 0.4 * position[2]))
        turned = (normal[0] / 1.4, normal[1] / 0.5, normal[2] / 1.4)
        length = math.sqrt(sum(part * part for part in turned))
        flat_normals.append(tuple(part / length - old for part, old in zip(turned, normal)))
    mesh = document.mesh("ball", (ball, material))
    document.json["meshes"][mesh]["primitives"][0]["targets"] = [
        {"POSITION": document.sparse_accessor(nose)},
        {"POSITION": document.float_accessor(flat, has_bounds=True), "NORMAL": document.float_accessor(flat_normals)}]
    document.json["meshes"][mesh]["weights"] = [0, 0]
    node = document.node("ball", mesh=mesh, translation=(0.0, 0.3, 0.1))
    keys = [(0, 0), (0, 0), (0, 2), (0, 0), (1, 0), (0, 0), (0, -2), (0, 1), (0, 0)]  # in-tangents, values, out-tangents
    document.channel(animation, (node, "weights"), [0.0, 1.0, 2.0], [[number] for key in keys for number in key],
                     "CUBICSPLINE")


def add_stones(document, material):
    document.use("EXT_mesh_gpu_instancing")
    places, turns = [], []
    for i in range(12):
        angle = 2 * math.pi * i / 12
        places.append((1.5 * math.cos(angle), 0.0, 0.9 * math.sin(angle)))
        turns.append(rotation_about((0, 1, 0), 25 * i))
    attributes = {"TRANSLATION": document.float_accessor(places, False, None),
                  "ROTATION": document.float_accessor(turns, False, None)}
    document.node("stones", mesh=document.mesh("stone", (box(0.12, 0.1, 0.12), material)),
                  extensions={"EXT_mesh_gpu_instancing": {"attributes": attributes}})


def add_lights(document, animation):
    document.light("KHR_lights_punctual", {"name": "lamp", "type": "point", "color": [1.0, 0.85, 0.6], "intensity": 30.0},
                   translation=(-1.2, 1.6, 1.2), extras={"steradian": {"radius": 0.05}})
    lamp = len(document.json["nodes"]) - 1
    document.channel(animation, (lamp, "translation"), [0.0, 1.0, 2.0], [(-1.2, 1.6, 1.2), (0.0, 2.0, 1.4), (1.2, 1.6, 1.2)])
    document.channel(animation, "/extensions/KHR_lights_punctual/lights/0/intensity", [0.0, 2.0], [[30.0], [60.0]])
    document.use("KHR_node_visibility")
    glow = document.material("sign", (0, 0, 0), roughness=1, lambert=True, emission=(120.0, 160.0, 240.0))
    sign = document.node("sign", mesh=document.mesh("sign", (rectangle(0.5, 0.5), glow)), translation=(0.9, 0.7, -0.6),
                         rotation=rotation_about((0, 1, 0), -25),
                         extensions={"KHR_node_visibility": {"visible": True}})
    document.channel(animation, f"/nodes/{sign}/extensions/KHR_node_visibility/visible", [0.0, 1.25, 1.75],
                     [[True], [False], [True]], "STEP")


def make():
    document = Document("CC0")
    animation = document.add("animations", {"name": "all", "samplers": [], "channels": []})
    ground = document.material("ground", (0.5, 0.5, 0.5), roughness=0.9)
    green = document.material("green", (0.2, 0.5, 0.15), roughness=0.5)
    red = document.material("red", (0.7, 0.12, 0.08), roughness=0.3)
    gold = document.material("gold", (1.0, 0.77, 0.34), metallic=1, roughness=0.25)
    document.node("ground", mesh=document.mesh("ground", (floor(4, 3), ground)))
    add_reed(document, green, animation)
    add_ball(document, red, animation)
    add_stones(document, ground)
    add_lights(document, animation)
    document.use("KHR_materials_variants")
    document.json["extensions"]["KHR_materials_variants"] = {"variants": [{"name": "gilded"}]}
    ball = next(mesh for mesh in document.json["meshes"] if mesh["name"] == "ball")
    ball["primitives"][0]["extensions"] = {"KHR_materials_variants": {"mappings": [{"material": gold, "variants": [0]}]}}
    document.camera("main", 0.6, 1.5, 0.01, **looking((0.3, 1.7, 4.2), (0, 0.55, 0)))
    return document.text()
