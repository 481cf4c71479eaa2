"""Readers: clean logs in every honest dress, dirty logs with the right complaint, and the search for data."""

import numpy as np
import pytest

from course import logs
from course.logs import LogError, data_path, read_encoder_log, read_imu_log, read_truth

ROWS = [[1700000000.123456, 1, -2, 3.5, 0], [1700000000.128456, 40, -41, 0, -7.25]]
PLAIN = "1700000000.123456,1,-2,3.5,0\n1700000000.128456,40,-41,0,-7.25\n"
NAMES = ["time", "counter1", "counter2", "pwm1", "pwm2"]
GOOD = "0.0,1,2,3,4\n"


@pytest.fixture
def log_file(tmp_path):
    def written(content):
        path = tmp_path / "a.dat"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return written


def found(path):
    log = read_encoder_log(path)
    assert list(log) == NAMES
    return np.column_stack(list(log.values()))


@pytest.mark.parametrize(
    "content",
    [
        PLAIN,
        PLAIN.rstrip("\n"),
        PLAIN.replace(",", ", "),
        PLAIN.replace(",", " , "),
        PLAIN.replace(",", " "),
        PLAIN.replace(",", "\t"),
        PLAIN.replace(",", "   ").replace("17", "  17"),
        PLAIN.replace("\n", "  \n"),
        PLAIN.replace("\n", "\r\n"),
        PLAIN.replace("\n", "\r"),
        "\ufeff" + PLAIN,
        "\ufeff# 時刻\n" + PLAIN,
        "\n\n" + PLAIN.replace("\n", "\n \t\n") + "\n",
        "# Time [s], a, b, c, d\n" + PLAIN,
        "  # a comment after blanks\n" + PLAIN.replace("\n", "\n\t#another, 1, 2\n"),
        PLAIN + "#",
        PLAIN.replace(",", " ", 4),
        PLAIN.replace(",", " ", 6),
        PLAIN.replace(",-2", ",-2.").replace(",40", ",+4e1").replace("-7.25", "-.725E+01").replace(",0,", ",.0,"),
    ],
)
def test_encoder_log_in_any_honest_dress(log_file, content):
    np.testing.assert_array_equal(found(log_file(content)), ROWS)


def test_columns_are_arrays_of_their_own(log_file):
    log = read_encoder_log(log_file(PLAIN))
    assert all(column.dtype == np.float64 and column.shape == (2,) and column.flags.owndata for column in log.values())
    assert all(column.flags.c_contiguous and column.flags.writeable for column in log.values())


def test_a_single_row_is_a_log(log_file):
    np.testing.assert_array_equal(found(log_file(GOOD)), [[0, 1, 2, 3, 4]])


def test_time_may_run_back(log_file):
    np.testing.assert_array_equal(read_encoder_log(str(log_file("3,0,0,0,0\n2,0,0,0,0\n")))["time"], [3, 2])


@pytest.mark.parametrize(
    ("bad", "messages"),
    [
        ("1,2,3,4", ("found 4 value(s) in '1,2,3,4'; expected 5 (time, counter1, ", "値が4個です")),
        ("1,2,3,4,5,6", ("found 6 value(s)", "値が6個です")),
        ("1 2 3", ("found 3 value(s)", "値が3個です")),
        ("1,2,3,4,5,", ("found 6 value(s)", "値が6個です")),
        ("1;2;3;4;5", ("found 1 value(s)", "値が1個です")),
        ("1,2,3,4,5 # why", ("found 7 value(s)", "値が7個です")),
        ("1,2,3,4,5#why", ("found '5#why' in column 5 (pwm2); expected a number", "5列目(pwm2)が'5#why'です")),
        ("1,x,3,4,5", ("found 'x' in column 2 (counter1); expected a number", "2列目(counter1)が'x'です")),
        ("Time,c1,c2,p1,p2", ("found 'Time' in column 1 (time)", "1列目(time)")),
        ("1,2,3O,4,5", ("found '3O' in column 3 (counter2)", "3列目(counter2)")),
        ("1,1_000,3,4,5", ("found '1_000' in column 2", "2列目")),
        ("1,0x10,3,4,5", ("found '0x10' in column 2", "2列目")),
        ("1,\uff12,3,4,5", ("found '\uff12' in column 2", "2列目")),
        ("1,,3,4,5", ("found nothing in column 2 (counter1); expected a number", "2列目(counter1)が空です")),
        ("1,2,3,4,nan", ("found 'nan' in column 5 (pwm2); expected a finite number", "有限の数値")),
        ("1,2,3,4,-NaN", ("found '-NaN' in column 5 (pwm2); expected a finite number", "有限の数値")),
        ("inf,2,3,4,5", ("found 'inf' in column 1 (time); expected a finite number", "有限の数値")),
        ("1,2,-Infinity,4,5", ("found '-Infinity' in column 3 (counter2); expected a finite", "有限の数値")),
        ("1,2,1e999,4,5", ("found '1e999' in column 3 (counter2); expected a finite", "有限の数値")),
    ],
)
@pytest.mark.parametrize(
    ("before", "line"),
    [("", 1), (GOOD, 2), ("# head\n\n" + GOOD + " # more\n" + GOOD, 6), ("\ufeff#\r\n\r\n" + GOOD, 4), (GOOD * 500, 501)],
)
def test_a_bad_line_is_named_with_its_number(log_file, bad, messages, before, line):
    path = log_file(before + bad + "\n" + GOOD + "and another bad line\n")
    with pytest.raises(LogError) as error:
        read_encoder_log(path)
    first, second = str(error.value).split("\n")
    assert first.startswith(f"{path}, line {line}: {messages[0]}")
    assert second.startswith(f"{path}の{line}行目: ")
    assert messages[1] in second


@pytest.mark.parametrize("rest", ["0.005,17,", "0.005,17", "0.0"])
def test_a_cut_off_last_line_is_told(log_file, rest):
    with pytest.raises(LogError, match=r"line 3: .*cut off\.\n.*3行目: .*途中で切れた"):
        read_encoder_log(log_file(GOOD + GOOD + rest))


def test_a_short_line_with_a_line_end_is_not_called_cut_off(log_file):
    with pytest.raises(LogError, match="line 2") as error:
        read_encoder_log(log_file(GOOD + "0.005,17\n"))
    assert "cut off" not in str(error.value)


@pytest.mark.parametrize(
    ("reader", "values", "right_reader"),
    [(read_encoder_log, 11, "read_imu_log"), (read_imu_log, 5, "read_encoder_log"), (read_encoder_log, 6, "read_truth")],
)
def test_the_wrong_reader_is_told_the_right_one(log_file, reader, values, right_reader):
    with pytest.raises(LogError, match=f"line 1: .*{right_reader}.*\n.*{right_reader}"):
        reader(log_file(",".join(["1"] * values)))


def test_one_odd_line_does_not_make_it_another_kind_of_log(log_file):
    with pytest.raises(LogError, match=r"line 2: found 6 value\(s\)") as error:
        read_encoder_log(log_file(GOOD + "1,2,3,4,5,6\n"))
    assert "read_truth" not in str(error.value)


def test_a_long_bad_line_is_quoted_in_part(log_file):
    with pytest.raises(LogError) as error:
        read_encoder_log(log_file("7," * 5000))
    assert "found 5001 value(s)" in str(error.value)
    assert len(str(error.value)) < 1000


@pytest.mark.parametrize(
    ("content", "seen"),
    [
        ("", "an empty file"),
        ("\ufeff", "an empty file"),
        ("# only\n\n  # comments\n", "comments only"),
        ("\r\n", "comments only"),
    ],
)
def test_no_data_rows(log_file, content, seen):
    path = log_file(content)
    with pytest.raises(LogError, match=seen) as error:
        read_encoder_log(path)
    assert str(path) in str(error.value)
    assert "データの行がありません" in str(error.value)


@pytest.mark.parametrize(
    ("content", "line", "byte"),
    [
        (GOOD.encode() + b"# \x83\x8d\n", 2, "0x83"),
        (b"#\r\n#\r\n\xff\n", 3, "0xff"),
        (GOOD.encode("utf-16"), 1, "0xff"),
    ],
)
def test_bytes_that_are_no_text(log_file, content, line, byte):
    with pytest.raises(LogError, match=f"line {line}: found the byte {byte}, .* UTF-8(.|\n)*{line}行目"):
        read_encoder_log(log_file(content))


def test_paths_that_lead_to_no_file(tmp_path, log_file):
    with pytest.raises(IsADirectoryError, match=r"is a folder(.|\n)*フォルダ"):
        read_encoder_log(tmp_path)
    with pytest.raises(FileNotFoundError, match=r"no_such.dat(.|\n)*ファイルがありません"):
        read_encoder_log(tmp_path / "no_such.dat")
    with pytest.raises(FileNotFoundError, match="there is no such file"):
        read_encoder_log(log_file(GOOD) / "inside_a_file.dat")


def test_imu_log(log_file):
    values = np.arange(22.0).reshape(2, 11)
    log = read_imu_log(log_file("# head\n" + "\n".join(" ".join(map(str, row)) for row in values)))
    assert {name: column.shape for name, column in log.items()} == {
        "time": (2,),
        "gyro": (2, 3),
        "accel": (2, 3),
        "other": (2, 3),
        "temperature": (2,),
    }
    np.testing.assert_array_equal(np.column_stack(list(log.values())), values)


def test_imu_log_errors_name_their_column(log_file):
    with pytest.raises(LogError, match=r"line 2: found 'nan' in column 7 \(accel z\)"):
        read_imu_log(log_file("1,2,3,4,5,6,7,8,9,10,11\n1,2,3,4,5,6,nan,8,9,10,11\n"))


def test_truth(log_file):
    truth = read_truth(log_file("# head\n0,1,2,3,4,5\n"))
    assert {name: column.tolist() for name, column in truth.items()} == {
        "time": [0],
        "x": [1],
        "y": [2],
        "theta": [3],
        "velocity": [4],
        "yaw_rate": [5],
    }


@pytest.fixture
def no_repository(monkeypatch, tmp_path):
    monkeypatch.setattr(logs, "REPOSITORY_DATA", tmp_path / "nowhere")


@pytest.mark.usefixtures("no_repository")
def test_data_is_found_from_any_notebook_folder(tmp_path, monkeypatch):
    deep = tmp_path / "release" / "ja" / "odometry"
    (deep / "data").mkdir(parents=True)
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "a.dat").write_text(GOOD)
    monkeypatch.chdir(deep)
    assert data_path("a.dat") == tmp_path / "data" / "a.dat"
    (deep / "data" / "a.dat").write_text(GOOD)
    assert data_path("a.dat") == deep / "data" / "a.dat"


def test_data_is_found_in_the_repository_from_anywhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert read_encoder_log(data_path("encoder_straight_5m.dat"))["time"].shape == (2401,)


@pytest.mark.usefixtures("no_repository")
def test_a_log_that_does_not_exist_lists_those_that_do(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileNotFoundError, match=r"'c.dat'.*No data folder(.|\n)*見つかりません"):
        data_path("c.dat")
    (tmp_path / "data").mkdir()
    for name in ("b.dat", "a.dat", "a.truth.csv"):
        (tmp_path / "data" / name).write_text(GOOD)
    with pytest.raises(FileNotFoundError, match=r"'c.dat'.*There are: a.dat, b.dat\.\n.*あるログ: a.dat, b.dat。"):
        data_path("c.dat")
