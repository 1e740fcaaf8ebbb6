"""Does one job for the marketgen program: a JSON request on standard input, a JSON answer on standard output.

    python worker.py parts            which outside libraries are there: {"coacd": "1.0.14"}
    python worker.py convex_pieces    a closed or open triangle mesh cut into convex pieces by CoACD
    python worker.py film             pictures of a folder as an MP4 file, by PyAV
    python worker.py read_usd         what OpenUSD finds in a store's USD export

A job that cannot be done ends with status 1 and one line on standard error.
"""

import fractions
import json
import math
import os
import sys
from importlib import metadata


def parts(_request):
    found = {}
    for name in ("coacd", "av", "usd-core"):
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            pass
    return found


def convex_pieces(request):
    """positions: [x, y, z, ...] in metres, triangles: [a, b, c, ...]; answers pieces: [[x, y, z, ...], ...]."""
    import coacd
    import numpy

    coacd.set_log_level("off")
    mesh = coacd.Mesh(
        numpy.asarray(request["positions"], dtype=numpy.float64).reshape(-1, 3),
        numpy.asarray(request["triangles"], dtype=numpy.int32).reshape(-1, 3),
    )
    # decimate bounds the points of a piece by max_ch_vertex; the seed makes the tree search repeatable.
    pieces = coacd.run_coacd(
        mesh,
        threshold=request["threshold"],
        max_convex_hull=request["max_pieces"],
        preprocess_mode="auto",
        decimate=True,
        max_ch_vertex=request["max_points"],
        seed=0,
    )
    # 0.01 mm: below any tolerance of ours, and the same text for the last bits of any machine.
    return {"pieces": [[round(float(v), 5) for v in numpy.asarray(points).ravel()] for points, _ in pieces]}


# Whichever the installed PyAV has, most widely played first.
FILM_CODECS = (("libx264", {"crf": "23", "preset": "medium"}), ("libsvtav1", {"crf": "30"}), ("mpeg4", {"q": "4"}))


def film(request):
    """folder of 000000.png ..., film, pictures, frame_rate; answers codec."""
    import av

    codec, options = next(entry for entry in FILM_CODECS if entry[0] in av.codecs_available)
    rate = round(request["frame_rate"])
    with av.open(request["film"], "w", format="mp4", options={"movflags": "+faststart"}) as movie:
        stream = None
        for number in range(request["pictures"]):
            with av.open(os.path.join(request["folder"], f"{number:06}.png")) as picture:
                frame = next(picture.decode(video=0))
            if stream is None:
                stream = movie.add_stream(codec, rate=rate, options=options)
                stream.width, stream.height, stream.pix_fmt = frame.width, frame.height, "yuv420p"
            frame = frame.reformat(format="yuv420p")
            frame.pts, frame.time_base = number, fractions.Fraction(1, rate)
            movie.mux(stream.encode(frame))
        movie.mux(stream.encode())
    return {"codec": codec}


class UsdExport:
    """A store's USD export as OpenUSD composes it: metres, kilograms, radians, the store frame."""

    def __init__(self, file):
        from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

        self.Usd, self.UsdGeom, self.UsdPhysics, self.UsdShade = Usd, UsdGeom, UsdPhysics, UsdShade
        self.stage = Usd.Stage.Open(file)
        self.places = UsdGeom.XformCache()
        self.faults = [str(error) for error in self.stage.GetCompositionErrors()]

    def place(self, prim):
        """Of the prim's frame: position, and rotation w, x, y, z."""
        matrix = self.places.GetLocalToWorldTransform(prim)
        rotation = matrix.ExtractRotationQuat()
        return list(matrix.ExtractTranslation()), [rotation.GetReal(), *rotation.GetImaginary()]

    def items(self):
        for group in self.stage.GetPrimAtPath("/Shop/goods").GetChildren():
            for prim in group.GetChildren():
                if prim.IsInstance():
                    yield prim

    def bound(self, prim, purpose="allPurpose"):
        return self.UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial(purpose)[0]

    def mass(self, prim):
        return self.UsdPhysics.MassAPI(prim).GetMassAttr().Get() if prim.HasAPI(self.UsdPhysics.MassAPI) else 0.0

    def products(self):
        found = []
        for prim in self.items():
            position, rotation = self.place(prim)
            sku = str(prim.GetAssetInfoByKey("name"))
            found.append({"id": prim.GetDisplayName(), "sku": sku, "position": position, "rotation": rotation})
        return found

    def goods(self):
        """Mass and sliding friction of every SKU, from one item of each prototype."""
        found, seen = [], set()
        for prim in self.items():
            prototype = prim.GetPrototype().GetPath()
            if prototype in seen:
                continue
            seen.add(prototype)
            frictions, mass = set(), 0.0
            for part in self.Usd.PrimRange(prim.GetPrototype()):
                if part.HasAPI(self.UsdPhysics.CollisionAPI):
                    material = self.bound(part, "physics")
                    frictions.add(self.UsdPhysics.MaterialAPI(material).GetStaticFrictionAttr().Get() if material else 0.0)
                    mass += self.mass(part)
            if len(frictions) != 1:
                self.faults.append(f"{prim.GetPath()} has {len(frictions)} frictions")
            mass = self.mass(prim) or mass  # a body's own counts before that of what it is made up of
            sku = str(prim.GetAssetInfoByKey("name"))
            found.append({"sku": sku, "mass_kg": mass, "friction": max(frictions, default=0.0)})
        return found

    def joint(self, prim):
        """A hinge or slide, at position 0; UsdPhysics counts its angles in degrees."""
        physics, hinge = self.UsdPhysics, prim.IsA(self.UsdPhysics.RevoluteJoint)
        joint = physics.RevoluteJoint(prim) if hinge else physics.PrismaticJoint(prim)
        drive = physics.DriveAPI(prim, "angular" if hinge else "linear")
        unit = math.pi / 180 if hinge else 1
        places = []
        for bodies, at in ((joint.GetBody0Rel(), joint.GetLocalPos0Attr()), (joint.GetBody1Rel(), joint.GetLocalPos1Attr())):
            body = self.stage.GetPrimAtPath(bodies.GetTargets()[0])
            places.append((body, self.places.GetLocalToWorldTransform(body), at.Get()))
        (_, world, local), (moved, moved_world, moved_local) = places
        at = world.Transform(local)
        if (at - moved_world.Transform(moved_local)).GetLength() > 1e-4:
            self.faults.append(f"the bodies of {prim.GetPath()} do not meet")
        axis = world.TransformDir(joint.GetLocalRot0Attr().Get().Transform((0, 0, 1)))
        extra = {key: prim.GetAttribute(f"marketgen:joint:{name}").Get() for key, name in JOINT_NUMBERS.items()}
        return {
            "name": prim.GetDisplayName(),
            "kind": "hinge" if hinge else "slide",
            "at": list(at),
            "axis": list(axis),
            "lower": max(joint.GetLowerLimitAttr().Get() * unit, -ENDLESS),
            "upper": min(joint.GetUpperLimitAttr().Get() * unit, ENDLESS),
            "damping": drive.GetDampingAttr().Get() / unit,
            "stiffness": drive.GetStiffnessAttr().Get() / unit,
            "spring_rest": drive.GetTargetPositionAttr().Get() * unit,
            "mass_kg": physics.MassAPI(moved).GetMassAttr().Get(),
            **extra,
        }

    def belt(self, prim):
        at, _ = self.place(prim)
        axis = self.places.GetLocalToWorldTransform(prim).TransformDir((0, 0, 1))
        return {
            "name": prim.GetDisplayName(),
            "kind": "belt",
            "at": at,
            "axis": list(axis),
            "lower": prim.GetAttribute("marketgen:joint:min").Get(),
            "upper": prim.GetAttribute("marketgen:joint:max").Get(),
            "mass_kg": self.UsdPhysics.MassAPI(prim).GetMassAttr().Get(),
        }

    def joints(self, fixtures):
        found = []
        for fixture in fixtures:
            for prim in fixture.GetChildren():
                if prim.IsA(self.UsdPhysics.RevoluteJoint) or prim.IsA(self.UsdPhysics.PrismaticJoint):
                    found.append(self.joint(prim))
                elif prim.GetAttribute("marketgen:joint:kind").Get() == "belt":
                    found.append(self.belt(prim))
        return found

    def meshes(self):
        """How many are drawn from; each must have a material whose pictures are there."""
        count = 0
        for root in (self.stage.GetPseudoRoot(), *self.stage.GetPrototypes()):
            for prim in self.Usd.PrimRange(root):
                if prim.IsA(self.UsdGeom.Mesh):
                    count += 1
                    guide = self.UsdGeom.Imageable(prim).ComputePurpose() == "guide"
                    if not guide and not self.bound(prim):
                        self.faults.append(f"{prim.GetPath()} has no material")
                picture = prim.GetAttribute("inputs:file").Get() if prim.IsA(self.UsdShade.Shader) else None
                if picture is not None and not picture.resolvedPath:
                    self.faults.append(f"{prim.GetPath()} shows {picture.path}, which is not there")
        return count


ENDLESS = 1e6  # for no limit, of which JSON has none
JOINT_NUMBERS = {"friction": "friction", "gasket": "gasket", "gasket_reach": "gasketReach", "hold_open_factor": "holdOpenFactor"}


def read_usd(request):
    """file; answers what is in it, and `faults`: what OpenUSD cannot find or put together."""
    export = UsdExport(request["file"])
    fixtures = list(export.stage.GetPrimAtPath("/Shop/fixtures").GetChildren())
    tokens = export.UsdGeom.Tokens
    box = export.UsdGeom.BBoxCache(export.Usd.TimeCode.Default(), [tokens.default_, tokens.guide])
    bounds = [box.ComputeWorldBound(export.stage.GetPrimAtPath(f"/Shop/{part}")).ComputeAlignedRange() for part in ("room", "fixtures", "goods")]
    bounds = [one for one in bounds if not one.IsEmpty()]
    answer = {
        "fixtures": [prim.GetDisplayName() for prim in fixtures],
        "products": export.products(),
        "goods": export.goods(),
        "free_bodies": sum(prim.HasAPI(export.UsdPhysics.RigidBodyAPI) for prim in export.items()),
        "joints": export.joints(fixtures),
        "meshes": export.meshes(),
        "low": [min(one.GetMin()[axis] for one in bounds) for axis in range(3)],
        "high": [max(one.GetMax()[axis] for one in bounds) for axis in range(3)],
    }
    return {**answer, "faults": export.faults[:20]}


JOBS = {"parts": parts, "convex_pieces": convex_pieces, "film": film, "read_usd": read_usd}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in JOBS:
        print(f"usage: python worker.py {'|'.join(JOBS)}", file=sys.stderr)
        return 2
    # Libraries that print must not spoil the answer.
    answer = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    text = sys.stdin.read()
    try:
        result = JOBS[sys.argv[1]](json.loads(text) if text.strip() else {})
    except Exception as fault:  # whatever it is, the program only needs to know that the job was not done
        print(f"{type(fault).__name__}: {fault}", file=sys.stderr)
        return 1
    with answer:
        json.dump(result, answer, separators=(",", ":"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
