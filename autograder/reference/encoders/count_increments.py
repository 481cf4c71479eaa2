"""count_increments(counter): increments of a 16-bit running counter that wraps, as the count(t) - count(t - dt) of notes 001, eq. (4)."""

from itertools import pairwise

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(counter):
    """Return for each pair of readings the one increment within half a turn of the counter that leads from old to new."""
    increments = []
    for old, new in pairwise(counter):
        upwards = (int(new) - int(old)) % 65536
        increments.append(upwards if upwards < 32768 else upwards - 65536)
    return increments


def cases(rng):
    """Draw counters that wrap upwards, downwards, several times and not at all, slow and fast, in every kind of container."""

    def small(size, sign):
        return sign * rng.integers(40, 900, size)

    def fast(size, signs):
        return rng.integers(30500, 31900, size) * np.resize(signs, size)

    def across(sign):
        """Return small increments that cross the end of the range somewhere in the middle."""
        before, after = rng.integers(2, 6, 2)
        steps = small(before + after, sign)
        start = sign * 32767 - steps[:before].sum() + sign * int(rng.integers(5, 30))
        return counter(start, steps)

    def inside(sign):
        """Return increments of both signs that stay in the middle of the range and pass through 0."""
        there, back = small(int(rng.integers(4, 6)), sign), small(int(rng.integers(2, 4)), -sign)
        return counter(-int(there[0] + there[1] // 2), np.concatenate([there, back]))

    def medium(sign):
        """Return wraps between readings far from both ends of the range, as a fast wheel makes them."""
        size = int(rng.integers(5, 9))
        start = sign * int(rng.integers(12000, 15000))
        return counter(start, sign * rng.integers(25500, 27500, size))

    passing = counter(int(rng.integers(25100, 25600)), rng.integers(3900, 4300, int(rng.integers(3, 6))))
    listed = counter(int(rng.integers(29000, 31000)), np.append(small(6, 1) + 700, fast(3, [1, -1])))
    single = counter(int(rng.integers(-30000, 30000)), [])
    pair = counter(-32700, np.array([-int(rng.integers(100, 900))]))
    return [
        Group(Text("forward across the wrap", "正転で桁あふれ"), 3, [(across(1),), (across(1).astype(float),)]),
        Group(Text("backward across the wrap", "逆転で桁あふれ"), 2, [(across(-1),), (across(-1).astype(np.int16),)]),
        Group(Text("no wrap", "桁あふれなし"), 2, [(inside(1),), (inside(-1).astype(float),)]),
        Group(
            Text("fast wheels, wrapping again and again", "高速回転で何度も桁あふれ"),
            2,
            [
                (medium(1),),
                (passing,),
                (medium(-1).astype(float),),
                (counter(int(rng.integers(-9000, 9000)), fast(int(rng.integers(6, 10)), [1, 1, 1, -1, -1])),),
            ],
        ),
        Group(
            Text("16-bit integers and lists", "16 ビット整数の配列、リスト"),
            1,
            [(across(1).astype(np.int16),), (listed.tolist(),), (pair.tolist(),)],
        ),
        Group(Text("a single reading", "読み取りが 1 回だけ"), 1, [(single,), (single.tolist(),)]),
    ]


def counter(start, steps):
    """Return the readings (N,) of an int16 counter that begins at `start` and makes these steps, as 64-bit integers."""
    total = start + np.concatenate([[0], np.cumsum(steps)]).astype(int)
    return (total + 32768) % 65536 - 32768


def wrap_ignored(counter):
    return np.diff(np.asarray(counter, dtype=int))


def type_relied_on(counter):
    return np.diff(np.asarray(counter))


def upward_wrap_only(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d + 65536, d)


def downward_wrap_only(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d > 32767, d - 65536, d)


def range_65535(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d + 65535, np.where(d > 32767, d - 65535, d))


def range_32768(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d + 32768, np.where(d > 32767, d - 32768, d))


def range_32767(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d + 32767, np.where(d > 32767, d - 32767, d))


def modulo_32768(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return (d + 16384) % 32768 - 16384


def half_range_from_a_quarter(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -16384, d + 32768, np.where(d > 16384, d - 32768, d))


def wrap_seen_too_early(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -16384, d + 65536, np.where(d > 16384, d - 65536, d))


def wrap_seen_from_30000(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -30000, d + 65536, np.where(d > 30000, d - 65536, d))


def wrap_seen_too_late(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -60000, d + 65536, np.where(d > 60000, d - 65536, d))


def wrap_near_the_ends_only(counter):
    c = np.asarray(counter, dtype=int)
    d = np.diff(c)
    d[(c[:-1] > 30000) & (c[1:] < -30000)] += 65536
    d[(c[:-1] < -30000) & (c[1:] > 30000)] -= 65536
    return d


def correction_doubled(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d + 131072, np.where(d > 32767, d - 131072, d))


def corrected_the_wrong_way(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(d < -32768, d - 65536, np.where(d > 32767, d + 65536, d))


def always_added(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(np.abs(d) > 32767, d + 65536, d)


def backward_taken_for_wrap(counter):
    return np.diff(np.asarray(counter, dtype=int)) % 65536


def shifted_by_half_the_range(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return (d + 32768) % 65536


def shifted_back_only(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return d % 65536 - 32768


def passage_through_zero_taken_for_wrap(counter):
    return np.diff(np.asarray(counter, dtype=int).astype(np.uint16).astype(int))


def wrap_set_to_zero(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.where(np.abs(d) > 32767, 0, d)


def wrap_left_out(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return d[np.abs(d) <= 32767]


def wrap_filled_from_before(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    for k in range(1, len(d)):
        if abs(d[k]) > 32767:
            d[k] = d[k - 1]
    return d


def wrap_restarts_at_new_reading(counter):
    c = np.asarray(counter, dtype=int)
    d = np.diff(c)
    return np.where(np.abs(d) > 32767, c[1:], d)


def clipped(counter):
    return np.clip(np.diff(np.asarray(counter, dtype=int)), -32000, 32000)


def clipped_at_16_bits(counter):
    return np.clip(np.diff(np.asarray(counter, dtype=int)), -32768, 32767)


def first_wrap_only(counter):
    c = np.array(counter, dtype=int)
    d = np.diff(c)
    jumps = np.flatnonzero(np.abs(d) > 32767)
    if len(jumps):
        d[jumps[0]] -= np.sign(d[jumps[0]]) * 65536
    return d


def one_reading_corrected(counter):
    c = np.array(counter, dtype=int)
    d = np.diff(c)
    corrected = c.copy()
    corrected[1:] -= np.where(np.abs(d) > 32767, np.sign(d) * 65536, 0)
    return np.diff(corrected)


def unwrapped_by_two_pi(counter):
    return np.diff(np.unwrap(np.asarray(counter, dtype=float)))


def running_counter_returned(counter):
    return np.unwrap(np.asarray(counter, dtype=float), period=65536)[1:]


def whole_running_counter_returned(counter):
    return np.unwrap(np.asarray(counter, dtype=float), period=65536)


def count_since_the_start(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.cumsum((d + 32768) % 65536 - 32768)


def count_since_the_start_with_zero(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.concatenate([[0], np.cumsum((d + 32768) % 65536 - 32768)])


def difference_from_the_first(counter):
    d = np.asarray(counter, dtype=int)[1:] - int(counter[0])
    return (d + 32768) % 65536 - 32768


def zero_at_the_front(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.concatenate([[0], (d + 32768) % 65536 - 32768])


def zero_at_the_front_and_wrap_ignored(counter):
    return np.concatenate([[0], np.diff(np.asarray(counter, dtype=int))])


def counted_from_zero(counter):
    d = np.diff(np.asarray(counter, dtype=int), prepend=0)
    return (d + 32768) % 65536 - 32768


def zero_at_the_end(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.concatenate([(d + 32768) % 65536 - 32768, [0]])


def single_reading_gives_zero(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return (d + 32768) % 65536 - 32768 if len(d) else np.zeros(1)


def last_left_out(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return ((d + 32768) % 65536 - 32768)[:-1]


def first_left_out(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return ((d + 32768) % 65536 - 32768)[1:]


def two_readings_back(counter):
    c = np.asarray(counter, dtype=int)
    return (c[2:] - c[:-2] + 32768) % 65536 - 32768


def old_minus_new(counter):
    c = np.asarray(counter, dtype=int)
    return (c[:-1] - c[1:] + 32768) % 65536 - 32768


def direction_lost(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return np.abs((d + 32768) % 65536 - 32768)


def divided_by_the_range(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return ((d + 32768) % 65536 - 32768) / 65536


def only_the_total(counter):
    d = np.diff(np.asarray(counter, dtype=int))
    return int(np.sum((d + 32768) % 65536 - 32768))


EXERCISE = Exercise(
    name="count_increments",
    notebook="odometry/encoders",
    points=5,
    parameters=("counter",),
    reference=reference,
    cases=cases,
    examples=(
        (np.array([100, 233, 366, 350]),),
        (np.array([32760, 32767, -32762]),),
        ([-32700, 32500, 32760, -32600],),
    ),
    mistakes=(
        Mistake(
            wrap_ignored,
            Text(
                "Where the counter wraps there is a jump of 65536 counts. The counter has 16 bits: after 32767 comes -32768, "
                "and the wheel has moved "
                "by one count only. Bring such a difference back into the 16-bit range.",
                "カウンタが一周するところで 65536 カウント飛んでいます。"
                "カウンタは 16 ビットなので 32767 の次は -32768 になりますが、車輪が動いたのは 1 カウントだけです。"
                "その差を 16 ビットの範囲に戻しましょう。",
            ),
        ),
        Mistake(
            type_relied_on,
            Text(
                "This is right only if the counter comes as an int16 array, which wraps by itself. A list or an array of "
                "another type does not: "
                "do the 16-bit arithmetic yourself, or convert first.",
                "カウンタが int16 の配列のときだけ正しくなります。"
                "int16 の引き算はひとりでに一周しますが、リストや他の型の配列ではそうなりません。"
                "16 ビットの計算を自分で行うか、先に型を変換しましょう。",
            ),
        ),
        Mistake(
            upward_wrap_only,
            Text(
                "The wrap from 32767 to -32768 is corrected, the one from -32768 to 32767 is not. A wheel that reverses crosses "
                "it that way.",
                "32767 から -32768 への桁あふれは直していますが、-32768 から 32767 への桁あふれは直していません。"
                "逆転する車輪ではこちらが起こります。",
            ),
        ),
        Mistake(
            downward_wrap_only,
            Text(
                "The wrap from -32768 to 32767 is corrected, the one from 32767 to -32768 is not. A wheel that runs forward "
                "crosses it that way.",
                "-32768 から 32767 への桁あふれは直していますが、32767 から -32768 への桁あふれは直していません。"
                "正転する車輪ではこちらが起こります。",
            ),
        ),
        Mistake(
            range_65535,
            Text(
                "One count is lost at every wrap: 65535 is the largest 16-bit number, but how many different values are there, "
                "0 included?",
                "桁あふれのたびに 1 カウント失われています。65535 は 16 ビットの最大値です。0 も含めると、値は何通りありますか。",
            ),
        ),
        Mistake(
            range_32768,
            Text(
                "At a wrap the difference is corrected by 32768, half of the range only. From -32768 to 32767: how many values "
                "does the counter have?",
                "桁あふれを 32768(範囲の半分)だけ補正しています。-32768 から 32767 まで、カウンタの値は何通りありますか。",
            ),
        ),
        Mistake(
            range_32767,
            Text(
                "At a wrap the difference is corrected by 32767, the largest value. What must be added is the number of all "
                "values from -32768 to 32767.",
                "桁あふれを 32767(最大値)だけ補正しています。足し引きすべきなのは、-32768 から 32767 までの値の個数です。",
            ),
        ),
        Mistake(
            modulo_32768,
            Text(
                "The differences are brought back modulo 32768, half of the range, so that fast steps are wrong too. From "
                "-32768 to 32767: how many values are there?",
                "差を 32768(範囲の半分)の剰余で戻しているため、大きな増分も誤りになります。"
                "-32768 から 32767 まで、値は何通りありますか。",
            ),
        ),
        Mistake(
            half_range_from_a_quarter,
            Text(
                "32768 is taken for the length of the range and 16384 for its half. From -32768 to 32767: how many values does "
                "the counter have?",
                "範囲の長さを 32768、その半分を 16384 としています。-32768 から 32767 まで、カウンタの値は何通りありますか。",
            ),
        ),
        Mistake(
            wrap_seen_too_early,
            Text(
                "A fast wheel is taken for a wrap: steps above 16384 are corrected although they are real. True increments go "
                "up to 32000.",
                "速い車輪の増分を桁あふれとみなしています。16384 を超える本物の増分まで補正されています。"
                "本当の増分は 32000 まであります。",
            ),
        ),
        Mistake(
            wrap_seen_from_30000,
            Text(
                "A very fast wheel is taken for a wrap: steps just above 30000 are corrected although they are real. True "
                "increments go up to 32000.",
                "非常に速い車輪の増分を桁あふれとみなしています。30000 を少し超える本物の増分まで補正されています。"
                "本当の増分は 32000 まであります。",
            ),
        ),
        Mistake(
            wrap_seen_too_late,
            Text(
                "A wrap is noticed only if the jump is close to 65536. If the wheel is fast the jump is smaller: which "
                "differences can no true increment make?",
                "飛びが 65536 に近いときだけ桁あふれとみなしています。車輪が速いと飛びは小さくなります。"
                "本当の増分ではありえない差はどこからでしょうか。",
            ),
        ),
        Mistake(
            wrap_near_the_ends_only,
            Text(
                "A wrap is noticed only if both readings lie beyond 30000, near the ends. A fast wheel wraps from further "
                "inside: look at the difference, not at the readings.",
                "2 つの読みがどちらも 30000 を超えて端に近いときだけ、桁あふれとみなしています。"
                "車輪が速ければ、もっと内側からでも桁あふれします。"
                "読みではなく差を見ましょう。",
            ),
        ),
        Mistake(
            correction_doubled,
            Text(
                "At a wrap twice the range is added or subtracted. The counter has gone round once.",
                "桁あふれのときに範囲の 2 倍を足し引きしています。カウンタが一周したのは 1 回です。",
            ),
        ),
        Mistake(
            corrected_the_wrong_way,
            Text(
                "The correction makes the jump larger: added where it must be subtracted. Compute the step from 32767 to -32768 "
                "by hand.",
                "補正の向きが逆で、飛びがかえって大きくなっています。32767 から -32768 への 1 歩を手で計算してみましょう。",
            ),
        ),
        Mistake(
            always_added,
            Text(
                "65536 is added at every wrap, whichever way. A wheel that reverses jumps upwards: there it must be subtracted.",
                "どちら向きの桁あふれでも 65536 を足しています。逆転では差が大きな正の値になるので、引かなければなりません。",
            ),
        ),
        Mistake(
            backward_taken_for_wrap,
            Text(
                "A wheel that reverses makes increments near 65536: every falling counter is taken for a wrap. Increments may "
                "be negative; "
                "a modulo alone gives 0..65535.",
                "逆転したときに 65536 に近い増分が出ています。カウンタが減るたびに桁あふれとみなしています。"
                "増分は負にもなります。剰余だけでは 0〜65535 になってしまいます。",
            ),
        ),
        Mistake(
            shifted_by_half_the_range,
            Text(
                "All increments are 32768 too large: half the range is added before the modulo and must come off again after it.",
                "すべての増分が 32768 だけ大きくなっています。剰余をとる前に足した範囲の半分は、あとで引かなければなりません。",
            ),
        ),
        Mistake(
            shifted_back_only,
            Text(
                "All increments are off by 32768: half the range is subtracted after the modulo, but not added before it. A "
                "wheel at rest must give 0.",
                "すべての増分が 32768 ずれています。剰余をとった後に範囲の半分を引いていますが、前に足していません。"
                "止まっている車輪の増分は 0 のはずです。",
            ),
        ),
        Mistake(
            passage_through_zero_taken_for_wrap,
            Text(
                "Where the counter passes through 0 there is now a jump of 65536: the readings are made unsigned (0..65535), or "
                "every change of their "
                "sign is taken for a wrap. Look at the size of the difference of the readings as they come.",
                "カウンタが 0 を通るところで 65536 の飛びが出ています。"
                "読みを符号なし(0〜65535)に直しているか、符号が変わるたびに桁あふれとみなしています。"
                "元の読みのまま、差の大きさを見ましょう。",
            ),
        ),
        Mistake(
            wrap_set_to_zero,
            Text(
                "At a wrap the increment is set to 0: those counts are lost for good. The true increment can be computed.",
                "桁あふれのところの増分を 0 にしています。そのカウントは失われたままになります。本当の増分は計算できます。",
            ),
        ),
        Mistake(
            wrap_left_out,
            Text(
                "At a wrap the increment is left out, and the result is too short. The true increment can be computed.",
                "桁あふれのところの増分を取り除いているため、結果が短くなっています。本当の増分は計算できます。",
            ),
        ),
        Mistake(
            wrap_filled_from_before,
            Text(
                "At a wrap the increment before is repeated. That is a guess; the true increment can be computed.",
                "桁あふれのところで 1 つ前の増分を繰り返しています。これは推測にすぎません。本当の増分は計算できます。",
            ),
        ),
        Mistake(
            wrap_restarts_at_new_reading,
            Text(
                "At a wrap the new reading itself is taken for the increment, as if the counter restarted at 0. It goes on at "
                "the other end of its range.",
                "桁あふれのところで、新しい読みをそのまま増分としています。"
                "カウンタは 0 に戻るのではなく、範囲の反対の端から続きます。",
            ),
        ),
        Mistake(
            clipped,
            Text(
                "Large differences are cut off at 32000. That hides the jump, but the increment is still wrong: add or subtract "
                "what the wrap took away.",
                "大きな差を 32000 で打ち切っています。飛びは目立たなくなりますが、増分は誤ったままです。"
                "桁あふれで失われた分を足し引きしましょう。",
            ),
        ),
        Mistake(
            clipped_at_16_bits,
            Text(
                "Large differences are cut off at the ends of the 16-bit range. That hides the jump, but the increment is still "
                "wrong: "
                "add or subtract what the wrap took away.",
                "大きな差を 16 ビットの範囲の端で打ち切っています。飛びは目立たなくなりますが、増分は誤ったままです。"
                "桁あふれで失われた分を足し引きしましょう。",
            ),
        ),
        Mistake(
            first_wrap_only,
            Text(
                "Only the first wrap is corrected. A counter wraps again and again during a drive.",
                "最初の桁あふれだけを直しています。走行中、カウンタは何度も桁あふれします。",
            ),
        ),
        Mistake(
            one_reading_corrected,
            Text(
                "Only the reading right after the wrap is moved, so the jump comes one step later. Either all readings after it "
                "move, or the difference alone is corrected.",
                "桁あふれの直後の読みだけをずらしているため、次のところで飛びが出ています。"
                "以後の読みをすべてずらすか、差だけを直しましょう。",
            ),
        ),
        Mistake(
            unwrapped_by_two_pi,
            Text(
                "np.unwrap is used for angles here: it takes the range for 2π. Tell it the range of the counter (its argument "
                "period).",
                "np.unwrap を角度用のまま(周期 2π で)使っています。引数 period でカウンタの範囲を指定しましょう。",
            ),
        ),
        Mistake(
            running_counter_returned,
            Text(
                "The wraps are gone, but these are the readings themselves, not the increments. Take differences of neighbours "
                "as well.",
                "桁あふれは直っていますが、増分ではなくカウンタの読みそのものです。さらに隣どうしの差をとりましょう。",
            ),
        ),
        Mistake(
            whole_running_counter_returned,
            Text(
                "The wraps are gone, but these are the readings themselves, as many as before. Increments are differences of "
                "neighbours, one fewer.",
                "桁あふれは直っていますが、カウンタの読みそのものが同じ個数だけ返っています。"
                "増分は隣どうしの差で、1 つ少なくなります。",
            ),
        ),
        Mistake(
            count_since_the_start,
            Text(
                "The increments are added up: this is the count since the start. Return them one by one, without cumsum.",
                "増分を累積していて、最初からのカウントになっています。cumsum はせず、増分を 1 つずつ返しましょう。",
            ),
        ),
        Mistake(
            single_reading_gives_zero,
            Text(
                "A single reading gives a 0. One reading has no neighbour, so that there is no increment at all: the result is "
                "empty, shape (0,).",
                "読みが 1 つだけのとき 0 が返っています。隣の読みがないので増分は 1 つもなく、結果は空(形状 (0,))になります。",
            ),
        ),
        Mistake(
            count_since_the_start_with_zero,
            Text(
                "This is the count since the start, with a 0 in front. Asked for are the increments, one fewer than there are "
                "readings.",
                "先頭に 0 の付いた、最初からのカウントになっています。求めるのは増分で、読みの個数より 1 つ少なくなります。",
            ),
        ),
        Mistake(
            difference_from_the_first,
            Text(
                "The first reading is subtracted from all. An increment is the difference from the reading just before.",
                "すべての読みから最初の読みを引いています。増分は 1 つ前の読みとの差です。",
            ),
        ),
        Mistake(
            zero_at_the_front,
            Text(
                "There is a 0 too many at the front. N readings have N-1 gaps between them.",
                "先頭に余分な 0 があります。N 個の読みの間隔は N-1 個です。",
            ),
        ),
        Mistake(
            zero_at_the_front_and_wrap_ignored,
            Text(
                "There is a 0 too many at the front: N readings have N-1 gaps between them. And where the counter wraps there "
                "is still a jump of 65536.",
                "先頭に余分な 0 があります。N 個の読みの間隔は N-1 個です。また、桁あふれのところで 65536 の飛びが残っています。",
            ),
        ),
        Mistake(
            counted_from_zero,
            Text(
                "The first reading is counted as an increment from 0. Where the counter stands at first says nothing about "
                "motion: N readings make N-1 increments.",
                "最初の読みを 0 からの増分として数えています。最初のカウンタの値は動きとは関係ありません。"
                "N 個の読みから N-1 個の増分が得られます。",
            ),
        ),
        Mistake(
            zero_at_the_end,
            Text(
                "There is a 0 too many at the end. N readings have N-1 gaps between them.",
                "末尾に余分な 0 があります。N 個の読みの間隔は N-1 個です。",
            ),
        ),
        Mistake(
            last_left_out,
            Text(
                "The last increment is missing. N readings make N-1 increments: where does the loop end?",
                "最後の増分が抜けています。N 個の読みから N-1 個の増分が得られます。ループの終わりを確かめましょう。",
            ),
        ),
        Mistake(
            first_left_out,
            Text(
                "The first increment is missing. N readings make N-1 increments: where does the loop begin?",
                "最初の増分が抜けています。N 個の読みから N-1 個の増分が得られます。ループの始まりを確かめましょう。",
            ),
        ),
        Mistake(
            two_readings_back,
            Text(
                "Readings two apart are subtracted. An increment is the difference from the reading just before.",
                "2 つ離れた読みの差をとっています。増分は 1 つ前の読みとの差です。",
            ),
        ),
        Mistake(
            old_minus_new,
            Text(
                "The signs are turned round: old minus new. A counter that counts up has positive increments.",
                "符号が逆で、古い読みから新しい読みを引いています。カウンタが増えるとき、増分は正です。",
            ),
        ),
        Mistake(
            direction_lost,
            Text(
                "The sign is lost: a wheel that reverses has negative increments. Leave out abs().",
                "符号が失われています。逆転する車輪の増分は負です。abs() は使いません。",
            ),
        ),
        Mistake(
            divided_by_the_range,
            Text(
                "The increments are divided by 65536: turns of the counter. Asked for are counts.",
                "増分を 65536 で割っていて、カウンタの回転数になっています。求めるのはカウントです。",
            ),
        ),
        Mistake(
            only_the_total,
            Text(
                "A single number comes back, the total. Asked for is the increment between each two readings.",
                "合計の数値 1 つが返っています。求めるのは隣り合う読みの間の増分すべてです。",
            ),
        ),
    ),
)
