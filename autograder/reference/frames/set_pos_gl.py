"""set_pos_gl(frames, pose): YP-Spur's Spur_set_pos_GL, notes 001, section 3.1: GL is laid anew, and nothing else changes.

`frames` holds the pose of each frame in its parent: GL, FS and SP in BS, LC in GL. Afterwards the robot (FS) stands at `pose` in GL.
"""

import cmath

import numpy as np

from autograder.draws import pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import RecordTolerance, Tolerance

_POSE = Tolerance(axis=-1, angles=(2,))


def reference(frames, pose):
    """Return the frames with GL turned first, then pushed so that `pose`, measured along its new axes, ends at the robot."""
    robot = frames["FS"]
    heading = robot[2] - pose[2]
    origin = complex(robot[0], robot[1]) - complex(pose[0], pose[1]) * cmath.rect(1.0, heading)
    return {**frames, "GL": [origin.real, origin.imag, heading]}


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
    """Are x and y of the new GL far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(frames, pose)["GL"][:2])) > 0.6


def inverse_on_the_wrong_side(frames, pose):
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

    return {**frames, "GL": compose(frames["FS"], -np.asarray(pose))}


def pose_not_inverted(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    return {**frames, "GL": compose(frames["FS"], pose)}


def pose_composed_with_the_robot(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    return {**frames, "GL": compose(pose, frames["FS"])}


def gl_is_the_pose(frames, pose):
    return {**frames, "GL": np.array(pose, dtype=float)}


def gl_is_the_inverse_of_the_pose(frames, pose):
    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": invert(pose)}


def gl_is_the_robot(frames, pose):
    return {**frames, "GL": np.array(frames["FS"], dtype=float)}


def subtracted_component_by_component(frames, pose):
    return {**frames, "GL": np.asarray(frames["FS"]) - np.asarray(pose)}


def seen_from_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(pose, invert(frames["FS"]))}


def seen_from_the_robot(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(invert(frames["FS"]), pose)}


def old_gl_in_front(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(frames["GL"], compose(frames["FS"], invert(pose)))}


def gl_moved_by_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    return {**frames, "GL": compose(frames["GL"], pose)}


def gl_moved_back_by_the_pose(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(frames["GL"], invert(pose))}


def robot_moved(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    return {**frames, "FS": compose(frames["GL"], pose)}


def robot_is_the_pose(frames, pose):
    return {**frames, "FS": np.array(pose, dtype=float)}


def robot_moved_too(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "FS": np.array(pose, dtype=float)}


def lc_laid_anew_instead(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "LC": compose(invert(frames["GL"]), compose(frames["FS"], invert(pose)))}


def pose_taken_in_lc(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(frames["FS"], invert(compose(frames["LC"], pose)))}


def lc_kept_in_place(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "LC": compose(compose(invert(gl), frames["GL"]), frames["LC"])}


def lc_moved_as_if_in_bs(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "LC": compose(compose(gl, invert(frames["GL"])), frames["LC"])}


def adjusted_instead(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(compose(gl, invert(frames["GL"])), frames["SP"])}


def sp_is_gl(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": gl.copy()}


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


def turned_back_by_the_heading_of_the_pose(frames, pose):
    robot = frames["FS"]
    c, s = np.cos(pose[2]), np.sin(pose[2])
    x, y = robot[0] - c * pose[0] - s * pose[1], robot[1] + s * pose[0] - c * pose[1]
    return {**frames, "GL": np.array([x, y, robot[2] - pose[2]])}


def gl_turned_the_other_way(frames, pose):
    robot = frames["FS"]
    turn = robot[2] - pose[2]
    c, s = np.cos(turn), np.sin(turn)
    x, y = robot[0] - c * pose[0] - s * pose[1], robot[1] + s * pose[0] - c * pose[1]
    return {**frames, "GL": np.array([x, y, turn])}


def headings_added(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    gl[2] = frames["FS"][2] + pose[2]
    return {**frames, "GL": gl}


def heading_subtracted_the_other_way(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    gl[2] = pose[2] - frames["FS"][2]
    return {**frames, "GL": gl}


def heading_of_gl_kept(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = compose(frames["FS"], invert(pose))
    gl[2] = frames["GL"][2]
    return {**frames, "GL": gl}


def position_only(frames, pose):
    old = frames["GL"]
    c, s = np.cos(old[2]), np.sin(old[2])
    robot = frames["FS"]
    x, y = robot[0] - c * pose[0] + s * pose[1], robot[1] - s * pose[0] - c * pose[1]
    return {**frames, "GL": np.array([x, y, old[2]])}


def nothing_changed(frames, pose):
    return {**frames}


def gl_alone_returned(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return compose(frames["FS"], invert(pose))


def other_frames_left_out(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {"GL": compose(frames["FS"], invert(pose))}


def heading_of_gl_left_out(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": compose(frames["FS"], invert(pose))[:2]}


def matrix_stored(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    x, y, theta = compose(frames["FS"], invert(pose))
    c, s = np.cos(theta), np.sin(theta)
    return {**frames, "GL": np.array([[c, -s, x], [s, c, y], [0, 0, 1]])}


def whole_numbers_cut_off(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    gl = np.array(frames["GL"])
    gl[:] = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl}


def rounded(frames, pose):
    def compose(a, b):
        arm = complex(b[0], b[1]) * np.exp(1j * a[2])
        return np.array([a[0] + arm.real, a[1] + arm.imag, a[2] + b[2]])

    def invert(a):
        back = -complex(a[0], a[1]) * np.exp(-1j * a[2])
        return np.array([back.real, back.imag, -a[2]])

    return {**frames, "GL": np.round(compose(frames["FS"], invert(pose)), 3)}


EXERCISE = Exercise(
    name="set_pos_gl",
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
            inverse_on_the_wrong_side,
            Text(
                "The two factors of the new GL are exchanged: the inverse of pose comes first. Walk from BS to GL: first "
                "from BS to the robot, and from there back to GL's origin.",
                "新しい GL を作る合成の順序が逆で、pose の逆が先になっています。BS から GL までたどってみましょう。"
                "まず BS からロボットへ、次にロボットから GL の原点へ戻ります。",
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
            pose_composed_with_the_robot,
            Text(
                "GL is pose composed with FS, without any inverse. Check it: the new GL composed with pose must be FS again.",
                "GL が pose と FS の合成になっていて、逆変換がどこにもありません。新しい GL と pose を"
                "合成すると FS に戻るはずです。確かめてみましょう。",
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
            gl_is_the_robot,
            Text(
                "GL is laid where the robot is: then the robot would appear at (0, 0, 0) in GL, whatever pose says.",
                "GL をロボットの位置に重ねています。それでは pose が何であっても、ロボットは GL で (0, 0, 0) に見えます。",
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
            seen_from_the_pose,
            Text(
                "This is the inverse of what is asked for: BS as seen from the new GL. The entry GL tells where GL lies in BS.",
                "求めるものの逆で、新しい GL から見た BS になっています。GL の項目は、BS の中で GL がどこにあるかを表します。",
            ),
        ),
        Mistake(
            seen_from_the_robot,
            Text(
                "This is pose as seen from FS, as if both were given in BS. But pose is given in GL, and the entry GL tells "
                "where GL lies in BS.",
                "FS から見た pose を計算しています(どちらも BS で与えられたかのように)。pose は"
                " GL の中の姿勢で、GL の項目は BS の中で GL がどこにあるかです。",
            ),
        ),
        Mistake(
            old_gl_in_front,
            Text(
                "The old GL is composed in front. FS is given in BS, not in GL, and where GL lay before does not matter any "
                "more.",
                "前の GL をさらに合成しています。FS は GL ではなく BS の中の姿勢です。GL が前にどこにあったかは、"
                "もう関係ありません。",
            ),
        ),
        Mistake(
            gl_moved_by_the_pose,
            Text(
                "GL is moved on by pose from where it was. pose is no displacement of GL: it tells where the robot is to "
                "appear in it.",
                "GL を、いまの位置から pose だけ動かしています。pose は GL の移動量ではなく、GL の中でロボットが"
                "見えるべき姿勢です。",
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
            robot_moved,
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
            robot_moved_too,
            Text(
                "GL is right, but FS is set to pose as well. FS is the robot in BS, and there it has not moved.",
                "GL は合っていますが、FS まで pose に書き換えています。FS は BS の中のロボットの姿勢で、そこでは"
                "ロボットは動いていません。",
            ),
        ),
        Mistake(
            lc_laid_anew_instead,
            Text(
                "LC is laid anew so that the robot appears at pose in LC. That is set_pos_LC; here GL is meant, and LC keeps "
                "its entry.",
                "ロボットが LC の中で pose に見えるように、LC を張り替えています。それは set_pos_LC です。"
                "ここで張り替えるのは GL で、LC の項目はそのままです。",
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
            lc_kept_in_place,
            Text(
                "GL is right, but LC is changed so that it stays where it was in BS. LC is a frame on GL: its entry is its "
                "pose in GL, and it rides along.",
                "GL は合っていますが、LC が BS の中で動かないように書き換えています。LC は GL の上の座標系です。"
                "項目は GL の中の姿勢なので、GL と一緒に動きます。",
            ),
        ),
        Mistake(
            lc_moved_as_if_in_bs,
            Text(
                "GL is right, but LC is moved along with it as if it were given in BS. LC's entry is its pose in GL: as GL "
                "moves, LC rides along by itself.",
                "GL は合っていますが、LC が BS の中の姿勢であるかのように一緒に動かしています。LC の項目は"
                " GL の中の姿勢なので、GL が動けば LC は何もしなくても一緒に動きます。",
            ),
        ),
        Mistake(
            adjusted_instead,
            Text(
                "GL is right, but SP is moved along with it: that is adjust, and the robot would swerve. set leaves the line "
                "that the robot follows where it is.",
                "GL は合っていますが、SP も一緒に動かしています。それは adjust の動作で、ロボットの動きが"
                "変わってしまいます。set では、ロボットがたどる直線はそのままです。",
            ),
        ),
        Mistake(
            sp_is_gl,
            Text(
                "GL is right, but SP is set to GL as well. SP holds the line that the robot follows, and set does not touch it.",
                "GL は合っていますが、SP にも GL と同じ値を入れています。SP はロボットがたどる直線の座標系で、"
                "set では変わりません。",
            ),
        ),
        Mistake(
            every_frame_moved,
            Text(
                "Every frame is moved as GL is. Only GL is laid anew: the others keep their entries.",
                "すべての座標系を GL と同じように動かしています。張り替えるのは GL だけで、ほかの項目はそのままです。",
            ),
        ),
        Mistake(
            turned_back_by_the_heading_of_the_pose,
            Text(
                "The inverse of pose is right, but its x and y are added to FS without being turned by the robot's heading: "
                "that is an addition, not a composition.",
                "pose の逆は合っていますが、その x, y をロボットの方位で回転させずに FS に足しています。それは合成では"
                "なく、ただの足し算です。",
            ),
        ),
        Mistake(
            gl_turned_the_other_way,
            Text(
                "The heading of GL is right, but pose's x and y are turned the wrong way: from BS into GL instead of out of it.",
                "GL の方位は合っていますが、pose の x, y の回転が逆向きです。GL から BS へではなく、"
                "BS から GL への回転になっています。",
            ),
        ),
        Mistake(
            headings_added,
            Text(
                "GL's x and y are right, but its heading is the sum of the two headings. The robot's heading in BS is GL's "
                "plus pose's: which one is unknown?",
                "GL の x, y は合っていますが、方位が 2 つの方位の和になっています。BS でのロボットの方位は"
                " GL の方位と pose の方位の和です。未知なのはどれですか。",
            ),
        ),
        Mistake(
            heading_subtracted_the_other_way,
            Text(
                "GL's x and y are right, but the difference of the headings is taken the wrong way round.",
                "GL の x, y は合っていますが、方位の引き算の順序が逆です。",
            ),
        ),
        Mistake(
            heading_of_gl_kept,
            Text(
                "GL's x and y are right, but it keeps its old heading. The robot must also look the way that pose says, so "
                "GL is turned, too.",
                "GL の x, y は合っていますが、方位が前のままです。ロボットの向きも pose のとおりに見える必要が"
                "あるので、GL は回転もします。",
            ),
        ),
        Mistake(
            position_only,
            Text(
                "GL is pushed but not turned: the robot appears at the right place, but looks the wrong way.",
                "GL が平行移動しているだけで、回転していません。ロボットの位置は合いますが、向きが合いません。",
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
            gl_alone_returned,
            Text(
                "GL's new pose comes back alone. Return a dict of all four frames.",
                "GL の新しい姿勢だけが返っています。4 つの座標系すべての dict を返しましょう。",
            ),
        ),
        Mistake(
            other_frames_left_out,
            Text(
                "The dict that comes back holds GL alone. The other three frames belong in it as they were: start from "
                "dict(frames).",
                "返ってきた dict に GL しか入っていません。ほかの 3 つもそのまま入れます。dict(frames) から始めましょう。",
            ),
        ),
        Mistake(
            heading_of_gl_left_out,
            Text(
                "GL has x and y only. A pose is (x, y, theta): all three belong in the entry.",
                "GL に x と y しか入っていません。姿勢は (x, y, theta) の 3 つ組です。3 つとも入れましょう。",
            ),
        ),
        Mistake(
            matrix_stored,
            Text(
                "GL holds a (3, 3) matrix. The entries are poses (x, y, theta): read the three numbers out of it.",
                "GL に (3, 3) の行列が入っています。各項目は姿勢 (x, y, theta) です。行列から 3 つの数を取り出しましょう。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With frames of whole numbers the decimals of GL are cut off: a copy of an integer array holds integers "
                "only. Make it np.array(..., dtype=float).",
                "姿勢が整数で渡されると、GL の小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(..., dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "GL is rounded: the robot then appears only nearly at pose. Round only for display.",
                "GL が丸められていて、ロボットの姿勢が pose にぴったり一致しません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
    ),
)
