"""Pinocchio's answers for a robot's row: an outside judge of kinematics and dynamics.

    pinocchio_answers.py ROWS ROBOT FRAME < states

Reads the row and its parts by itself, builds a pinocchio.Model and answers each state on standard input.
Input: the number of joints, their names in the asker's order, the number of states, then q, v, a of each.
Output for each state: the frame's pose (3x4, by rows), its Jacobian (6 x n, by rows; linear above angular,
base axes), the efforts of inverse dynamics, and the mass matrix (n x n).
"""

import json
import math
import sys
from pathlib import Path

import numpy
import pinocchio as pin


def turn(axis, degrees):
    return pin.AngleAxis(math.radians(degrees), numpy.array(axis, dtype=float)).toRotationMatrix()


def placement(row):
    if "dh" in row:
        dh = {"a_mm": 0, "alpha_deg": 0, "d_mm": 0, "offset_deg": 0, **row["dh"]}
        alpha, offset = turn((1, 0, 0), dh["alpha_deg"]), turn((0, 0, 1), dh["offset_deg"])
        shift = numpy.array([dh["a_mm"], 0, 0]) + alpha @ numpy.array([0, 0, dh["d_mm"]])
        return pin.SE3(alpha @ offset, shift / 1000)
    roll, pitch, yaw = row.get("rpy_deg", (0, 0, 0))
    rotation = turn((0, 0, 1), yaw) @ turn((0, 1, 0), pitch) @ turn((1, 0, 0), roll)
    return pin.SE3(rotation, numpy.array(row.get("xyz", (0, 0, 0)), dtype=float))


def inertia(link):
    i = {"xx": 0, "yy": 0, "zz": 0, "xy": 0, "xz": 0, "yz": 0, **link.get("inertia", {})}
    tensor = numpy.array([[i["xx"], i["xy"], i["xz"]], [i["xy"], i["yy"], i["yz"]], [i["xz"], i["yz"], i["zz"]]])
    return pin.Inertia(link.get("mass", 0.0), numpy.array(link.get("center_of_mass", (0, 0, 0)), dtype=float), tensor)


class Tree:
    """A pinocchio.Model of a row and its parts. Joints are made depth first: crba needs every subtree in one piece."""

    def __init__(self, rows, robot):
        self.rows, self.model = rows, pin.Model()
        self.bodies = {}    # full link name -> its row
        self.children = {}  # full link name -> [(joint's full name, joint's row, placement, child's full name)]
        self.frames = {}    # full frame name -> (full link name, placement)
        self.links = {}     # full link name -> (joint id, placement in that joint)
        self.armature = {}  # joint name -> rotor inertia
        self.body(self.collect(robot, ""), 0, pin.SE3.Identity())

    def collect(self, name, prefix):
        """Notes the row and its parts under their full names; returns the name of the row's root link."""
        row = json.loads((self.rows / f"{name}.json").read_text(encoding="utf-8"))
        for link in row["links"]:
            self.bodies[prefix + link["name"]] = link
        for joint in row.get("joints", []):
            below = (prefix + joint["name"], joint, placement(joint), prefix + joint["child"])
            self.children.setdefault(prefix + joint["parent"], []).append(below)
        for frame in row.get("frames", []):
            self.frames[prefix + frame["name"]] = (prefix + frame["link"], placement(frame))
        for part in row.get("parts", []):
            carrier, at = self.frames[prefix + part["at"]]
            root = self.collect(part["row"], prefix + part["prefix"])
            self.children.setdefault(carrier, []).append(("", {"kind": "fixed"}, at, root))
        return prefix + row["links"][0]["name"]

    def body(self, link, joint, at):
        self.links[link] = (joint, at)
        self.model.appendBodyToJoint(joint, inertia(self.bodies[link]), at)
        for name, row, inside, child in self.children.get(link, []):
            self.joint(name, row, joint, at * inside, child)

    def joint(self, name, row, parent, where, child):
        kind, axis = row.get("kind", "revolute"), numpy.array(row.get("axis", (0, 0, 1)), dtype=float)
        if kind == "fixed":
            self.body(child, parent, where)
            return
        made = pin.JointModelPrismaticUnaligned(axis) if kind == "prismatic" else pin.JointModelRevoluteUnaligned(axis)
        index = self.model.addJoint(parent, made, where, name)
        self.armature[name] = row.get("armature", 0.0)
        self.body(child, index, pin.SE3.Identity())

    def frame(self, name):
        link, inside = self.frames[name]
        joint, at = self.links[link]
        return self.model.addFrame(pin.Frame("asked", joint, 0, at * inside, pin.FrameType.OP_FRAME))


def main():
    rows, robot, frame = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    tree = Tree(rows, robot)
    model = tree.model
    model.gravity.linear = numpy.array([0, 0, -9.81])
    frame_id = tree.frame(frame)
    data = model.createData()

    words = sys.stdin.read().split()
    count = int(words[0])
    names, states = words[1:1 + count], int(words[1 + count])
    order = numpy.array([model.joints[model.getJointId(name)].idx_v for name in names])
    rotors = numpy.array([tree.armature[name] for name in names])
    numbers = numpy.array([float(w) for w in words[2 + count:]]).reshape(states, 3, count)
    for asked in numbers:
        q, v, a = (numpy.zeros(model.nv) for _ in range(3))
        q[order], v[order], a[order] = asked
        pin.framesForwardKinematics(model, data, q)
        pose = data.oMf[frame_id]
        jacobian = pin.computeFrameJacobian(model, data, q, frame_id, pin.LOCAL_WORLD_ALIGNED)
        efforts = pin.rnea(model, data, q, v, a)[order] + rotors * asked[2]
        mass = numpy.triu(pin.crba(model, data, q))
        mass = (mass + numpy.triu(mass, 1).T)[numpy.ix_(order, order)] + numpy.diag(rotors)
        answer = [numpy.hstack([pose.rotation, pose.translation[:, None]]), jacobian[:, order], efforts, mass]
        print(" ".join(repr(float(x)) for part in answer for x in numpy.asarray(part).ravel()))


main()
