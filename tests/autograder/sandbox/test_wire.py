import io
import json
import math
import struct
import tracemalloc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst

from autograder.sandbox import wire
from autograder.sandbox.wire import (
    MAX_ARRAYS,
    MAX_JSON,
    MAX_VALUES,
    WireError,
    packed_interview,
    packed_questions,
    receive,
    send,
    unpacked_interview,
    unpacked_questions,
)
from course.answers import Interview, Missing, Question, Reply, Trouble
from course.plain import Odd, identical


class EndOfStreamError(Exception):
    """What a reader raises that has no more bytes."""


def reader(data):
    stream = io.BytesIO(data)

    def read(count):
        got = stream.read(count)
        if len(got) != count:
            raise EndOfStreamError
        return got

    return read


def frame(text, arrays=b"", magic=b"DR1\n"):
    return struct.pack(">4sII", magic, len(text), len(arrays)) + text + arrays


def sent(message):
    stream = io.BytesIO()
    send(stream, message)
    return stream.getvalue()


def dictionary(**items):
    return {"@": "dict", "items": [[key, value] for key, value in items.items()]}


def array(dtype="float64", shape=(1,)):
    return {"@": "array", "dtype": dtype, "shape": list(shape)}


numbers = st.one_of(
    *[npst.scalar_dtypes().filter(lambda dtype: dtype.kind in "biuf" and dtype.itemsize <= 8)],
).map(lambda dtype: dtype.newbyteorder("="))
plain_data = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**63), 2**63 - 1)
    | st.floats()
    | st.text(st.characters(exclude_categories=["Cs"]))
    | npst.arrays(numbers, npst.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=4))
    | st.builds(Odd, st.text(st.characters(codec="utf-8"), max_size=80), st.text(st.characters(codec="utf-8"), max_size=80)),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(st.characters(codec="utf-8")), inner, max_size=4),
    max_leaves=20,
)


def same(a, b):
    """Are they the same? NaN is NaN."""
    if isinstance(a, float) and isinstance(b, float):
        return struct.pack("d", a) == struct.pack("d", b) or (math.isnan(a) and math.isnan(b))
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    return identical(a, b)


@given(plain_data)
def test_plain_data_comes_out_as_it_went_in(value):
    [received] = receive(reader(sent({"value": value}))).values()
    assert same(received, value)


@given(plain_data)
def test_arrays_that_come_out_can_be_written_to_and_hold_no_bytes_of_the_frame(value):
    data = sent({"value": [value, np.zeros(2)]})
    received = receive(reader(data))["value"][1]
    received[:] = 1
    assert received.flags.owndata
    assert receive(reader(data))["value"][1].tolist() == [0, 0]


def test_messages_follow_one_another():
    read = reader(sent({"id": 1}) + sent({"id": 2, "x": np.arange(3)}) + sent({"id": 3}))
    assert [receive(read)["id"] for _ in range(3)] == [1, 2, 3]


texts = st.text(st.characters(codec="utf-8"), max_size=20)
counts = st.integers(0, 2**31)
troubles = st.builds(Trouble, texts, texts, texts, texts, counts, texts)
replies = st.builds(
    Reply,
    plain_data,
    st.none() | troubles,
    st.lists(plain_data, max_size=3).map(tuple),
    texts,
    st.lists(texts, max_size=5).map(tuple),
)
interviews = st.builds(
    Interview,
    st.none() | st.builds(Missing, texts, texts, st.none() | troubles),
    texts,
    st.none() | st.tuples(counts, texts),
    st.lists(replies, max_size=3).map(tuple),
)


@given(interviews)
def test_an_interview_comes_out_as_it_went_in(talk):
    received = unpacked_interview(receive(reader(sent({"interview": packed_interview(talk)})))["interview"])
    assert (received.missing, received.kind, received.mismatch) == (talk.missing, talk.kind, talk.mismatch)
    assert [reply.trouble for reply in received.replies] == [reply.trouble for reply in talk.replies]
    assert same([[r.value, list(r.inputs)] for r in received.replies], [[r.value, list(r.inputs)] for r in talk.replies])
    assert [(r.printed, r.warned) for r in received.replies] == [(r.printed, r.warned) for r in talk.replies]


@given(st.lists(st.builds(Question, st.lists(plain_data, max_size=3).map(tuple), st.booleans()), max_size=3))
def test_questions_come_out_as_they_went_in(questions):
    received = unpacked_questions(receive(reader(sent({"q": packed_questions(tuple(questions))})))["q"])
    assert [question.symbols for question in received] == [question.symbols for question in questions]
    assert same([list(question.args) for question in received], [list(question.args) for question in questions])


SUMMARY = {
    "lines": [{"xy": np.zeros((3, 2)), "label": "path", "visible": True}],
    "points": [],
    "labels": ["x [m]", "y [m]"],
    "title": "",
    "scales": ["linear", "log"],
    "limits": np.zeros(4),
    "aspect": 1.0,
    "legend": ["path"],
}


def test_the_summary_of_a_graph_comes_out_as_it_went_in():
    data = packed_interview(Interview(kind="axes", figure=SUMMARY))
    assert same(unpacked_interview(receive(reader(sent({"i": data})))["i"]).figure, SUMMARY)


NO_SUMMARY = [
    {"lines": 5},
    {"lines": [5]},
    {"lines": [{"xy": np.zeros((3, 3)), "label": "", "visible": True}]},
    {"points": [{"xy": np.zeros((3, 2)), "label": 1, "visible": True}]},
    {"points": [{"xy": np.zeros((3, 2), int), "label": "", "visible": True}]},
    {"labels": ["x"]},
    {"scales": "log"},
    {"limits": np.zeros(3)},
    {"limits": [0.0, 1.0, 0.0, 1.0]},
    {"aspect": "equal"},
    {"legend": [None]},
]


@pytest.mark.parametrize("change", NO_SUMMARY)
def test_what_is_no_summary_of_a_graph_is_refused(change):
    with pytest.raises(WireError, match="not the summary"):
        unpacked_interview(packed_interview(Interview(kind="axes", figure=SUMMARY | change)))


# what must not come through

MALFORMED = {
    "another protocol": frame(b"{}", magic=b"HTTP"),
    "text too large": struct.pack(">4sII", b"DR1\n", MAX_JSON + 1, 0),
    "arrays too large": struct.pack(">4sII", b"DR1\n", 2, MAX_ARRAYS + 1),
    "not JSON": frame(b"{'id': 1}"),
    "not UTF-8": frame(b'"\xff"'),
    "empty": frame(b""),
    "nested lists": frame(b"[" * 50_000 + b"]" * 50_000),
    "lists nested below the parser's limit": frame(json.dumps(dictionary(a=eval("[" * 60 + "]" * 60))).encode()),
    "nested dictionaries": frame(b'{"@":"dict","items":[["a",' * 200 + b"1" + b"]]}" * 200),
    "no dictionary": frame(b"[]"),
    "null": frame(b"null"),
    "bare dictionary": frame(b'{"id": 1}'),
    "unknown kind": frame(b'{"@": "pickle", "data": "gASVAAAA"}'),
    "items are no list": frame(b'{"@": "dict", "items": {"a": 1}}'),
    "item is no pair": frame(b'{"@": "dict", "items": [["a"]]}'),
    "key is no text": frame(b'{"@": "dict", "items": [[1, 2]]}'),
    "odd of a number": frame(json.dumps(dictionary(a={"@": "odd", "kind": 1, "type_name": "x"})).encode()),
    "more values than anybody sends": frame(b'{"@": "dict", "items": [["a", [' + b"0," * MAX_VALUES + b"0]]]}"),
    "endless number": frame(json.dumps(dictionary(a=10**30)).encode()),
    "number too long to read": frame(b'{"@": "dict", "items": [["a", ' + b"9" * 5000 + b"]]}"),
    "array longer than its frame": frame(json.dumps(dictionary(a=array(shape=[2]))).encode(), bytes(8)),
    "two arrays out of one": frame(json.dumps(dictionary(a=array(), b=array())).encode(), bytes(8)),
    "array of objects": frame(json.dumps(dictionary(a=array("object"))).encode(), bytes(8)),
    "array of dates": frame(json.dumps(dictionary(a=array("datetime64[s]"))).encode(), bytes(8)),
    "array of records": frame(json.dumps(dictionary(a=array("f8,f8"))).encode(), bytes(16)),
    "array of complex numbers": frame(json.dumps(dictionary(a=array("complex128"))).encode(), bytes(16)),
    "dtype is no text": frame(json.dumps(dictionary(a=array(["float64"]))).encode(), bytes(8)),
    "shape is no list": frame(json.dumps(dictionary(a={**array(), "shape": 1})).encode(), bytes(8)),
    "negative shape": frame(json.dumps(dictionary(a=array(shape=[-1]))).encode(), bytes(8)),
    "shape of floats": frame(json.dumps(dictionary(a=array(shape=[1.0]))).encode(), bytes(8)),
    "shape of truth values": frame(json.dumps(dictionary(a=array(shape=[True]))).encode(), bytes(8)),
    "shape that overflows": frame(json.dumps(dictionary(a=array(shape=[2**26] * 8))).encode(), bytes(8)),
    "empty shape that overflows": frame(json.dumps(dictionary(a=array(shape=[0] + [2**26] * 7))).encode()),
    "too many dimensions": frame(json.dumps(dictionary(a=array(shape=[1] * 9))).encode(), bytes(8)),
    "neither true nor false": frame(json.dumps(dictionary(a=array("bool"))).encode(), b"\x02"),
}


@pytest.mark.parametrize("data", MALFORMED.values(), ids=MALFORMED.keys())
def test_a_malformed_frame_is_refused(data):
    with pytest.raises(WireError):
        receive(reader(data))


@given(st.binary(max_size=200))
def test_any_bytes_give_a_message_or_an_error_of_ours(data):
    with pytest.raises((WireError, EndOfStreamError)):
        receive(reader(data))


json_data = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=5)
    | st.sampled_from(["array", "dict", "odd", "bool"]),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.sampled_from(["@", "dtype", "shape", "items", "kind", "type_name"]), inner)
        | st.fixed_dictionaries({"@": st.just("array"), "dtype": st.sampled_from(["float64", "bool", "uint8"]), "shape": inner})
    ),
)


@given(json_data, st.binary(max_size=40))
def test_any_json_gives_a_message_or_a_wire_error(value, arrays):
    text = json.dumps(dictionary(a=value)).encode(errors="replace")
    try:
        received = receive(reader(frame(text, arrays)))
    except WireError:
        return
    assert received.keys() == {"a"}


@given(plain_data)
def test_any_plain_data_is_an_interview_or_a_wire_error(value):
    for data in (
        value,
        dict.fromkeys(packed_interview(Interview()), value),
        {**packed_interview(Interview()), "replies": [value]},
    ):
        try:
            assert isinstance(unpacked_interview(data), Interview)
        except WireError:
            continue


@given(interviews, st.data())
def test_a_cut_off_frame_waits_for_more(talk, data):
    whole = sent({"interview": packed_interview(talk)})
    end = data.draw(st.integers(0, len(whole) - 1))
    with pytest.raises(EndOfStreamError):
        receive(reader(whole[:end]))


def test_the_lengths_are_looked_at_before_anything_is_read():
    asked = []

    def read(count):
        asked.append(count)
        return struct.pack(">4sII", b"DR1\n", 2**32 - 1, 2**32 - 1)

    with pytest.raises(WireError):
        receive(read)
    assert asked == [12]


def test_what_is_too_large_is_not_even_sent():
    stream = io.BytesIO()
    for message in ({"a": "x" * (MAX_JSON + 1)}, {"a": np.zeros(MAX_ARRAYS // 8 + 1)}):
        with pytest.raises(WireError):
            send(stream, message)
    assert stream.getvalue() == b""


def test_halves_of_surrogate_pairs_are_written_out():
    received = receive(
        reader(
            frame(json.dumps(dictionary(a="x\ud800", **{"k\udfff": {"@": "odd", "kind": "\ud800", "type_name": ""}})).encode())
        )
    )
    assert received == {"a": "x\\ud800", "k\\udfff": Odd("\\ud800", "")}


@pytest.mark.parametrize("text", ["日本語", "😀", "\0", "\u202e"])
def test_other_text_is_left_alone(text):
    assert receive(reader(sent({"a": text}))) == {"a": text}


def test_long_texts_are_shortened():
    long = "x" * 10_000
    trouble = Trouble(long, long, long, long, 1, long)
    talk = Interview(Missing(long, long, trouble), long, (1, long), (Reply(1.0, trouble, (), long, (long,) * 20),))
    received = unpacked_interview(packed_interview(talk))
    sizes = [
        received.missing.reason,
        received.missing.trouble.message,
        received.kind,
        received.mismatch[1],
        received.replies[0].printed,
    ]
    assert [len(text) for text in sizes] == [80, 500, 80, 200, 2000]
    assert [len(text) for text in received.replies[0].warned] == [500] * 5


# memory


def peak_of(call, *arguments):
    """The most memory that a call takes, in bytes, and the name of what it raised."""
    tracemalloc.start()
    try:
        call(*arguments)
        raised = ""
    except Exception as error:
        raised = type(error).__name__
    finally:
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return peak, raised


#: what 16 MB may be filled with: a unit that is repeated
FILLED = {
    "lists": "[],",
    "nested lists": "[[[]]],",
    "dictionaries": '{"@":"dict","items":[]},',
    "bare dictionaries": "{},",
    "arrays": '{"@":"array","dtype":"bool","shape":[0]},',
    "numbers": "1.5,",
    "long numbers": "9" * 4000 + ",",
    "texts": '"\u3042",',
    "wide texts": f'"{"😀" * 1000}",',
    "halves of pairs": f'"{chr(92)}ud800",',
    "one text": "x",
    "one text of marks": ",[{",
    "quotes": '"',
    "backslashes": chr(92),
    "spaces": " ",
}


@pytest.mark.parametrize("unit", FILLED.values(), ids=FILLED.keys())
def test_a_message_takes_no_more_than_a_few_times_the_memory_of_its_bytes(unit, monkeypatch):
    """At a fiftieth of the limits: what takes memory grows with the bytes, and measuring it takes time."""
    most = MAX_VALUES // 50
    monkeypatch.setattr(wire, "MAX_VALUES", most)
    for size in (MAX_JSON // 50, 3 * most):
        quote = '"' if unit in ("x", ",[{") else ""
        text = '{"@":"dict","items":[["a",[' + quote + unit * ((size - 50) // len(unit.encode())) + (quote or "0") + "]]]}"
        peak, raised = peak_of(receive, reader(frame(text.encode())))
        assert raised in ("", "WireError")
        # the second is what so many of the smallest values take, packed and unpacked
        assert peak < 8 * size + 150 * most


def test_as_many_values_as_somebody_may_send_are_received():
    values = [[]] * (MAX_VALUES // 2 - 100)
    assert len(receive(reader(sent({"a": values})))["a"]) == len(values)
    with pytest.raises(WireError):
        sent({"a": [[]] * (MAX_VALUES // 2 + 1)})


def test_a_full_frame_of_empty_lists_is_refused_before_any_of_them_is_made():
    data = frame(b'{"@":"dict","items":[["a",[' + b"[]," * (MAX_JSON // 3 - 20) + b"0]]]}")
    peak, raised = peak_of(receive, reader(data))
    assert raised == "WireError"
    assert peak < 3 * len(data)
