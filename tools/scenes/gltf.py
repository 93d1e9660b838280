"""Writes glTF 2.0: one JSON text with one embedded buffer, the same bytes on every machine."""
import base64
import json
import struct

ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
UNSIGNED_BYTE, UNSIGNED_SHORT, FLOAT = 5121, 5123, 5126
LINEAR, LINEAR_MIPMAP_LINEAR, REPEAT = 9729, 9987, 10497


def snapped(number):
    """To a multiple of 2^-20: exact as a 32-bit float up to 16, and the last bit of a platform's sine is gone."""
    return round(number * 2**20) / 2**20 + 0.0  # + 0.0 turns -0.0 into 0.0


def rounded(value):
    """Numbers as a person would write them: seven significant digits, no trailing .0."""
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    if isinstance(value, float):
        short = float(f"{value:.7g}")
        return int(short) if short.is_integer() else short
    return value


class Document:
    """A glTF file in the making. Methods return the index of what they add."""

    def __init__(self, copyright_line):
        self.json = {"asset": {"version": "2.0", "generator": "Steradian tools/make_scenes", "copyright": copyright_line},
                     "scene": 0, "scenes": [{"name": "main", "nodes": []}]}
        self.binary = bytearray()
        self.accessors_of = {}  # geometry → attributes and indices, so that materials share it

    def add(self, kind, item):
        self.json.setdefault(kind, []).append(item)
        return len(self.json[kind]) - 1

    def use(self, extension):
        used = self.json.setdefault("extensionsUsed", [])
        if extension not in used:
            used.append(extension)
            used.sort()

    # --- materials ---------------------------------------------------------------------------------------------

    def material(self, name, base_color=(0.8, 0.8, 0.8), metallic=0.0, roughness=0.5, emission=None, lambert=False,
                 base_color_texture=None, metallic_roughness_texture=None, normal_texture=None, normal_scale=1.0):
        """`emission` is the luminance as linear RGB [cd/m²]; `lambert` takes the specular lobe away."""
        surface = {"baseColorFactor": rounded([*base_color, 1.0]),
                   "metallicFactor": rounded(float(metallic)), "roughnessFactor": rounded(float(roughness))}
        if base_color_texture is not None:
            surface["baseColorTexture"] = {"index": base_color_texture}
        if metallic_roughness_texture is not None:
            surface["metallicRoughnessTexture"] = {"index": metallic_roughness_texture}
        item = {"name": name, "pbrMetallicRoughness": surface}
        if normal_texture is not None:
            item["normalTexture"] = {"index": normal_texture, "scale": normal_scale}
        if lambert:
            self.use("KHR_materials_specular")
            item.setdefault("extensions", {})["KHR_materials_specular"] = {"specularFactor": 0}
        if emission is not None:
            self.use("KHR_materials_emissive_strength")
            strength = max(emission)
            item["emissiveFactor"] = rounded([channel / strength for channel in emission])
            item.setdefault("extensions", {})["KHR_materials_emissive_strength"] = {
                "emissiveStrength": rounded(float(strength))}
        return self.add("materials", item)

    def texture(self, name, png):
        if "samplers" not in self.json:
            self.add("samplers", {"magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR, "wrapS": REPEAT, "wrapT": REPEAT})
        image = self.add("images", {"name": name, "mimeType": "image/png", "bufferView": self.view(png, None)})
        return self.add("textures", {"name": name, "sampler": 0, "source": image})

    # --- geometry ----------------------------------------------------------------------------------------------

    def view(self, data, target):
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target is not None:
            view["target"] = target
        self.binary.extend(data)
        return self.add("bufferViews", view)

    def float_accessor(self, rows, has_bounds=False, target=ARRAY_BUFFER):
        rows = [[snapped(number) for number in row] for row in rows]
        width = len(rows[0])
        data = b"".join(struct.pack(f"<{width}f", *row) for row in rows)
        accessor = {"bufferView": self.view(data, target), "componentType": FLOAT, "count": len(rows),
                    "type": {1: "SCALAR", 16: "MAT4"}.get(width, f"VEC{width}")}
        if has_bounds:
            accessor["min"] = [min(column) for column in zip(*rows)]
            accessor["max"] = [max(column) for column in zip(*rows)]
        return self.add("accessors", accessor)

    def sparse_accessor(self, rows):
        """Rows that are mostly zero: only the others are stored."""
        places = [i for i, row in enumerate(rows) if any(snapped(number) for number in row)]
        indices = self.view(struct.pack(f"<{len(places)}H", *places), None)
        values = self.view(b"".join(struct.pack("<3f", *(snapped(number) for number in rows[i])) for i in places), None)
        columns = list(zip(*([snapped(number) for number in row] for row in rows)))
        return self.add("accessors", {"componentType": FLOAT, "count": len(rows), "type": "VEC3", "sparse": {
            "count": len(places), "indices": {"bufferView": indices, "componentType": UNSIGNED_SHORT},
            "values": {"bufferView": values}}, "min": [min(column) for column in columns],
            "max": [max(column) for column in columns]})

    def byte_accessor(self, rows, target=None):
        width = len(rows[0])
        data = b"".join(struct.pack(f"<{width}B", *row) for row in rows)
        return self.add("accessors", {"bufferView": self.view(data, target), "componentType": UNSIGNED_BYTE,
                                      "count": len(rows), "type": "SCALAR" if width == 1 else f"VEC{width}"})

    def index_accessor(self, indices):
        data = struct.pack(f"<{len(indices)}H", *indices)
        return self.add("accessors", {"bufferView": self.view(data, ELEMENT_ARRAY_BUFFER),
                                      "componentType": UNSIGNED_SHORT, "count": len(indices), "type": "SCALAR"})

    def primitive(self, geometry, material):
        if id(geometry) not in self.accessors_of:
            attributes = {"POSITION": self.float_accessor(geometry.positions, has_bounds=True),
                          "NORMAL": self.float_accessor(geometry.normals)}
            if geometry.texcoords:
                attributes["TEXCOORD_0"] = self.float_accessor(geometry.texcoords)
            # The geometry is kept with its accessors, so that its id stays its own.
            self.accessors_of[id(geometry)] = (geometry, attributes, self.index_accessor(geometry.indices))
        _, attributes, indices = self.accessors_of[id(geometry)]
        return {"attributes": attributes, "indices": indices, "material": material}

    def mesh(self, name, *parts):
        """Each part is a pair (geometry, material)."""
        return self.add("meshes", {"name": name, "primitives": [self.primitive(*part) for part in parts]})

    # --- motion ------------------------------------------------------------------------------------------------

    def channel(self, animation, target, times, rows, interpolation="LINEAR"):
        """`target` is (node, path), or a JSON pointer; the rows of a flag are true or false."""
        is_flag = isinstance(rows[0][0], bool)
        samplers = self.json["animations"][animation]["samplers"]
        samplers.append({"input": self.float_accessor([[time] for time in times], True, None),
                         "output": self.byte_accessor(rows) if is_flag else self.float_accessor(rows, False, None),
                         "interpolation": interpolation})
        if isinstance(target, str):
            self.use("KHR_animation_pointer")
            place = {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": target}}}
        else:
            place = {"node": target[0], "path": target[1]}
        self.json["animations"][animation]["channels"].append({"sampler": len(samplers) - 1, "target": place})

    # --- nodes -------------------------------------------------------------------------------------------------

    def node(self, name, parent=None, **properties):
        """A node of the scene, or of `parent`. Translation [m], rotation as a quaternion (x, y, z, w)."""
        index = self.add("nodes", {"name": name, **{key: rounded(value) for key, value in properties.items()}})
        siblings = self.json["scenes"][0]["nodes"] if parent is None else \
            self.json["nodes"][parent].setdefault("children", [])
        siblings.append(index)
        return index

    def camera(self, name, yfov, aspect_ratio, znear, **placement):
        """A perspective camera; `yfov` is the full vertical angle [rad], `znear` in metres."""
        camera = self.add("cameras", {"name": name, "type": "perspective", "perspective": {
            "yfov": rounded(float(yfov)), "aspectRatio": rounded(float(aspect_ratio)), "znear": znear}})
        return self.node(name, camera=camera, **placement)

    def light(self, extension, light, **placement):
        """A light of KHR_lights_punctual (cd, lx) or EXT_lights_area (cd/m²) on a node of its own."""
        self.use(extension)
        lights = self.json.setdefault("extensions", {}).setdefault(extension, {"lights": []})["lights"]
        lights.append({key: rounded(value) for key, value in light.items()})
        return self.node(light["name"], extensions={extension: {"light": len(lights) - 1}}, **placement)

    def text(self):
        data = base64.b64encode(bytes(self.binary)).decode("ascii")
        buffers = [{"byteLength": len(self.binary), "uri": "data:application/octet-stream;base64," + data}]
        return laid_out({**self.json, "buffers": buffers}) + "\n"


def laid_out(value, indent=""):
    """JSON with one line for whatever fits on a line."""
    line = json.dumps(value, ensure_ascii=True)
    if len(indent) + len(line) <= 110 or not isinstance(value, (dict, list)):
        return line
    inner = indent + " "
    if isinstance(value, dict):
        items = [f"{inner}{json.dumps(key)}: {laid_out(item, inner)}" for key, item in value.items()]
        return "{\n" + ",\n".join(items) + "\n" + indent + "}"
    return "[\n" + ",\n".join(inner + laid_out(item, inner) for item in value) + "\n" + indent + "]"
