"""adjust_pos_gl(frames, pose): YP-Spur's Spur_adjust_pos_GL, notes 001, section 3.1: GL is laid anew, and SP is carried along with it.

`frames` holds the pose of each frame in its parent: GL, FS and SP in BS, LC in GL. Afterwards the robot (FS) stands at `pose` in GL, and
SP, with the line that the robot follows, lies in GL where it lay before: so the robot swerves.
"""

import cmath

import numpy as np

from autograder.draws import pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import RecordTolerance, Tolerance

_POSE = Tolerance(axis=-1, angles=(2,))


def reference(frames, pose):
    """Return the frames after one rigid motion of GL and SP, the one that brings GL's point `pose` to the robot.

    This is YP-Spur's way round: not SP in GL is kept, but the robot appears in SP where the wanted pose appeared before.
    """
    robot, gl, sp = frames["FS"], frames["GL"], frames["SP"]
    wanted = complex(gl[0], gl[1]) + complex(pose[0], pose[1]) * cmath.rect(1.0, gl[2])
    turn = robot[2] - gl[2] - pose[2]

    def moved(frame):
        end = complex(robot[0], robot[1]) + (complex(frame[0], frame[1]) - wanted) * cmath.rect(1.0, turn)
        return [end.real, end.imag, frame[2] + turn]

    return {**frames, "GL": moved(gl), "SP": moved(sp)}


def cases(rng):
    """Draw the four frames and the pose afresh: nothing at an origin, but where it is said so."""

    def telling(side, turns=0, **known):
        frames = {name: pose(rng) for name in ("GL", "LC", "FS", "SP")} | known

        def draw():
            wanted = pose(rng)
            wanted[2] = side * (abs(wanted[2]) + 2 * np.pi * turns)
            return frames, wanted

        return until(draw, clear_of_zero)

    def whole():
        frames = {name: rng.integers(1, 6, 3) * rng.choice([-1, 1], 3) for name in ("GL", "LC", "FS", "SP")}
        return frames, rng.integers(1, 6, 3) * rng.choice([-1, 1], 3)

    def rotating(frames, wanted):
        """Tell whether neither GL nor SP comes out in whole numbers again."""
        return clear_of_zero(frames, wanted) and frames["FS"][2] - wanted[2] not in (0, frames["GL"][2])

    listed, wanted = telling(1)
    return [
        Group(
            Text("the robot is to look to the left of GL's x axis", "GL の x 軸より左を向かせる場合"),
            3,
            [telling(1) for _ in range(3)],
        ),
        Group(Text("the robot is to look to the right", "右を向かせる場合"), 3, [telling(-1) for _ in range(3)]),
        Group(Text("headings beyond one turn", "1 回転を超える方位"), 1, [telling(1, 1), telling(-1, 1)]),
        Group(
            Text("GL and FS still at BS's origin", "GL と FS がまだ BS の原点にある場合"),
            1,
            [telling(rng.choice([-1, 1]), GL=np.zeros(3), FS=np.zeros(3))],
        ),
        Group(
            Text("lists and whole numbers", "リストや整数の入力"),
            1,
            [
                until(whole, rotating),
                ({name: listed[name].tolist() for name in ("SP", "FS", "LC", "GL")}, wanted.tolist()),
            ],
        ),
    ]


def clear_of_zero(frames, pose):
    """Are x and y of the new GL and SP far enough from zero that rounding does not matter?"""
    new = reference(frames, pose)
    return min(map(abs, (*new["GL"][:2], *new["SP"][:2]))) > 0.6


def sp_stays(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl}


def only_sp_moved(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def sp_is_gl(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": gl.copy()}


def sp_is_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": np.array(pose, dtype=float)}


def sp_is_the_robot(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": np.array(frames["FS"], dtype=float)}


def sp_shifted_component_by_component(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": np.asarray(frames["SP"]) + gl - np.asarray(frames["GL"])}


def sp_moved_but_not_turned(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    sp = compose(compose(gl, invert(frames["GL"])), frames["SP"])
    sp[2] = frames["SP"][2]
    return {**frames, "GL": gl, "SP": sp}


def sp_turned_but_not_moved(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    turn = gl[2] - frames["GL"][2]
    return {**frames, "GL": gl, "SP": np.array([frames["SP"][0], frames["SP"][1], frames["SP"][2] + turn])}


def sp_turned_about_the_origin_of_bs(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    turn = gl[2] - frames["GL"][2]
    arm = complex(frames["SP"][0], frames["SP"][1]) * np.exp(1j * turn)
    shift = gl - np.asarray(frames["GL"])
    return {**frames, "GL": gl, "SP": np.array([arm.real + shift[0], arm.imag + shift[1], frames["SP"][2] + turn])}


def sp_moved_the_other_way(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(compose(frames["GL"], invert(gl)), frames["SP"])}


def motion_on_the_right_of_sp(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["SP"], compose(invert(frames["GL"]), gl))}


def motion_on_the_right_of_sp_backwards(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["SP"], compose(invert(gl), frames["GL"]))}


def inverse_of_the_old_gl_first(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(compose(invert(frames["GL"]), gl), frames["SP"])}


def sp_taken_in_gl(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(gl, frames["SP"])}


def sp_left_in_gl(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(invert(frames["GL"]), frames["SP"])}


def old_gl_negated_for_sp(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(gl, compose(-np.asarray(frames["GL"]), frames["SP"]))}


def sp_moved_by_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["SP"], invert(pose))}


def sp_seen_from_the_robot(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(invert(frames["FS"]), frames["SP"])}


def lc_moved_as_if_in_bs(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    motion = compose(gl, invert(frames["GL"]))
    return {**frames, "GL": gl, "LC": compose(motion, frames["LC"]), "SP": compose(motion, frames["SP"])}


def lc_kept_in_place(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    motion = compose(gl, invert(frames["GL"]))
    lc = compose(compose(invert(gl), frames["GL"]), frames["LC"])
    return {**frames, "GL": gl, "LC": lc, "SP": compose(motion, frames["SP"])}


def lc_moved_instead_of_sp(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    motion = compose(gl, invert(frames["GL"]))
    return {**frames, "GL": gl, "LC": compose(motion, frames["LC"])}


def robot_carried_along(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    motion = compose(gl, invert(frames["GL"]))
    return {**frames, "GL": gl, "FS": compose(motion, frames["FS"]), "SP": compose(motion, frames["SP"])}


def every_frame_moved(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    motion = compose(gl, invert(frames["GL"]))
    return {name: compose(motion, frame) for name, frame in frames.items()}


def robot_moved_instead(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    return {**frames, "FS": compose(frames["GL"], pose)}


def robot_is_the_pose(frames, pose):
    return {**frames, "FS": np.array(pose, dtype=float)}


def inverse_on_the_wrong_side(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(invert(pose), frames["FS"])
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def inverse_on_the_wrong_side_and_sp_kept(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(invert(pose), frames["FS"])}


def pose_negated_instead_of_inverted(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], -np.asarray(pose))
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def pose_not_inverted(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], pose)
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def gl_is_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = np.array(pose, dtype=float)
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def gl_is_the_inverse_of_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = invert(pose)
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def subtracted_component_by_component(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = np.asarray(frames["FS"]) - np.asarray(pose)
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def gl_moved_back_by_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["GL"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def pose_taken_in_lc(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(compose(frames["LC"], pose)))
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def nothing_changed(frames, pose):
    return {**frames}


def moved_frames_alone_returned(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {"GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def gl_alone_returned(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return compose(frames["FS"], invert(pose))


def whole_numbers_cut_off(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    sp = np.array(frames["SP"])
    sp[:] = compose(compose(gl, invert(frames["GL"])), frames["SP"])
    return {**frames, "GL": gl, "SP": sp}


def rounded(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))

    sp = compose(compose(gl, invert(frames["GL"])), frames["SP"])
    return {**frames, "GL": np.round(gl, 3), "SP": np.round(sp, 3)}


EXERCISE = Exercise(
    name="adjust_pos_gl",
    notebook="odometry/frames",
    points=5,
    parameters=("frames", "pose"),
    quantities=("GL", "LC", "FS", "SP"),
    reference=reference,
    cases=cases,
    tolerance=RecordTolerance((("GL", _POSE), ("LC", _POSE), ("FS", _POSE), ("SP", _POSE))),
    examples=(
        (
            {
                "GL": np.array([0.0, 0.0, 0.0]),
                "FS": np.array([2.0, 1.0, np.pi / 2]),
                "SP": np.array([1.0, 0.0, np.pi / 2]),
                "LC": np.array([1.0, 1.0, 0.0]),
            },
            np.array([2.0, 0.0, 0.0]),
        ),
        (
            {
                "GL": np.array([1.0, -1.0, np.pi / 4]),
                "FS": np.array([3.0, 2.0, -np.pi / 6]),
                "SP": np.array([2.0, 1.0, 0.0]),
                "LC": np.array([0.5, 2.0, np.pi / 2]),
            },
            np.array([1.0, 2.0, np.pi / 3]),
        ),
    ),
    mistakes=(
        Mistake(
            sp_stays,
            Text(
                "GL is right, but SP stays where it was: that is set, and the robot drives on as before. (If you did move "
                "SP: was GL overwritten with the new one before SP was expressed in it? Then the two cancel.)",
                "GL は合っていますが、SP が元のままです。それは set の動作で、ロボットの動きは変わりません。"
                "(SP も計算しているなら、GL を新しい値で上書きしてから SP を GL で表していませんか。それでは"
                "打ち消し合ってしまいます。)",
            ),
        ),
        Mistake(
            only_sp_moved,
            Text(
                "SP is right, but GL still has its old entry: the robot does not appear at pose.",
                "SP は合っていますが、GL の項目が前のままです。これではロボットが pose に見えません。",
            ),
        ),
        Mistake(
            sp_is_gl,
            Text(
                "GL is right, but SP is set to GL as well. SP keeps its place relative to GL: the line need not start at "
                "GL's origin.",
                "GL は合っていますが、SP にも GL と同じ値を入れています。SP は GL との位置関係を保ちます。直線が"
                " GL の原点から始まるとは限りません。",
            ),
        ),
        Mistake(
            sp_is_the_pose,
            Text(
                "GL is right, but pose is stored as SP. pose tells where the robot is to appear in GL; SP is the frame of "
                "the line, carried along with GL.",
                "GL は合っていますが、pose をそのまま SP に入れています。pose は GL の中でロボットが"
                "見えるべき姿勢です。SP は直線の座標系で、GL と一緒に動きます。",
            ),
        ),
        Mistake(
            sp_is_the_robot,
            Text(
                "GL is right, but SP is laid where the robot is: the line would start anew at the robot. SP keeps its place "
                "relative to GL.",
                "GL は合っていますが、SP をロボットの位置に重ねています。それでは直線がロボットから始まり直してしまいます。"
                "SP は GL との位置関係を保ちます。",
            ),
        ),
        Mistake(
            sp_shifted_component_by_component,
            Text(
                "GL and SP's heading are right, but SP's position is shifted by the change of GL's numbers. GL also turns, "
                "and SP swings round with it.",
                "GL と SP の方位は合っていますが、SP の位置を GL の数値の変化分だけずらしています。GL は"
                "回転もするので、SP もそのまわりを回ります。",
            ),
        ),
        Mistake(
            sp_moved_but_not_turned,
            Text(
                "GL and SP's position are right, but SP keeps its old heading. It is fixed to GL and turns with it.",
                "GL と SP の位置は合っていますが、SP の方位が前のままです。SP は GL に固定されているので、一緒に回ります。",
            ),
        ),
        Mistake(
            sp_turned_but_not_moved,
            Text(
                "GL and SP's heading are right, but SP's position stays. It is fixed to GL and moves with it.",
                "GL と SP の方位は合っていますが、SP の位置が前のままです。SP は GL に固定されているので、一緒に動きます。",
            ),
        ),
        Mistake(
            sp_turned_about_the_origin_of_bs,
            Text(
                "GL is right, but SP is turned about BS's origin instead of GL's. Express SP in the old GL first.",
                "GL は合っていますが、SP を GL の原点ではなく BS の原点のまわりに回しています。まず SP を"
                "前の GL で表しましょう。",
            ),
        ),
        Mistake(
            sp_moved_the_other_way,
            Text(
                "GL is right, but SP is moved the opposite way: the old and the new GL are exchanged. Express SP in the old "
                "one, then put it into the new one.",
                "GL は合っていますが、SP の動きが逆です。前の GL と新しい GL が入れ替わっています。SP を"
                "前の GL で表し、それを新しい GL に置きます。",
            ),
        ),
        Mistake(
            motion_on_the_right_of_sp,
            Text(
                "GL is right, but the motion of GL is composed on the right of SP, so that it is carried out along SP's "
                "axes. Walk from BS: new GL, then SP as it lay in the old GL.",
                "GL は合っていますが、GL の動きを SP の右側から合成しているため、SP の軸に沿って動いています。"
                "BS から順にたどりましょう。新しい GL、そして前の GL の中での SP、の順です。",
            ),
        ),
        Mistake(
            motion_on_the_right_of_sp_backwards,
            Text(
                "GL is right, but SP is composed in the wrong order: old and new GL stand on the right of it. Walk from BS: "
                "new GL, then SP as it lay in the old GL.",
                "GL は合っていますが、SP の合成の順序が違い、前後の GL が SP の右側に来ています。"
                "BS から順にたどりましょう。新しい GL、そして前の GL の中での SP、の順です。",
            ),
        ),
        Mistake(
            inverse_of_the_old_gl_first,
            Text(
                "GL is right, but in SP the inverse of the old GL comes first. Walk from BS: the new GL comes first, then SP "
                "as it lay in the old GL.",
                "GL は合っていますが、SP の計算で前の GL の逆が先に来ています。BS から順にたどると、新しい GL が"
                "先で、次が前の GL の中での SP です。",
            ),
        ),
        Mistake(
            sp_taken_in_gl,
            Text(
                "GL is right, but SP is used as if its entry were given in GL. It is given in BS: express it in the old GL "
                "first.",
                "GL は合っていますが、SP の項目が GL の中の姿勢であるかのように使っています。SP は"
                " BS の中の姿勢です。まず前の GL で表しましょう。",
            ),
        ),
        Mistake(
            sp_left_in_gl,
            Text(
                "GL is right, but SP is left as seen from GL. The entry SP is its pose in BS: the way back out, through the "
                "new GL, is missing.",
                "GL は合っていますが、SP が GL から見た姿勢のままです。SP の項目は BS の中の姿勢です。"
                "新しい GL を通って BS へ戻す計算が抜けています。",
            ),
        ),
        Mistake(
            old_gl_negated_for_sp,
            Text(
                "GL is right, but for SP the old GL is inverted by changing its three signs. The inverse of a pose must be "
                "measured along the turned axes; you have invert for it.",
                "GL は合っていますが、SP の計算で前の GL の逆を、3 つの数の符号を変えて作っています。逆変換は"
                "回転した軸に沿って測ります。invert を使いましょう。",
            ),
        ),
        Mistake(
            sp_moved_by_the_pose,
            Text(
                "GL is right, but SP is moved back by pose. It must move just as GL does, from the old GL to the new one.",
                "GL は合っていますが、SP を pose の分だけ戻しています。SP は GL と同じだけ、前の GL から新しい GL へ動きます。",
            ),
        ),
        Mistake(
            sp_seen_from_the_robot,
            Text(
                "GL is right, but SP is given as seen from the robot. The entry SP is its pose in BS, and it moves as GL does.",
                "GL は合っていますが、SP がロボットから見た姿勢になっています。SP の項目は BS の中の姿勢で、"
                "GL と同じだけ動きます。",
            ),
        ),
        Mistake(
            lc_moved_as_if_in_bs,
            Text(
                "GL and SP are right, but LC is moved along as if it were given in BS. LC's entry is its pose in GL: as GL "
                "moves, LC rides along by itself.",
                "GL と SP は合っていますが、LC も BS の中の姿勢であるかのように動かしています。LC の項目は"
                " GL の中の姿勢なので、GL が動けば LC は何もしなくても一緒に動きます。",
            ),
        ),
        Mistake(
            lc_kept_in_place,
            Text(
                "GL and SP are right, but LC is changed so that it stays where it was in BS. LC is a frame on GL: its entry "
                "is its pose in GL, and it rides along.",
                "GL と SP は合っていますが、LC が BS の中で動かないように書き換えています。LC は"
                " GL の上の座標系です。項目は GL の中の姿勢なので、GL と一緒に動きます。",
            ),
        ),
        Mistake(
            lc_moved_instead_of_sp,
            Text(
                "GL is right, but LC is moved instead of SP. LC is given in GL and rides on it; SP is the one that the "
                "robot's line is stored in, and it is given in BS.",
                "GL は合っていますが、SP ではなく LC を動かしています。LC は"
                " GL の中の姿勢なので GL に乗って動きます。ロボットのたどる直線は SP に保存されていて、SP は"
                " BS の中の姿勢です。",
            ),
        ),
        Mistake(
            robot_carried_along,
            Text(
                "GL and SP are right, but the robot, FS, is carried along. A call cannot move the robot: it stays where it "
                "is in BS.",
                "GL と SP は合っていますが、ロボット FS まで一緒に動かしています。関数を呼んでもロボットは動きません。"
                "BS の中の位置はそのままです。",
            ),
        ),
        Mistake(
            every_frame_moved,
            Text(
                "Every frame is moved as GL is. Only GL and SP change: the robot stays where it is, and LC is given in GL "
                "already.",
                "すべての座標系を GL と同じように動かしています。変わるのは GL と SP だけです。ロボットは動かず、LC は"
                "もともと GL の中の姿勢です。",
            ),
        ),
        Mistake(
            robot_moved_instead,
            Text(
                "The robot is moved in BS, and GL stays. A call cannot carry the robot to another place: it is the map, GL, "
                "that is laid anew round the robot.",
                "GL をそのままにして、BS の中でロボットのほうを動かしています。関数を呼んでもロボットは動きません。"
                "ロボットに合わせて座標系 GL を張り替えます。",
            ),
        ),
        Mistake(
            robot_is_the_pose,
            Text(
                "pose is stored as FS. FS holds where the robot is in BS, which a call cannot change: it is GL that is laid "
                "anew.",
                "pose をそのまま FS に入れています。FS は BS の中のロボットの姿勢で、関数を呼んでも変わりません。"
                "張り替えるのは GL です。",
            ),
        ),
        Mistake(
            inverse_on_the_wrong_side,
            Text(
                "The two factors of the new GL are exchanged: the inverse of pose comes first. Walk from BS to GL: first "
                "from BS to the robot, and from there back to GL's origin.",
                "新しい GL を作る合成の順序が逆で、pose の逆が先になっています。BS から GL までたどってみましょう。"
                "まず BS からロボットへ、次にロボットから GL の原点へ戻ります。",
            ),
        ),
        Mistake(
            inverse_on_the_wrong_side_and_sp_kept,
            Text(
                "Two things: in the new GL the inverse of pose comes first, but from BS one goes to the robot first; and SP "
                "stays where it was, as in set.",
                "2 つ違いがあります。新しい GL の合成で pose の逆が先になっています(BS からは"
                "先にロボットへ進みます)。また、SP が set のときのように元のままです。",
            ),
        ),
        Mistake(
            pose_negated_instead_of_inverted,
            Text(
                "pose is inverted by changing its three signs. The inverse of a pose must measure the way back along the "
                "turned axes; you have invert for it.",
                "pose の逆を、3 つの数の符号を変えて作っています。逆変換では、戻る道を回転した軸に沿って測ります。"
                "invert を使いましょう。",
            ),
        ),
        Mistake(
            pose_not_inverted,
            Text(
                "GL is put where pose lies as seen from the robot. It is the other way round: the robot must lie at pose as "
                "seen from GL.",
                "ロボットから見て pose の位置に GL を置いています。逆です。GL から見てロボットが"
                " pose の位置になければなりません。",
            ),
        ),
        Mistake(
            gl_is_the_pose,
            Text(
                "pose is stored as GL. pose tells where the robot is to appear in GL; GL's own entry tells where GL lies in BS.",
                "pose をそのまま GL に入れています。pose は GL の中でロボットが見えるべき姿勢で、GL の項目は"
                " BS の中で GL がどこにあるかです。",
            ),
        ),
        Mistake(
            gl_is_the_inverse_of_the_pose,
            Text(
                "GL is the inverse of pose alone: as if the robot stood at BS's origin. Where it stands in BS is in the "
                "entry FS.",
                "GL が pose の逆だけになっています。これはロボットが BS の原点にいるときの式です。BS の中でロボットが"
                "どこにいるかは、FS の項目にあります。",
            ),
        ),
        Mistake(
            subtracted_component_by_component,
            Text(
                "pose is subtracted from FS number by number. The heading of GL is right so, but x and y of pose are "
                "measured along GL's axes, which are turned in BS.",
                "FS から pose を成分ごとに引いています。GL の方位はそれで合いますが、pose の x, y は"
                " GL の軸に沿った値で、その軸は BS の中で回転しています。",
            ),
        ),
        Mistake(
            gl_moved_back_by_the_pose,
            Text(
                "GL is moved back by pose from where it was; the robot's own pose FS is not used. Only if the robot were at "
                "GL's origin would that be right.",
                "GL を、いまの位置から pose の分だけ戻していて、ロボットの姿勢 FS が使われていません。それで正しいのは、"
                "ロボットが GL の原点にいるときだけです。",
            ),
        ),
        Mistake(
            pose_taken_in_lc,
            Text(
                "pose is taken as given in LC: the robot then appears there at pose, but not in GL.",
                "pose を LC の中の姿勢として扱っています。それではロボットが LC の中で pose に見えるだけで、"
                "GL の中では違います。",
            ),
        ),
        Mistake(
            nothing_changed,
            Text(
                "The frames come back as they were. After the call the robot must appear at pose in GL: which entry has to "
                "change?",
                "座標系が何も変わっていません。呼び出したあと、ロボットは GL の中で pose に見えるはずです。どの項目を"
                "変えればよいですか。",
            ),
        ),
        Mistake(
            moved_frames_alone_returned,
            Text(
                "The dict that comes back holds GL and SP alone. LC and FS belong in it as they were: start from dict(frames).",
                "返ってきた dict に GL と SP しか入っていません。LC と FS もそのまま入れます。dict(frames) から始めましょう。",
            ),
        ),
        Mistake(
            gl_alone_returned,
            Text(
                "GL's new pose comes back alone. Return a dict of all four frames.",
                "GL の新しい姿勢だけが返っています。4 つの座標系すべての dict を返しましょう。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With frames of whole numbers the decimals of SP are cut off: a copy of an integer array holds integers "
                "only. Make it np.array(..., dtype=float).",
                "姿勢が整数で渡されると、SP の小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(..., dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "GL and SP are rounded: the robot then appears only nearly at pose. Round only for display.",
                "GL と SP が丸められていて、ロボットの姿勢が pose にぴったり一致しません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
    ),
)
