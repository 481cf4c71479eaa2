"""quadrature_count(a, b): an encoder's two channels to a signed count, all four edges counted (slides 000, overview 6, encoder types)."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(a, b):
    """Return the count after each sample: at an edge A as it was and B as it is are alike if the shaft turns forward."""
    counts = [0]
    for k in range(1, len(a)):
        moved = a[k] != a[k - 1] or b[k] != b[k - 1]
        forward = a[k - 1] == b[k]
        counts.append(counts[-1] + (0 if not moved else 1 if forward else -1))
    return counts


def cases(rng):
    """Draw channels with pauses, runs of more than one cycle, and each of the four states at the start."""

    def run(direction):
        steps = np.full(rng.integers(6, 10), direction)
        return np.insert(steps, rng.integers(1, len(steps), 2), 0)

    def there_and_back(direction):
        back = np.full(rng.integers(8, 12), -direction)
        return np.concatenate([run(direction), back, np.full(rng.integers(5, 7), direction)])

    odd = int(rng.choice([1, 3]))
    starts = rng.permutation(4)
    return [
        Group(Text("forward", "正転"), 2, [channels(run(1), 2), channels(run(1), odd)]),
        Group(Text("backward", "逆転"), 2, [channels(run(-1), 0), channels(run(-1), 4 - odd)]),
        Group(
            Text("reversals, from each of the four states", "途中で反転(4 つの状態それぞれから開始)"),
            3,
            [channels(there_and_back(1 if k % 2 else -1), start) for k, start in enumerate(starts)],
        ),
        Group(
            Text("lists", "リスト"),
            1,
            [
                tuple(bits.tolist() for bits in channels(there_and_back(-1), odd)),
                tuple(bits.tolist() for bits in channels(there_and_back(-1), 4 - odd)),
            ],
        ),
        Group(Text("a single sample", "サンプルが 1 つだけ"), 1, [channels(np.zeros(0, int), 1), channels(np.zeros(0, int), 3)]),
    ]


def channels(steps, start):
    """Return the bits (a, b) of an encoder that begins in state `start` of the cycle 00, 10, 11, 01 and makes these steps."""
    state = np.concatenate([[start], start + np.cumsum(steps)]).astype(int) % 4
    return np.isin(state, (1, 2)).astype(int), (state >= 2).astype(int)


def direction_reversed(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1
    return -np.concatenate([[0], np.cumsum(step)])


def direction_lost(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.abs(np.diff(a)) + np.abs(np.diff(b)))])


def count_made_positive(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1
    return np.abs(np.concatenate([[0], np.cumsum(step)]))


def count_kept_from_going_below_zero(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1
    return np.maximum(np.concatenate([[0], np.cumsum(step)]), 0)


def count_stopped_at_zero(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1
    counts = [0]
    for move in step:
        counts.append(max(counts[-1] + move, 0))
    return np.array(counts)


def direction_taken_once(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1
    moved = step[step != 0]
    first = moved[0] if len(moved) else 1
    return first * np.concatenate([[0], np.cumsum(np.abs(step))])


def only_edges_of_a(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) * (1 - 2 * b[1:]))])


def only_edges_of_b(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(b) * (2 * a[1:] - 1))])


def only_edges_of_a_and_reversed(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) * (2 * b[1:] - 1))])


def only_rising_edges_of_a(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum((np.diff(a) == 1) * (1 - 2 * b[1:]))])


def only_rising_edges_of_b(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum((np.diff(b) == 1) * (2 * a[1:] - 1))])


def only_rising_edges(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    rises = (np.diff(a) == 1) * (1 - 2 * b[1:]) + (np.diff(b) == 1) * (2 * a[1:] - 1)
    return np.concatenate([[0], np.cumsum(rises)])


def pulses_of_a_without_direction(a, b):
    a = np.asarray(a, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) == 1)])


def edges_of_a_without_direction(a, b):
    a = np.asarray(a, dtype=int)
    return np.concatenate([[0], np.cumsum(np.abs(np.diff(a)))])


def rising_up_falling_down(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) + np.diff(b))])


def difference_of_the_channels(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) - np.diff(b))])


def edges_of_b_backwards(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) * (1 - 2 * b[1:]) + np.diff(b) * (1 - 2 * a[1:]))])


def edges_of_a_backwards(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return -np.concatenate([[0], np.cumsum(np.diff(a) * (1 - 2 * b[1:]) + np.diff(b) * (1 - 2 * a[1:]))])


def direction_from_leading_level(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    moved = (np.diff(a) != 0) | (np.diff(b) != 0)
    return np.concatenate([[0], np.cumsum(moved * np.where(a[1:] > b[1:], 1, -1))])


def pauses_counted(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.where(a[:-1] == b[1:], 1, -1))])


def end_of_the_cycle_missed(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    state = 2 * b + (a ^ b)
    return state - state[0]


def step_back_counts_three(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(2 * b + (a ^ b)) % 4)])


def step_over_the_cycle_dropped(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = np.diff(2 * b + (a ^ b))
    return np.concatenate([[0], np.cumsum(np.where(np.abs(step) > 1, 0, step))])


def state_returned(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return 2 * b + (a ^ b)


def states_as_binary_numbers(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    state = 2 * a + b
    return state - state[0]


def binary_order_of_states(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * a + b) + 1) % 4 - 1
    return np.concatenate([[0], np.cumsum(step)])


def binary_order_b_first(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = (np.diff(2 * b + a) + 1) % 4 - 1
    return np.concatenate([[0], np.cumsum(step)])


def steps_not_added_up(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], (np.diff(2 * b + (a ^ b)) + 1) % 4 - 1])


def first_sample_left_out(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)


def only_the_last_count(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return int(np.sum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1))


def begins_with_the_state(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    state = 2 * b + (a ^ b)
    return state[0] + np.concatenate([[0], np.cumsum((np.diff(state) + 1) % 4 - 1)])


def begins_as_if_from_00(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = np.diff(2 * b + (a ^ b), prepend=0) % 4
    return np.cumsum(np.array([0, 1, 0, -1])[step])


def begins_as_if_from_00_and_one_edge_back(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = np.diff(2 * b + (a ^ b), prepend=0) % 4
    first = np.array([0, 1, -1, -1])[step[0]]
    return first + np.concatenate([[0], np.cumsum(np.array([0, 1, 0, -1])[step[1:]])])


def begins_as_if_from_00_and_two_edges(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    step = np.diff(2 * b + (a ^ b), prepend=0) % 4
    first = np.array([0, 1, 2, -1])[step[0]]
    return first + np.concatenate([[0], np.cumsum(np.array([0, 1, 0, -1])[step[1:]])])


def begins_with_one(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return 1 + np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)])


def one_sample_late(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    counts = np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)])
    return np.concatenate([[0], counts[:-1]])


def whole_cycles(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)]) // 4


def divided_by_four(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)]) / 4


def multiplied_by_four(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return 4 * np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)])


def count_within_one_cycle(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum((np.diff(2 * b + (a ^ b)) + 1) % 4 - 1)]) % 4


def levels_added_up(a, b):
    return np.cumsum(np.asarray(a, dtype=int) - np.asarray(b, dtype=int))


def high_samples_counted(a, b):
    return np.cumsum(np.asarray(a, dtype=int))


def both_edges_at_once_awaited(a, b):
    a, b = np.asarray(a, dtype=int), np.asarray(b, dtype=int)
    return np.concatenate([[0], np.cumsum(np.diff(a) * np.diff(b))])


EXERCISE = Exercise(
    name="quadrature_count",
    notebook="odometry/encoders",
    points=5,
    parameters=("a", "b"),
    reference=reference,
    cases=cases,
    examples=(
        (np.array([0, 1, 1, 1, 0, 0, 1]), np.array([0, 0, 0, 1, 1, 0, 0])),
        ([1, 1, 0, 1, 1, 0, 0], [1, 0, 0, 0, 1, 1, 0]),
    ),
    mistakes=(
        Mistake(
            direction_reversed,
            Text(
                "Every step has the wrong sign: A leading B counts down. Follow the states 00, 10, 11, 01 in the text with your "
                "finger: "
                "that order is forward. Are A and B exchanged, or two states in your table?",
                "すべてのステップの符号が逆で、A が B より先に変化するときに数が減っています。本文の 00, 10, 11, 01 の順が正転です。"
                "A と B、または表の状態の順が入れ替わっていないか確かめましょう。",
            ),
        ),
        Mistake(
            direction_lost,
            Text(
                "Every edge counts up, so a wheel that turns back seems to go on. The other channel tells the direction: "
                "at an edge, look at its level as well.",
                "エッジをすべて +1 で数えているため、逆転しても数が増え続けます。回転の向きはもう一方のチャンネルで分かります。"
                "エッジが来たときの相手の値も見ましょう。",
            ),
        ),
        Mistake(
            count_made_positive,
            Text(
                "The sign of the count is lost: a shaft turned back behind its start shows a positive count. Leave out abs().",
                "カウントの符号が失われています。出発点より後ろに戻っても正の数になります。abs() は使いません。",
            ),
        ),
        Mistake(
            count_kept_from_going_below_zero,
            Text(
                "Negative counts are replaced by 0. The count is signed: turned back behind the start it goes below 0.",
                "負のカウントが 0 に置き換えられています。カウントは符号付きで、出発点より後ろに戻れば負になります。",
            ),
        ),
        Mistake(
            count_stopped_at_zero,
            Text(
                "The count stops at 0 instead of going below, and all later counts are shifted. The count is signed.",
                "カウントが 0 で止まり、負になりません。そのため以後の値もずれています。カウントは符号付きです。",
            ),
        ),
        Mistake(
            direction_taken_once,
            Text(
                "One direction is used from beginning to end. The shaft may turn back at any sample: find the direction "
                "at every edge.",
                "最初から最後まで同じ向きを使っています。軸はいつでも反転できるので、向きはエッジごとに判定しましょう。",
            ),
        ),
        Mistake(
            only_edges_of_a,
            Text(
                "Only the edges of A are counted; that is 2x decoding. For 4x the edges of B count too.",
                "A のエッジだけを数えています(2 逓倍)。4 逓倍では B のエッジも数えます。",
            ),
        ),
        Mistake(
            only_edges_of_b,
            Text(
                "Only the edges of B are counted; that is 2x decoding. For 4x the edges of A count too.",
                "B のエッジだけを数えています(2 逓倍)。4 逓倍では A のエッジも数えます。",
            ),
        ),
        Mistake(
            only_edges_of_a_and_reversed,
            Text(
                "Only the edges of A are counted (2x decoding), and with the wrong sign. For 4x the edges of B count too; A "
                "leading B counts up.",
                "A のエッジだけを数えていて(2 逓倍)、符号も逆です。4 逓倍では B のエッジも数えます。"
                "A が先に変化するときに数が増えます。",
            ),
        ),
        Mistake(
            only_rising_edges_of_a,
            Text(
                "Only the rising edges of A are counted: one per cycle. With 4x decoding every edge counts, rising and falling, "
                "of A and B.",
                "A の立ち上がりだけを数えています(1 周期に 1 回)。4 逓倍では A と B の立ち上がりと立ち下がりをすべて数えます。",
            ),
        ),
        Mistake(
            only_rising_edges_of_b,
            Text(
                "Only the rising edges of B are counted: one per cycle. With 4x decoding every edge counts, rising and falling, "
                "of A and B.",
                "B の立ち上がりだけを数えています(1 周期に 1 回)。4 逓倍では A と B の立ち上がりと立ち下がりをすべて数えます。",
            ),
        ),
        Mistake(
            only_rising_edges,
            Text(
                "Only rising edges are counted. With 4x decoding the falling edges of A and B count as well.",
                "立ち上がりだけを数えています。4 逓倍では A と B の立ち下がりも数えます。",
            ),
        ),
        Mistake(
            pulses_of_a_without_direction,
            Text(
                "This counts the pulses of A and never looks at B: one per cycle, and always upwards. "
                "Two channels give four edges per cycle, and the direction.",
                "A のパルスだけを数えていて B を見ていません。1 周期に 1 回で、向きも分かりません。"
                "2 つのチャンネルがあるから、1 周期に 4 つのエッジと向きが得られます。",
            ),
        ),
        Mistake(
            edges_of_a_without_direction,
            Text(
                "This counts the edges of A and never looks at B: two per cycle, and always upwards. "
                "B doubles the edges and tells the direction.",
                "A のエッジだけを数えていて B を見ていません。1 周期に 2 回で、向きも分かりません。"
                "B も見れば、エッジは 2 倍になり、向きも決まります。",
            ),
        ),
        Mistake(
            rising_up_falling_down,
            Text(
                "A rising edge counts up and a falling edge down, so that the count returns to its start in every cycle. "
                "Rising or falling alone is no direction: what matters is the level of the other channel at that moment.",
                "立ち上がりで +1、立ち下がりで -1 としているため、1 周期ごとに元の数へ戻ってしまいます。"
                "向きは立ち上がりか立ち下がりかだけでは決まりません。その瞬間の相手のチャンネルの値が必要です。",
            ),
        ),
        Mistake(
            difference_of_the_channels,
            Text(
                "The change of B is subtracted from the change of A, and the count returns to its start in every cycle. The "
                "direction of an "
                "edge depends on the level of the other channel, not on its change.",
                "A の変化から B の変化を引いているため、1 周期ごとに元の数へ戻ってしまいます。"
                "エッジの向きを決めるのは、相手のチャンネルの変化ではなく、そのときの値です。",
            ),
        ),
        Mistake(
            edges_of_b_backwards,
            Text(
                "The edges of A are right, those of B have the wrong sign, so the count trembles on the spot. One rule does not "
                "fit both: "
                "after an edge of A forward the levels differ or agree just the other way round than after an edge of B.",
                "A のエッジは合っていますが、B のエッジの符号が逆で、数が行ったり来たりしています。A と B に同じ規則は使えません。"
                "正転のとき、A のエッジの直後と B のエッジの直後では、2 つの値が等しいかどうかが逆になります。",
            ),
        ),
        Mistake(
            edges_of_a_backwards,
            Text(
                "The edges of B are right, those of A have the wrong sign, so the count trembles on the spot. One rule does not "
                "fit both: "
                "write down a and b after each of the four forward edges and compare.",
                "B のエッジは合っていますが、A のエッジの符号が逆で、数が行ったり来たりしています。A と B に同じ規則は使えません。"
                "正転の 4 つのエッジについて、直後の a と b を書き出して比べてみましょう。",
            ),
        ),
        Mistake(
            direction_from_leading_level,
            Text(
                "An edge counts up only if A is 1 and B is 0 after it. Leading means that A changes first, in time; "
                "it is not that its level is higher.",
                "エッジの直後に A = 1, B = 0 のときだけ +1 としています。「A が進んでいる」とは A が時間的に先に変化することで、"
                "値が大きいことではありません。",
            ),
        ),
        Mistake(
            pauses_counted,
            Text(
                "Samples at which nothing changes are counted too. A shaft at rest gives no edge: ask first whether a or b "
                "changed at all.",
                "何も変化していないサンプルでも数えています。止まっている軸にエッジはありません。"
                "まず a か b が変化したかどうかを調べましょう。",
            ),
        ),
        Mistake(
            end_of_the_cycle_missed,
            Text(
                "The count falls back when a cycle is complete: between the last state, 01, and the first, 00, the difference "
                "of state numbers is "
                "3, yet the shaft moved by one edge. The states form a ring.",
                "1 周期が終わるたびに数が戻っています。"
                "最後の状態 01 と最初の状態 00 の番号の差は 3 ですが、軸が動いたのは 1 エッジです。"
                "状態は輪になってつながっています。",
            ),
        ),
        Mistake(
            step_back_counts_three,
            Text(
                "A step back counts +3, so that the count only ever grows. On the ring of states three forward is the same as "
                "one back: which of the two is it?",
                "1 つ戻るステップが +3 と数えられ、数が増えるばかりです。"
                "状態の輪では 3 つ進むのと 1 つ戻るのは同じ位置ですが、実際に起きたのはどちらでしょうか。",
            ),
        ),
        Mistake(
            step_over_the_cycle_dropped,
            Text(
                "The step between 01 and 00 is missing: one edge in every cycle is lost. The states form a ring; that step "
                "counts like any other.",
                "01 と 00 の間のステップが数えられず、1 周期ごとに 1 エッジ失われています。"
                "状態は輪になっているので、このステップも同じように数えます。",
            ),
        ),
        Mistake(
            state_returned,
            Text(
                "This is the number of the state, 0 to 3, not the count. The count starts at 0 and goes on beyond one cycle.",
                "これは状態の番号(0〜3)で、カウントではありません。カウントは 0 から始まり、1 周期を超えても続きます。",
            ),
        ),
        Mistake(
            states_as_binary_numbers,
            Text(
                "The bits are read as a binary number, and its change is taken for the count. Forward the states come in the order "
                "00, 10, 11, 01 (a Gray code), and after the last comes the first again.",
                "2 つのビットを 2 進数として読み、その変化をカウントとしています。正転での状態の順は 00, 10, 11, 01(グレイコード)で、"
                "最後の次はまた最初に戻ります。",
            ),
        ),
        Mistake(
            binary_order_of_states,
            Text(
                "The states are numbered like binary numbers. An encoder runs through them in another order, in which only one "
                "bit changes "
                "at a time: 00, 10, 11, 01.",
                "状態に 2 進数の順で番号を付けています。エンコーダでは一度に 1 ビットだけ変わる 00, 10, 11, 01 の順に進みます。",
            ),
        ),
        Mistake(
            binary_order_b_first,
            Text(
                "The states are numbered like binary numbers, with A as the lower bit. An encoder runs through them in another "
                "order, "
                "in which only one bit changes at a time: (a, b) = 00, 10, 11, 01.",
                "A を下位ビットとして、状態に 2 進数の順で番号を付けています。エンコーダでは (a, b) = 00, 10, 11, 01 のように、"
                "一度に 1 ビットだけ変わる順に進みます。",
            ),
        ),
        Mistake(
            steps_not_added_up,
            Text(
                "These are the single steps, -1, 0 or +1. The count is their running sum: np.cumsum.",
                "これは各サンプルのステップ(-1, 0, +1)です。カウントはその累積和です。np.cumsum を使いましょう。",
            ),
        ),
        Mistake(
            first_sample_left_out,
            Text(
                "The result is one shorter than the input. The first sample has a count too: 0, since nothing has moved yet.",
                "結果が入力より 1 つ短くなっています。最初のサンプルにもカウントがあります。まだ動いていないので 0 です。",
            ),
        ),
        Mistake(
            only_the_last_count,
            Text(
                "Only the count at the end comes back. Asked for is the count after each sample, as many as there are samples.",
                "最後のカウントだけが返っています。各サンプルの後のカウントを、サンプルの数だけ返しましょう。",
            ),
        ),
        Mistake(
            begins_with_the_state,
            Text(
                "The count begins with the number of the first state. It begins at 0 wherever in the cycle the encoder stands.",
                "最初の状態の番号からカウントが始まっています。エンコーダがどの状態で始まっても、最初は 0 です。",
            ),
        ),
        Mistake(
            begins_as_if_from_00,
            Text(
                "The first sample is treated as if the state before it had been 00. There is no sample before the first: its "
                "count is 0, "
                "whatever the state.",
                "最初のサンプルの前の状態を 00 とみなしています。"
                "最初のサンプルより前はないので、どの状態で始まっても最初のカウントは 0 です。",
            ),
        ),
        Mistake(
            begins_as_if_from_00_and_one_edge_back,
            Text(
                "The first sample is treated as if the state before it had been 00. There is no sample before the first: its "
                "count is 0, whatever the state.",
                "最初のサンプルの前の状態を 00 とみなしています。"
                "最初のサンプルより前はないので、どの状態で始まっても最初のカウントは 0 です。",
            ),
        ),
        Mistake(
            begins_as_if_from_00_and_two_edges,
            Text(
                "The first sample is treated as if the state before it had been 00. There is no sample before the first: its "
                "count is 0, whatever the state.",
                "最初のサンプルの前の状態を 00 とみなしています。"
                "最初のサンプルより前はないので、どの状態で始まっても最初のカウントは 0 です。",
            ),
        ),
        Mistake(
            begins_with_one,
            Text(
                "All counts are one too high: the count begins at 1. At the first sample nothing has moved yet.",
                "すべてのカウントが 1 大きく、1 から始まっています。最初のサンプルではまだ何も動いていません。",
            ),
        ),
        Mistake(
            one_sample_late,
            Text(
                "The counts come one sample late. Entry k is the count after sample k, with the edge between k-1 and k included.",
                "カウントが 1 サンプル遅れています。"
                "k 番目の値は、k-1 から k までの間のエッジを含めた、サンプル k の後のカウントです。",
            ),
        ),
        Mistake(
            whole_cycles,
            Text(
                "These are whole cycles: the count divided by 4 and rounded down. With 4x decoding every edge is one count.",
                "これは周期の数(カウントを 4 で割って切り捨てたもの)です。4 逓倍ではエッジ 1 つが 1 カウントです。",
            ),
        ),
        Mistake(
            divided_by_four,
            Text(
                "The counts are divided by 4: these are cycles. With 4x decoding every edge is one count.",
                "カウントを 4 で割っていて、周期の数になっています。4 逓倍ではエッジ 1 つが 1 カウントです。",
            ),
        ),
        Mistake(
            multiplied_by_four,
            Text(
                "Every edge counts four. 4x decoding means that all four edges of a cycle are counted, each as one.",
                "1 エッジを 4 と数えています。4 逓倍とは、1 周期の 4 つのエッジをそれぞれ 1 と数えることです。",
            ),
        ),
        Mistake(
            count_within_one_cycle,
            Text(
                "The count is cut back to 0..3 by a modulo. Only the difference of two states needs the modulo; the count goes on, "
                "and below 0 too.",
                "カウントを剰余で 0〜3 に戻しています。剰余が必要なのは状態の差だけです。"
                "カウントは 1 周期を超えても、負になっても続きます。",
            ),
        ),
        Mistake(
            levels_added_up,
            Text(
                "The levels are added up, so the count runs on while the shaft stands still. What counts are edges, the changes "
                "of level.",
                "信号の値そのものを足しているため、軸が止まっていても数が変わり続けます。数えるのはエッジ、つまり値の変化です。",
            ),
        ),
        Mistake(
            high_samples_counted,
            Text(
                "The samples at which A is 1 are counted; that depends on how long they last. What counts are edges, the "
                "changes of level.",
                "A が 1 であるサンプルの個数を数えています。これでは信号の長さで数が変わります。"
                "数えるのはエッジ、つまり値の変化です。",
            ),
        ),
        Mistake(
            both_edges_at_once_awaited,
            Text(
                "The count stays at 0 throughout. In quadrature only one channel changes at a time, so a product or an `and` of "
                "both changes "
                "never comes true.",
                "カウントがずっと 0 のままです。"
                "一度に変化するのは一方のチャンネルだけなので、両方の変化の積や and は成り立ちません。",
            ),
        ),
    ),
)
