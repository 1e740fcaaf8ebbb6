"""Free goods settle in MuJoCo from a USD file as they do in our own world, and from our MJCF.

python usd_physics.py shop.usda shop.xml shop REGION    # of the files' free goods, of the store

Once as they were stocked, and once let fall from 5 mm above.

Of the USD file everything is taken that it says: colliders with their poses and sizes, masses, centres of mass, inertia, friction. What
UsdPhysics has no words for (how contacts are solved, rolling friction) is MuJoCo's as our MJCF sets it. Our own world takes friction
of each pair of materials and lets what rests sleep; bags and pouches are rigid there, as files have them. Of at least 500 goods 99 %
must end within 5 mm and 2 degrees of one another in each two of the three.
"""

import itertools
import math
import statistics
import sys

import mujoco
import numpy
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdShade

import marketgen

SECONDS, LIFTS_M = 2.0, (0.0, 0.005)
MIN_GOODS, NEAR_MM, NEAR_DEGREES, SHARE = 500, 5, 2, 0.99
usd, mjcf, folder, region_text = sys.argv[1:]
store, region = marketgen.open_store(folder), [float(side) for side in region_text.split(",")]
ours = mujoco.MjModel.from_xml_path(mjcf)
stage = Usd.Stage.Open(usd)
places = UsdGeom.XformCache()


def pose(matrix):
    rotation = matrix.ExtractRotationQuat()
    return list(matrix.ExtractTranslation()), [rotation.GetReal(), *rotation.GetImaginary()]


def friction(prim):
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
    return UsdPhysics.MaterialAPI(material).GetDynamicFrictionAttr().Get()


spec = mujoco.MjSpec()
spec.option.timestep = ours.opt.timestep
spec.option.integrator, spec.option.cone = ours.opt.integrator, ours.opt.cone
spec.option.impratio, spec.option.noslip_iterations = ours.opt.impratio, ours.opt.noslip_iterations
spec.memory = 1 << 30
spec.compiler.balanceinertia = True
# Of our MJCF, by the name of the item's first geom: condim, and the two frictions that UsdPhysics lacks.
contact = {}
for geom in range(ours.ngeom):
    contact[ours.geom(geom).name] = (ours.geom_condim[geom], ours.geom_friction[geom][1:])
contact_time = next(ours.geom_solref[geom] for geom in range(ours.ngeom))


def add_collider(body, prim, matrix, item):
    """The collider as a geom of `body`; `matrix` is its place there."""
    geom = body.add_geom()
    condim, rest = contact.get(item, (3, (0.005, 0.0001)))
    geom.condim, geom.friction, geom.solref = condim, [friction(prim), *rest], contact_time
    if prim.IsA(UsdGeom.Plane):
        geom.type, geom.size = mujoco.mjtGeom.mjGEOM_PLANE, [0, 0, 1]
    elif prim.IsA(UsdGeom.Cube):
        scale = [Gf.Vec3d(*matrix.GetRow3(axis)).GetLength() for axis in range(3)]
        size = UsdGeom.Cube(prim).GetSizeAttr().Get()
        geom.type, geom.size = mujoco.mjtGeom.mjGEOM_BOX, [size * s / 2 for s in scale]
        matrix = matrix.GetOrthonormalized()
    elif prim.IsA(UsdGeom.Cylinder):
        shape = UsdGeom.Cylinder(prim)
        assert shape.GetAxisAttr().Get() == "Z"
        geom.type, geom.size = mujoco.mjtGeom.mjGEOM_CYLINDER, [shape.GetRadiusAttr().Get(), shape.GetHeightAttr().Get() / 2, 0]
    else:
        assert UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get() == "convexHull"
        name = f"mesh-{len(spec.meshes)}"
        mesh = spec.add_mesh(name=name)
        mesh.uservert = numpy.asarray(UsdGeom.Mesh(prim).GetPointsAttr().Get(), dtype=float).ravel()
        geom.type, geom.meshname = mujoco.mjtGeom.mjGEOM_MESH, name
    geom.pos, geom.quat = pose(matrix)


def colliders(root):
    return [prim for prim in Usd.PrimRange(root, Usd.TraverseInstanceProxies()) if prim.HasAPI(UsdPhysics.CollisionAPI)]


free = []
for prim in Usd.PrimRange(stage.GetDefaultPrim()):
    if prim.IsInstance() and prim.GetPath().HasPrefix("/Shop/goods") and prim.HasAPI(UsdPhysics.RigidBodyAPI):
        item, world = prim.GetDisplayName(), places.GetLocalToWorldTransform(prim)
        free.append(item)
        at, turn = pose(world)
        body = spec.worldbody.add_body(name=item, pos=at, quat=turn)
        body.add_freejoint()
        mass = UsdPhysics.MassAPI(prim)
        axes = mass.GetPrincipalAxesAttr().Get()
        body.explicitinertial = True
        body.mass, body.ipos = mass.GetMassAttr().Get(), list(mass.GetCenterOfMassAttr().Get())
        body.inertia, body.iquat = list(mass.GetDiagonalInertiaAttr().Get()), [axes.GetReal(), *axes.GetImaginary()]
        for part in colliders(prim):
            add_collider(body, part, places.GetLocalToWorldTransform(part) * world.GetInverse(), item)
    elif prim.IsInstance() or prim.HasAPI(UsdPhysics.CollisionAPI):
        item = prim.GetDisplayName() if prim.GetPath().HasPrefix("/Shop/goods") else ""
        for part in colliders(prim):
            add_collider(spec.worldbody, part, places.GetLocalToWorldTransform(part), item)
for prim in stage.Traverse():
    joint = UsdPhysics.SphericalJoint(prim)
    if joint:
        body = stage.GetPrimAtPath(joint.GetBody1Rel().GetTargets()[0]).GetDisplayName()
        hook = spec.add_equality(type=mujoco.mjtEq.mjEQ_CONNECT, name1=body, objtype=mujoco.mjtObj.mjOBJ_BODY)
        hook.data[:3] = list(joint.GetLocalPos1Attr().Get())

theirs = spec.compile()
hooked = {model.body(model.eq_obj1id[i]).name for model in (ours, theirs) for i in range(model.neq)}
assert len(free) == sum(ours.jnt_type == mujoco.mjtJoint.mjJNT_FREE) >= MIN_GOODS, len(free)
masses = sum(theirs.body(item).mass[0] for item in free), sum(ours.body(item).mass[0] for item in free)
assert abs(masses[0] - masses[1]) < 1e-4 * masses[1], masses


def settled(model, lift):
    """(position, quaternion) of each free item after SECONDS in MuJoCo, raised by `lift` before."""
    data = mujoco.MjData(model)
    for item in free:
        if item not in hooked:
            data.joint(model.body(item).jntadr[0]).qpos[2] += lift
    while data.time < SECONDS - model.opt.timestep / 2:
        mujoco.mj_step(model, data)
    assert numpy.isfinite(data.qpos).all()
    mujoco.mj_kinematics(model, data)  # of the last step's end
    return {item: (data.body(item).xpos.copy(), data.body(item).xquat.copy()) for item in free}


def settled_here(lift):
    """The same in a world of our own."""
    ends = store.settle(region, seconds=SECONDS, lift_m=lift, soft=False)
    assert sorted(end["id"] for end in ends) == sorted(free)
    return {end["id"]: (numpy.array(end["pose"][:3]), numpy.array(end["pose"][3:])) for end in ends}


def apart(one, other):
    """Millimetres and degrees."""
    (at, turn), (at2, turn2) = one, other
    mm = 1000 * float(numpy.linalg.norm(at - at2))
    return mm, math.degrees(2 * math.acos(min(1.0, abs(float(turn @ turn2)))))


for lift in LIFTS_M:
    ends = {"our own world": settled_here(lift), "MuJoCo from MJCF": settled(ours, lift), "MuJoCo from USD": settled(theirs, lift)}
    print(f"{len(free)} free goods, {len(hooked)} of them on pegs, {1000 * lift:g} mm above where they stand, after {SECONDS:g} s:")
    for (one, there), (other, here) in itertools.combinations(ends.items(), 2):
        ways = [apart(there[item], here[item]) for item in free]
        near = sum(mm <= NEAR_MM and degrees <= NEAR_DEGREES for mm, degrees in ways)
        worst = max(zip(ways, free, strict=True))
        middle = statistics.median(mm for mm, _ in ways)
        print(
            f"  {one} beside {other}: {near} alike ({100 * near / len(free):.1f} %), {middle:.4f} mm apart in the median, "
            f"at worst {worst[0][0]:.3f} mm and {worst[0][1]:.3f} degrees ({worst[1]})"
        )
        assert near >= SHARE * len(free), (one, other)
