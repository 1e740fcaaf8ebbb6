"""Reads scene.bin of a store folder: a size-prefixed FlatBuffer (schemas/market-scene-1.fbs).

Only what the judge needs, with the standard library: structs are laid out as the schema declares
them, table fields by their number. Nothing here comes from the program's own reader."""
import struct

SCENE_FIXTURES, SCENE_SHELVES, SCENE_FACINGS, SCENE_PRODUCTS, SCENE_CATALOG = 3, 5, 6, 7, 9
FIXTURE = struct.Struct("<4I3fi2I")
SHELF = struct.Struct("<Iiii3f4f3fi")
FACING = struct.Struct("<IIff4H2I")
PRODUCT = struct.Struct("<II3f4fI")
PRODUCT_FIELDS = {"sku": 0, "name": 3, "name_zh": 4, "variant": 5, "category": 8, "subcategory": 9}
KEYWORDS = 10
USE_STAND = 0
FLAG_MISPLACED, FLAG_FRONT = 1, 2


class Buffer:
    def __init__(self, data):
        (size,) = struct.unpack_from("<I", data, 0)
        if size + 4 > len(data):
            raise ValueError("scene.bin is cut off")
        self.data = data[4:]
        self.root = self.word(0)

    def word(self, at):
        return struct.unpack_from("<I", self.data, at)[0]

    def field(self, table, number):
        """Where the field stands, 0 when it is left out."""
        vtable = table - struct.unpack_from("<i", self.data, table)[0]
        size = struct.unpack_from("<H", self.data, vtable)[0]
        slot = 4 + 2 * number
        offset = struct.unpack_from("<H", self.data, vtable + slot)[0] if slot < size else 0
        return table + offset if offset else 0

    def vector(self, table, number):
        """(where its first element stands, how many there are)"""
        at = self.field(table, number)
        if not at:
            return 0, 0
        at += self.word(at)
        return at + 4, self.word(at)

    def structs(self, number, layout):
        at, count = self.vector(self.root, number)
        return list(layout.iter_unpack(self.data[at:at + count * layout.size])) if count else []

    def text_at(self, at):
        at += self.word(at)
        return self.data[at + 4:at + 4 + self.word(at)].decode("utf8")

    def text(self, table, number):
        at = self.field(table, number)
        return self.text_at(at) if at else ""


def read_catalog(buffer):
    at, count = buffer.vector(buffer.root, SCENE_CATALOG)
    rows = []
    for i in range(count):
        table = at + 4 * i
        table += buffer.word(table)
        row = {name: buffer.text(table, number) for name, number in PRODUCT_FIELDS.items()}
        first, words = buffer.vector(table, KEYWORDS)
        row["keywords"] = [buffer.text_at(first + 4 * w) for w in range(words)]
        rows.append(row)
    return rows


def read_scene(path):
    with open(path, "rb") as file:
        buffer = Buffer(file.read())
    fixtures = [{"x": f[4], "y": f[5], "quarter_turns": f[7]} for f in buffer.structs(SCENE_FIXTURES, FIXTURE)]
    shelves = [{"fixture": s[0], "level": s[1], "side": s[2], "use": s[3], "z": s[6], "width": s[11]}
               for s in buffer.structs(SCENE_SHELVES, SHELF)]
    facings = [{"shelf": f[0], "sku": f[1], "width": f[3], "items": f[9]} for f in buffer.structs(SCENE_FACINGS, FACING)]
    products = [{"sku": p[0], "facing": p[1], "position": p[2:5], "rotation": p[5:9], "flags": p[9]}
                for p in buffer.structs(SCENE_PRODUCTS, PRODUCT)]
    return {"fixtures": fixtures, "shelves": shelves, "facings": facings, "products": products,
            "catalog": read_catalog(buffer)}
