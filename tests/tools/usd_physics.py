"""Free goods settle in MuJoCo from a USD file as from our MJCF, in which they are what they are in our own worlds.

python usd_physics.py shop.usda shop.xml

Of the USD file everything is taken that it says: colliders with their poses and sizes, masses, centres of mass, inertia, friction. What
UsdPhysics has no words for (how contacts are solved, rolling friction) is MuJoCo's as our MJCF sets it. Of at least 500 goods 99 %
must end within 5 mm and 2 degrees of where they end from MJCF.
"""

import math
import sys

import mujoco
import numpy
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdShade

SECONDS = 2.0
usd, mjcf = sys.argv[1:]
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
assert len(free) == sum(ours.jnt_type == mujoco.mjtJoint.mjJNT_FREE) >= 500, len(free)
ends = []
for model in (ours, theirs):
    data = mujoco.MjData(model)
    while data.time < SECONDS:
        mujoco.mj_step(model, data)
    ends.append({item: (data.body(item).xpos.copy(), data.body(item).xquat.copy()) for item in free})
    ids = [model.body(item).id for item in free]
    assert numpy.isfinite(data.qpos).all()
near = 0
worst = (0.0, 0.0)
for item in free:
    (at, turn), (at2, turn2) = ends[0][item], ends[1][item]
    mm = 1000 * float(numpy.linalg.norm(at - at2))
    degrees = math.degrees(2 * math.acos(min(1.0, abs(float(turn @ turn2)))))
    near += mm <= 5 and degrees <= 2
    worst = max(worst, (mm, degrees))
masses = sum(theirs.body(item).mass[0] for item in free), sum(ours.body(item).mass[0] for item in free)
assert abs(masses[0] - masses[1]) < 1e-4 * masses[1], masses
print(f"MuJoCo {mujoco.__version__}: {near} of {len(free)} free goods settle alike from USD and MJCF; the worst is {worst[0]:.2f} mm and {worst[1]:.2f} degrees apart")
assert near >= 0.99 * len(free)
