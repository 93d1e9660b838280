"""An office with six luminous panels above four desks: for `steradian illuminance`, and for working planes."""
from .geometry import box, floor, merged, rectangle
from .gltf import Document
from .vector import looking, rotation_about

FILE = "office.gltf"

WIDTH, HEIGHT, DEPTH = 6.0, 2.8, 4.8  # of the room, from wall to wall [m]
DESK = (1.6, 0.75, 0.8)  # width, height, depth [m]
TOP = 0.03  # thickness of a desk's top [m]
PANEL = 0.6  # side of a panel [m]
FLUX = 3600.0  # of a panel [lm]: a common LED panel of 30 W
PANEL_X, PANEL_Z = (-2.0, 0.0, 2.0), (-1.2, 1.2)
DESK_X, DESK_Z = (-1.6, 1.6), (-1.4, 1.0)


def moved(geometry, offset):
    geometry.positions = [tuple(a + b for a, b in zip(position, offset)) for position in geometry.positions]
    return geometry


def desk():
    """A top on two side panels, standing on the origin; people sit at its +z side."""
    width, height, depth = DESK
    sides = [moved(box(TOP, height - TOP, depth - 0.1), (x * (width / 2 - 0.05), 0, 0)) for x in (-1, 1)]
    return merged(moved(box(width, TOP, depth), (0, height - TOP, 0)), *sides)


def monitor():
    """Standing on the origin, its screen facing +z."""
    return merged(box(0.22, 0.015, 0.16), moved(box(0.04, 0.3, 0.03), (0, 0, -0.03)), moved(box(0.6, 0.35, 0.025), (0, 0.12, 0)))


def add_walls(document):
    paint = document.material("white paint", (0.8, 0.8, 0.78), roughness=1, lambert=True)
    carpet = document.material("carpet", (0.16, 0.2, 0.26), roughness=1, lambert=True)
    ground, ceiling = document.mesh("floor", (floor(WIDTH, DEPTH), carpet)), document.mesh("ceiling", (floor(WIDTH, DEPTH), paint))
    document.node("floor", mesh=ground)
    document.node("ceiling", mesh=ceiling, translation=(0, HEIGHT, 0), rotation=rotation_about((1, 0, 0), 180))
    long, short = document.mesh("long wall", (rectangle(WIDTH, HEIGHT), paint)), document.mesh("short wall", (rectangle(DEPTH, HEIGHT), paint))
    for name, mesh, place, turn in (("back", long, (0, HEIGHT / 2, -DEPTH / 2), 0), ("front", long, (0, HEIGHT / 2, DEPTH / 2), 180),
                                    ("left", short, (-WIDTH / 2, HEIGHT / 2, 0), 90), ("right", short, (WIDTH / 2, HEIGHT / 2, 0), -90)):
        document.node(f"{name} wall", mesh=mesh, translation=place, rotation=rotation_about((0, 1, 0), turn))


def add_furniture(document):
    wood = document.material("beech", (0.55, 0.38, 0.22), roughness=0.5)
    black = document.material("black plastic", (0.02, 0.02, 0.02), roughness=0.4)
    metal = document.material("cabinet", (0.45, 0.47, 0.5), roughness=0.5)
    desk_mesh, monitor_mesh = document.mesh("desk", (desk(), wood)), document.mesh("monitor", (monitor(), black))
    number = 0
    for z in DESK_Z:
        for x in DESK_X:
            number += 1
            document.node(f"desk {number}", mesh=desk_mesh, translation=(x, 0, z))
            document.node(f"monitor {number}", mesh=monitor_mesh, translation=(x, DESK[1], z - 0.2))
    cabinet = document.mesh("cabinet", (box(1.2, 1.6, 0.42), metal))
    document.node("cabinet", mesh=cabinet, translation=(-WIDTH / 2 + 0.25, 0, -0.15), rotation=rotation_about((0, 1, 0), 90))


def add_panels(document):
    down = rotation_about((1, 0, 0), -90)
    number = 0
    for z in PANEL_Z:
        for x in PANEL_X:
            number += 1
            document.node(f"panel {number}", extras={"steradian": {
                "shape": "rectangle", "width": PANEL, "height": PANEL, "quantity": {"value": FLUX, "unit": "lm"}}},
                translation=(x, HEIGHT - 0.01, z), rotation=down)


def make():
    document = Document("CC0")
    add_walls(document)
    add_furniture(document)
    add_panels(document)
    document.camera("main", 1.0, 1.6, 0.01, **looking((2.75, 1.75, 2.2), (-0.9, 0.75, -0.9)))
    return document.text()
