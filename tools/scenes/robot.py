"""The small robot of the default scene: enamel, brushed metal, and a lantern that really lights its face."""
from .geometry import arc, box, cylinder, lathe, merged, polygon, rectangle, rounded_box
from .spectrum import with_luminance
from .vector import rotation_about

LANTERN_COLOR, LANTERN_LUMINANCE = (1.0, 0.56, 0.2), 240.0  # [cd/m²]
EYE_COLOR, EYE_LUMINANCE = (0.3, 1.0, 0.85), 130.0
LANTERN_WIDTH, LANTERN_HEIGHT = 0.062, 0.08  # of the paper [m]


def capsule(radius, length, segments=16):
    """Hangs from the origin along -y."""
    return lathe(arc((0, -length), radius, -90, 0, 4) + arc((0, 0), radius, 0, 90, 4), segments=segments)


def lantern_paper():
    """Four rectangles that face outward, centred on the origin."""
    x, y = LANTERN_WIDTH / 2, LANTERN_HEIGHT / 2
    ring = [(-x, x), (x, x), (x, -x), (-x, -x)]
    sides = []
    for (x0, z0), (x1, z1) in zip(ring, ring[1:] + ring[:1]):
        sides.append(polygon((x0, -y, z0), (x1, -y, z1), (x1, y, z1), (x0, y, z0)))
    return merged(*sides)


class Robot:
    def __init__(self, document, ball):
        """`ball` is a sphere of radius 1 m to make small parts of."""
        self.document, self.ball = document, ball
        enamel = document.material("orange enamel", (0.82, 0.2, 0.035), roughness=0.22)
        self.enamel = enamel
        self.steel = document.material("steel", (0.6, 0.61, 0.63), metallic=1, roughness=0.42)
        self.cream = document.material("cream enamel", (0.75, 0.7, 0.6), roughness=0.3)
        self.black = document.material("black lacquer", (0.012, 0.012, 0.015), roughness=0.1)
        self.gold = document.material("polished gold", (1.0, 0.77, 0.34), metallic=1, roughness=0.18)

    def part(self, name, parent, geometry, material, **placement):
        mesh = self.document.mesh(name, (geometry, material))
        return self.document.node(name, parent, mesh=mesh, **placement)

    def add(self, **placement):
        """Stands on the origin of its placement, faces +z, 0.47 m tall."""
        robot = self.document.node("robot", **placement)
        self.add_body(robot)
        self.add_head(robot)
        self.add_arms(robot)

    def add_body(self, robot):
        foot = rounded_box(0.075, 0.05, 0.11, 0.02)
        for side in (-1, 1):
            self.part("foot", robot, foot, self.black, translation=(side * 0.052, 0.025, 0.015))
        shell = arc((0.05, 0.1), 0.055, -90, 0, 4) + [(0.108, 0.14)] + arc((0.045, 0.2), 0.055, 20, 90, 5)
        self.part("body", robot, lathe([(0.0, 0.045), (0.05, 0.045)], shell, [(0.045, 0.255), (0.0, 0.255)], segments=32),
                  self.enamel)
        self.part("button", robot, self.ball, self.gold, translation=(0, 0.19, 0.1), scale=(0.014,) * 3)
        self.part("neck", robot, cylinder(0.026, 0.03, 0.004, 20), self.steel, translation=(0, 0.25, 0))

    def add_head(self, robot):
        head = self.document.node("head", robot, translation=(0, 0.345, 0), rotation=rotation_about((-1, 0.25, 0), 9))
        self.part("skull", head, rounded_box(0.2, 0.145, 0.15, 0.045, steps=3), self.enamel)
        self.part("visor", head, rounded_box(0.155, 0.088, 0.03, 0.014), self.black, translation=(0, -0.002, 0.066))
        glow = self.document.material("eye", (0, 0, 0), roughness=1, lambert=True,
                                      emission=with_luminance(EYE_COLOR, EYE_LUMINANCE))
        ear = cylinder(0.028, 0.022, 0.006, 20)
        for side in (-1, 1):
            self.part("eye", head, rectangle(0.022, 0.036), glow, translation=(side * 0.036, 0.002, 0.0815))
            self.part("ear", head, ear, self.steel, translation=(side * 0.097, 0, 0),
                      rotation=rotation_about((0, 0, -side), 90))
        self.part("antenna", head, capsule(0.004, 0.06, 8), self.steel, translation=(0.045, 0.13, 0))
        self.part("antenna tip", head, self.ball, self.gold, translation=(0.045, 0.138, 0), scale=(0.013,) * 3)

    def add_arms(self, robot):
        arm = capsule(0.021, 0.1)
        self.part("right arm", robot, arm, self.cream, translation=(-0.115, 0.2, 0),
                  rotation=rotation_about((0, 0, -1), 14))
        lifted = self.part("left arm", robot, arm, self.cream, translation=(0.105, 0.205, 0.015),
                           rotation=rotation_about((-0.8, 0, 1), 112))
        # The hand: the arm's far end, its axes turned back upright.
        hand = self.document.node("hand", lifted, translation=(0, -0.1, 0), rotation=rotation_about((-0.8, 0, 1), -112))
        self.add_lantern(hand)

    def add_lantern(self, hand):
        lantern = self.document.node("lantern", hand, translation=(0, -0.085, 0), rotation=rotation_about((0, 1, 0), 20))
        glow = self.document.material("lantern paper", (0, 0, 0), roughness=1, lambert=True,
                                      emission=with_luminance(LANTERN_COLOR, LANTERN_LUMINANCE))
        self.part("lantern paper", lantern, lantern_paper(), glow)
        lid = box(LANTERN_WIDTH + 0.014, 0.008, LANTERN_WIDTH + 0.014)
        self.part("lantern lid", lantern, lid, self.gold, translation=(0, LANTERN_HEIGHT / 2, 0))
        self.part("lantern foot", lantern, lid, self.gold, translation=(0, -LANTERN_HEIGHT / 2 - 0.008, 0))
        self.part("lantern knob", lantern, capsule(0.004, 0.03, 8), self.gold,
                  translation=(0, LANTERN_HEIGHT / 2 + 0.042, 0))
