"""line_command_changes(kind): does the robot's motion change? Notes 001, section 3.1: after set it does not, after adjust it does."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(kind):
    """Return True for "adjust", False for "set"; whatever is neither is refused."""
    if not isinstance(kind, str) or kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def cases(rng):
    """Draw from what is neither "set" nor "adjust": other cases, blanks, other words, no text at all."""

    def some(*words, count=1):
        return [(words[k],) for k in rng.permutation(len(words))[:count]]

    def by_letters():
        """Return the letters of adjust in another order, a word that nobody can list beforehand."""
        letters = list("adjust")
        while "".join(letters) == "adjust":
            rng.shuffle(letters)
        return "".join(letters)

    spelt_otherwise = [
        ("Set",),
        *some("SET", "sEt", "seT"),
        *some("Adjust", "ADJUST", "adJust"),
        *some(" set", "set ", "set\n"),
        *some("adjust ", " adjust", "\tadjust"),
    ]
    # one for each way to compare something else than the whole word
    other_words = [
        ("",),
        (by_letters(),),
        *some("setup", "settle", "adjusted", "adjust_pos", "set_pos", "set/adjust"),
        *some("reset", "readjust", "preset", "no set"),
        *some("se", "adj", "s", "a", "just", "et"),
        *some("stop", "start", "angle", "auto"),
        *some("get", "line", "no", "yes", "GL", "0"),
    ]
    return [
        Group(Text("set", "set"), 2, [("set",)]),
        Group(Text("adjust", "adjust"), 2, [("adjust",)]),
        Group(Text("capital letters and blanks", "大文字や空白を含む文字列"), 1, spelt_otherwise),
        Group(Text("other words, and the empty text", "別の文字列と空の文字列"), 1, other_words),
        Group(
            Text("no text: None and numbers", "文字列でないもの(None、数値)"),
            1,
            [(None,), (0,), (1,), (int(rng.integers(2, 9)),)],
        ),
    ]


def answers_exchanged(kind):
    if kind == "set":
        return True
    if kind == "adjust":
        return False
    raise ValueError("neither set nor adjust")


def always_true(kind):
    if kind in ("set", "adjust"):
        return True
    raise ValueError("neither set nor adjust")


def always_false(kind):
    if kind in ("set", "adjust"):
        return False
    raise ValueError("neither set nor adjust")


def everything_else_is_set(kind):
    return kind == "adjust"


def everything_else_is_adjust(kind):
    return kind != "set"


def exchanged_and_everything_else_adjust(kind):
    return kind == "set"


def exchanged_and_everything_else_set(kind):
    return kind != "adjust"


def nothing_returned_for_others(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    return None


def error_returned(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    return ValueError("neither set nor adjust")


def error_class_returned(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    return ValueError


def text_returned_for_others(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    return "ValueError"


def key_error(kind):
    return {"set": False, "adjust": True}[kind]


def type_error(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    raise TypeError("neither set nor adjust")


def plain_exception(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    raise Exception("neither set nor adjust")


def assertion(kind):
    if kind not in ("set", "adjust"):
        raise AssertionError
    return kind == "adjust"


def runtime_error(kind):
    if kind == "set":
        return False
    if kind == "adjust":
        return True
    raise RuntimeError("neither set nor adjust")


def capitals_accepted(kind):
    if str(kind).lower() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return str(kind).lower() == "adjust"


def blanks_accepted(kind):
    if str(kind).strip() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return str(kind).strip() == "adjust"


def capitals_and_blanks_accepted(kind):
    if str(kind).strip().lower() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return str(kind).strip().lower() == "adjust"


def capitals_accepted_and_no_text_fails(kind):
    if kind.lower() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind.lower() == "adjust"


def blanks_accepted_and_no_text_fails(kind):
    if kind.strip() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind.strip() == "adjust"


def capitals_and_blanks_accepted_and_no_text_fails(kind):
    if kind.strip().lower() not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind.strip().lower() == "adjust"


def only_the_first_letter_read(kind):
    if str(kind)[:1] not in ("s", "a"):
        raise ValueError("neither set nor adjust")
    return str(kind)[:1] == "a"


def beginnings_accepted(kind):
    if str(kind).startswith("set"):
        return False
    if str(kind).startswith("adjust"):
        return True
    raise ValueError("neither set nor adjust")


def parts_of_words_accepted(kind):
    if "set" in str(kind):
        return False
    if "adjust" in str(kind):
        return True
    raise ValueError("neither set nor adjust")


def pieces_of_the_words_accepted(kind):
    if str(kind) in "set":
        return False
    if str(kind) in "adjust":
        return True
    raise ValueError("neither set nor adjust")


def pieces_of_the_words_accepted_without_text_check(kind):
    if kind in "set":
        return False
    if kind in "adjust":
        return True
    raise ValueError("neither set nor adjust")


def empty_is_set(kind):
    if not kind:
        return False
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def none_is_set(kind):
    if kind is None:
        return False
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def numbers_stand_for_the_words(kind):
    if kind not in ("set", "adjust", 0, 1):
        raise ValueError("neither set nor adjust")
    return kind in ("adjust", 1)


def other_types_fail_otherwise(kind):
    kind = kind + ""
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def only_text_refused(kind):
    if isinstance(kind, str) and kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def only_other_types_refused(kind):
    if not isinstance(kind, str):
        raise ValueError("neither set nor adjust")
    return kind == "adjust"


def always_refused(kind):
    raise ValueError("neither set nor adjust")


def set_refused(kind):
    if kind != "adjust":
        raise ValueError("not adjust")
    return True


def adjust_refused(kind):
    if kind != "set":
        raise ValueError("not set")
    return False


def words_returned(kind):
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return "yes" if kind == "adjust" else "no"


def truth_as_text(kind):
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return str(kind == "adjust")


def list_returned(kind):
    if kind not in ("set", "adjust"):
        raise ValueError("neither set nor adjust")
    return np.array([kind == "adjust"])


EXERCISE = Exercise(
    name="line_command_changes",
    notebook="odometry/frames",
    points=5,
    parameters=("kind",),
    reference=reference,
    cases=cases,
    refuses=(ValueError,),
    examples=(("set",), ("adjust",), ("Set",)),
    mistakes=(
        Mistake(
            answers_exchanged,
            Text(
                "set and adjust are exchanged. After set the robot drives on along the same line, because SP stays; adjust "
                "moves SP with GL.",
                "set と adjust が逆です。set では SP がそのままなので、ロボットは同じ直線をたどり続けます。"
                "adjust は SP を GL と一緒に動かします。",
            ),
        ),
        Mistake(
            always_true,
            Text(
                "set and adjust both come out True. If both changed the motion, there would be no need of two calls: look at "
                "what each does to SP.",
                "set も adjust も True になっています。どちらでも動きが変わるなら、関数が 2 つある必要は"
                "ありません。それぞれが SP をどう扱うかを見てみましょう。",
            ),
        ),
        Mistake(
            always_false,
            Text(
                "set and adjust both come out False. If neither changed the motion, there would be no need of two calls: "
                "look at what each does to SP.",
                "set も adjust も False になっています。どちらでも動きが変わらないなら、関数が 2 つある必要は"
                "ありません。それぞれが SP をどう扱うかを見てみましょう。",
            ),
        ),
        Mistake(
            everything_else_is_set,
            Text(
                "set and adjust are right, but everything else counts as set. A misspelt word must not pass silently: the "
                'docstring asks for a ValueError. (Python reads kind == "set" or "adjust" as (kind == "set") or "adjust", '
                "which is always true.)",
                "set と adjust は合っていますが、それ以外がすべて set として扱われています。書き間違いを"
                "黙って通してはいけません。docstring のとおり ValueError にしましょう。"
                '(kind == "set" or "adjust" という条件は'
                ' (kind == "set") or "adjust" と解釈され、いつも真になります。)',
            ),
        ),
        Mistake(
            everything_else_is_adjust,
            Text(
                "set and adjust are right, but everything else counts as adjust. A misspelt word must not pass silently: the "
                "docstring asks for a ValueError.",
                "set と adjust は合っていますが、それ以外がすべて adjust として扱われています。書き間違いを"
                "黙って通してはいけません。docstring のとおり ValueError にしましょう。",
            ),
        ),
        Mistake(
            exchanged_and_everything_else_adjust,
            Text(
                "set and adjust are exchanged (the line stays after set, because SP does), and everything else counts as "
                "adjust instead of being refused with a ValueError.",
                "set と adjust が逆です(set では SP がそのままなので、直線も変わりません)。また、"
                "それ以外の入力が ValueError にならず、adjust と同じ扱いになっています。",
            ),
        ),
        Mistake(
            exchanged_and_everything_else_set,
            Text(
                "set and adjust are exchanged (the line stays after set, because SP does), and everything else counts as set "
                "instead of being refused with a ValueError.",
                "set と adjust が逆です(set では SP がそのままなので、直線も変わりません)。また、"
                "それ以外の入力が ValueError にならず、set と同じ扱いになっています。",
            ),
        ),
        Mistake(
            nothing_returned_for_others,
            Text(
                "set and adjust are right, but for anything else the function ends without an error and returns None. Is "
                "there a line that raises the ValueError?",
                "set と adjust は合っていますが、それ以外では例外が起きずに None が返っています。"
                "ValueError を発生させる行がありますか。",
            ),
        ),
        Mistake(
            error_returned,
            Text(
                "set and adjust are right, but the ValueError is returned like a value. An error is not returned but raised: "
                "which keyword does that?",
                "set と adjust は合っていますが、ValueError を値として return しています。例外は"
                "返すのではなく発生させます。どのキーワードを使いますか。",
            ),
        ),
        Mistake(
            error_class_returned,
            Text(
                "set and adjust are right, but the class ValueError is returned like a value. An error is not returned but "
                "raised: which keyword does that?",
                "set と adjust は合っていますが、ValueError というクラスを値として return しています。"
                "例外は返すのではなく発生させます。どのキーワードを使いますか。",
            ),
        ),
        Mistake(
            text_returned_for_others,
            Text(
                "set and adjust are right, but for anything else a text comes back. An error is not returned as text but raised.",
                "set と adjust は合っていますが、それ以外では文字列が返っています。エラーは文字列で返すのではなく、"
                "例外として発生させます。",
            ),
        ),
        Mistake(
            key_error,
            Text(
                "set and adjust are right, but a look-up in a dict fails with KeyError. A ValueError is asked for: look "
                "before you look it up, or catch the KeyError and raise the other.",
                "set と adjust は合っていますが、dict を引いたときに KeyError になっています。求めるのは"
                " ValueError です。引く前に確かめるか、KeyError を捕まえて ValueError を"
                "発生させましょう。",
            ),
        ),
        Mistake(
            type_error,
            Text(
                "set and adjust are right, but anything else is refused with TypeError. A ValueError is asked for, whatever "
                "kind of thing was given.",
                "set と adjust は合っていますが、それ以外が TypeError になっています。"
                "どんな種類の値に対しても、求めるのは ValueError です。",
            ),
        ),
        Mistake(
            plain_exception,
            Text(
                "set and adjust are right, but anything else is refused with a plain Exception. Say which: a ValueError is "
                "asked for, so that the caller can catch just that.",
                "set と adjust は合っていますが、それ以外がただの Exception になっています。呼び出した側が"
                "それだけを捕まえられるように、ValueError と指定しましょう。",
            ),
        ),
        Mistake(
            assertion,
            Text(
                "set and adjust are right, but anything else ends in an AssertionError. assert is for your own mistakes in "
                "tests; for a caller's wrong input raise ValueError.",
                "set と adjust は合っていますが、それ以外が AssertionError になっています。"
                "assert は自分の書き間違いを見つけるためのものです。入力の間違いには ValueError を使います。",
            ),
        ),
        Mistake(
            runtime_error,
            Text(
                "set and adjust are right, but anything else is refused with RuntimeError. A ValueError is asked for.",
                "set と adjust は合っていますが、それ以外が RuntimeError になっています。求めるのは ValueError です。",
            ),
        ),
        Mistake(
            capitals_accepted,
            Text(
                'Capital letters are accepted (lower). Only exactly "set" and "adjust" count: YP-Spur would not know Set either.',
                '大文字を含む文字列も(lower で)受け付けています。認めるのは "set" と "adjust" にぴったり一致するものだけです。',
            ),
        ),
        Mistake(
            blanks_accepted,
            Text(
                'Words with blanks around them are accepted (strip). Only exactly "set" and "adjust" count.',
                "前後に空白のある文字列も(strip で)受け付けています。認めるのは"
                ' "set" と "adjust" にぴったり一致するものだけです。',
            ),
        ),
        Mistake(
            capitals_and_blanks_accepted,
            Text(
                'Capital letters and blanks are accepted (lower and strip). Only exactly "set" and "adjust" count.',
                "大文字や前後の空白も(lower や strip で)受け付けています。認めるのは"
                ' "set" と "adjust" にぴったり一致するものだけです。',
            ),
        ),
        Mistake(
            capitals_accepted_and_no_text_fails,
            Text(
                "Capital letters are accepted (lower), and None or a number ends in an AttributeError, because only texts "
                'have such methods. Only exactly "set" and "adjust" count, and == works on anything.',
                "大文字を含む文字列も(lower で)受け付けています。また、None や数値には文字列のメソッドが"
                "ないので AttributeError になります。認めるのは"
                ' "set" と "adjust" にぴったり一致するものだけで、== ならどんな値とも比べられます。',
            ),
        ),
        Mistake(
            blanks_accepted_and_no_text_fails,
            Text(
                "Words with blanks around them are accepted (strip), and None or a number ends in an AttributeError, because "
                'only texts have such methods. Only exactly "set" and "adjust" count, and == works on anything.',
                "前後に空白のある文字列も(strip で)受け付けています。また、None や数値には文字列のメソッドが"
                "ないので AttributeError になります。認めるのは"
                ' "set" と "adjust" にぴったり一致するものだけで、== ならどんな値とも比べられます。',
            ),
        ),
        Mistake(
            capitals_and_blanks_accepted_and_no_text_fails,
            Text(
                "Capital letters and blanks are accepted (lower and strip), and None or a number ends in an AttributeError, "
                'because only texts have such methods. Only exactly "set" and "adjust" count, and == works on anything.',
                "大文字や前後の空白も(lower や strip で)受け付けています。また、None や数値には文字列のメソッドが"
                "ないので AttributeError になります。認めるのは"
                ' "set" と "adjust" にぴったり一致するものだけで、== ならどんな値とも比べられます。',
            ),
        ),
        Mistake(
            only_the_first_letter_read,
            Text(
                "Only the first letter is looked at, so that stop counts as set. Compare the whole word.",
                "最初の 1 文字しか見ていないので、stop でも set と同じ扱いになります。文字列全体を比べましょう。",
            ),
        ),
        Mistake(
            beginnings_accepted,
            Text(
                "Words that only begin with set or adjust are accepted (startswith). Compare the whole word.",
                "set や adjust で始まるだけの文字列も(startswith で)受け付けています。文字列全体を比べましょう。",
            ),
        ),
        Mistake(
            parts_of_words_accepted,
            Text(
                'Any word that contains set or adjust is accepted: "set" in kind is true of reset as well. Compare the whole '
                "word.",
                'set や adjust を含む文字列なら何でも受け付けています。"set" in kind は'
                " reset でも成り立ちます。文字列全体を比べましょう。",
            ),
        ),
        Mistake(
            pieces_of_the_words_accepted,
            Text(
                'Pieces of the words are accepted, and even the empty text: kind in "set" asks whether kind is a part of it. '
                "Compare with ==, or put the words into a tuple.",
                '単語の一部分や、空の文字列まで受け付けています。kind in "set" は「set の一部か」という意味です。'
                "== で比べるか、単語をタプルに入れましょう。",
            ),
        ),
        Mistake(
            pieces_of_the_words_accepted_without_text_check,
            Text(
                'kind in "set" asks whether kind is a part of the word: pieces and the empty text pass, and None or a number '
                "ends in a TypeError. Compare with ==, or put the words into a tuple.",
                'kind in "set" は「set の一部か」という意味です。そのため単語の一部分や空の文字列が通り、'
                "None や数値では TypeError になります。== で比べるか、単語をタプルに入れましょう。",
            ),
        ),
        Mistake(
            empty_is_set,
            Text(
                "Other words are refused, but the empty text, None and 0 count as set. Nothing given is no order either: "
                "refuse it with a ValueError.",
                "ほかの文字列は断っていますが、空の文字列や None、0 が set として扱われています。"
                "何も指定されていないときも ValueError にしましょう。",
            ),
        ),
        Mistake(
            none_is_set,
            Text(
                "Other words are refused, but None counts as set. There is no default: refuse it with a ValueError.",
                "ほかの文字列は断っていますが、None が set として扱われています。既定値はありません。"
                "None も ValueError にしましょう。",
            ),
        ),
        Mistake(
            numbers_stand_for_the_words,
            Text(
                "0 and 1 are accepted for set and adjust. Only the two words count.",
                "0 と 1 が set と adjust のかわりに受け付けられています。認めるのは 2 つの単語だけです。",
            ),
        ),
        Mistake(
            other_types_fail_otherwise,
            Text(
                "Texts are treated rightly, but None and numbers end in a TypeError. Either it is raised for them (a "
                "ValueError is asked for here, too), or something is done with kind that only works on text; == works on "
                "anything.",
                "文字列の扱いは合っていますが、None や数値では TypeError になります。自分で発生させているなら、"
                "ここも ValueError にします。文字列にしか使えない操作をしているなら、== はどんな値とも比べられることを"
                "使いましょう。",
            ),
        ),
        Mistake(
            only_text_refused,
            Text(
                "Wrong texts are refused, but None and numbers are let through. Anything but the two words must be refused.",
                "違う文字列は断っていますが、None や数値が通ってしまいます。2 つの単語以外はすべて断る必要があります。",
            ),
        ),
        Mistake(
            only_other_types_refused,
            Text(
                "None and numbers are refused, but wrong texts are let through. Anything but the two words must be refused.",
                "None や数値は断っていますが、違う文字列が通ってしまいます。2 つの単語以外はすべて断る必要があります。",
            ),
        ),
        Mistake(
            always_refused,
            Text(
                "Everything is refused, even set and adjust. Look at the condition before raise (with != and or it is always "
                "true).",
                "set や adjust まで含めて、すべてが断られています。raise の前の条件を見直しましょう(!= を"
                " or でつなぐと、いつも真になります)。",
            ),
        ),
        Mistake(
            set_refused,
            Text(
                "adjust is right, but set is refused as well. It is a proper call whose answer is just no.",
                "adjust は合っていますが、set まで断られています。set も正しい呼び出しで、ただ動きが変わらないだけです。",
            ),
        ),
        Mistake(
            adjust_refused,
            Text(
                "set is right, but adjust is refused as well. It is a proper call whose answer is just yes.",
                "set は合っていますが、adjust まで断られています。adjust も正しい呼び出しで、ただ動きが変わるだけです。",
            ),
        ),
        Mistake(
            words_returned,
            Text(
                "Right, but in words: yes and no. A bool is asked for, True or False, without quotation marks.",
                '判断は合っていますが、"yes" や "no" という文字列が返っています。求めるのは'
                " bool(引用符の付かない True か False)です。",
            ),
        ),
        Mistake(
            truth_as_text,
            Text(
                'Right, but as text: "True" in quotation marks is no truth value. Return the bool itself.',
                '判断は合っていますが、引用符の付いた文字列の "True" や "False" が返っています。'
                "bool の値そのものを返しましょう。",
            ),
        ),
        Mistake(
            list_returned,
            Text(
                "Right, but wrapped in an array or list of one entry. Return the bool itself.",
                "判断は合っていますが、要素 1 つの配列(リスト)に入っています。bool の値そのものを返しましょう。",
            ),
        ),
    ),
)
