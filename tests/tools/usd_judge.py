"""Holds a USD export against its store, with OpenUSD alone: validators, poses, masses, friction, labels, joints, materials.

python usd_judge.py shop.usda STORE shop.glb shop.xml summary.json

What the store has is read from its other exports: poses from the GLB, masses and frictions from the MJCF.
"""

import json
import math
import pathlib
import struct
import sys
import xml.etree.ElementTree

from pxr import Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdShade, UsdValidation

file, store, glb, mjcf, summary = map(pathlib.Path, sys.argv[1:])
stage = Usd.Stage.Open(str(file))
assert not stage.GetCompositionErrors(), stage.GetCompositionErrors()[:3]

# The stage as a whole.
assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1.0
shop = stage.GetDefaultPrim()
assert shop.GetPath() == "/Shop"
assert {child.GetName() for child in shop.GetChildren()} >= {"physics", "room", "fixtures", "goods", "lights", "price_labels"}
scenes = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.Scene)]
assert len(scenes) == 1, scenes

context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
found = context.Validate(stage)
assert not found, [error.GetErrorAsString() for error in found[:5]]

# Every item.
data = glb.read_bytes()
nodes = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])["nodes"]
wanted = {node["name"]: node for node in nodes if "sku" in node.get("extras", {})}
places = UsdGeom.XformCache()
worst_mm = worst_deg = 0.0
free = 0
seen = set()
for group in stage.GetPrimAtPath("/Shop/goods").GetChildren():
    for prim in group.GetChildren():
        if prim.IsA(UsdPhysics.Joint):
            continue
        assert prim.IsInstance(), prim.GetPath()
        row = wanted[prim.GetDisplayName()]
        seen.add(prim.GetDisplayName())
        sku = row["extras"]["sku"]
        assert prim.GetAssetInfoByKey("name") == sku
        matrix = places.GetLocalToWorldTransform(prim)
        at = matrix.ExtractTranslation()
        worst_mm = max(worst_mm, 1000 * math.dist(at, row["translation"]))
        rotation = matrix.ExtractRotationQuat()
        x, y, z, w = row["rotation"]
        # The vector part of the rotation from one to the other.
        a = (rotation.GetReal(), *rotation.GetImaginary())
        apart = (
            a[0] * x - a[1] * w - a[2] * z + a[3] * y,
            a[0] * y - a[2] * w - a[3] * x + a[1] * z,
            a[0] * z - a[3] * w - a[1] * y + a[2] * x,
        )
        worst_deg = max(worst_deg, math.degrees(2 * math.asin(min(1.0, math.hypot(*apart)))))
        free += prim.HasAPI(UsdPhysics.RigidBodyAPI)
        labels = {name: list(UsdSemantics.LabelsAPI(prim, name).GetLabelsAttr().Get()) for name in ("class", "category", "sku")}
        assert labels["sku"] == [sku] and all(len(words) == 1 and words[0] for words in labels.values()), labels
assert seen == set(wanted), f"{len(seen)} of {len(wanted)}"
assert worst_mm <= 0.1 and worst_deg <= 0.01, (worst_mm, worst_deg)
assert free == json.loads(summary.read_text())["free_bodies"] > 0

# Mass and friction, by prototype; and what is drawn has a material.
classes = xml.etree.ElementTree.parse(mjcf).getroot().iter("default")
geoms = {entry.get("class")[4:]: entry.find("geom") for entry in classes if (entry.get("class") or "").startswith("sku/")}
masses = {sku: float(geom.get("mass")) for sku, geom in geoms.items()}
frictions = {sku: float(geom.get("friction").split()[0]) for sku, geom in geoms.items()}
checked = set()
for group in stage.GetPrimAtPath("/Shop/goods").GetChildren():
    for prim in group.GetChildren():
        if not prim.IsInstance() or prim.GetPrototype().GetPath() in checked:
            continue
        checked.add(prim.GetPrototype().GetPath())
        sku = prim.GetAssetInfoByKey("name")
        parts = list(Usd.PrimRange(prim.GetPrototype()))
        colliders = [part for part in parts if part.HasAPI(UsdPhysics.CollisionAPI)]
        assert colliders, prim.GetPath()
        mass = UsdPhysics.MassAPI(prim if prim.HasAPI(UsdPhysics.RigidBodyAPI) else colliders[0]).GetMassAttr().Get()
        assert abs(mass - masses[sku]) <= 1e-5 * masses[sku], (sku, mass)
        for part in colliders:
            material, _ = UsdShade.MaterialBindingAPI(part).ComputeBoundMaterial("physics")
            rubs = UsdPhysics.MaterialAPI(material)
            assert abs(rubs.GetStaticFrictionAttr().Get() - frictions[sku]) < 1e-5, sku
            assert rubs.GetDynamicFrictionAttr().Get() == rubs.GetStaticFrictionAttr().Get()
        drawn = [part for part in parts if part.IsA(UsdGeom.Mesh) and UsdGeom.Imageable(part).ComputePurpose() == "default"]
        assert drawn and all(UsdShade.MaterialBindingAPI(part).ComputeBoundMaterial()[0] for part in drawn), sku

# Every joint, in degrees; its bodies meet in it.
layout = {fixture["id"] for fixture in json.loads((store / "layout.json").read_text())["fixtures"]}
fixtures = list(stage.GetPrimAtPath("/Shop/fixtures").GetChildren())
assert {prim.GetDisplayName() for prim in fixtures} <= layout
joints = wheels = 0
for fixture in fixtures:
    for prim in fixture.GetChildren():
        joint = UsdPhysics.RevoluteJoint(prim)
        if not joint:
            continue
        joints += 1
        assert fixture.HasAPI(UsdPhysics.ArticulationRootAPI)
        low, high = joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()
        wheel = math.isinf(low) and math.isinf(high)
        wheels += wheel
        assert wheel or (low <= 0 <= high and 5 < high - low <= 720), (prim.GetPath(), low, high)
        assert joint.GetAxisAttr().Get() == "Z"
        ends = []
        for bodies, local in ((joint.GetBody0Rel(), joint.GetLocalPos0Attr()), (joint.GetBody1Rel(), joint.GetLocalPos1Attr())):
            body = stage.GetPrimAtPath(bodies.GetTargets()[0])
            assert body.HasAPI(UsdPhysics.RigidBodyAPI)
            ends.append(places.GetLocalToWorldTransform(body).Transform(local.Get()))
        assert (ends[0] - ends[1]).GetLength() < 1e-4, prim.GetPath()
assert joints > wheels > 0, (joints, wheels)
print(f"OpenUSD {'.'.join(map(str, Usd.GetVersion()))}: {len(seen)} items, {free} free, {joints} hinges, worst {worst_mm:.4f} mm, {worst_deg:.5f} degrees; its validators find nothing")
