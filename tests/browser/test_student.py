"""A student works in JupyterLab: opens a notebook, runs it, writes an answer, and is told how it stands."""

import pytest
from playwright.sync_api import Page, expect

from .conftest import TOKEN

pytestmark = pytest.mark.browser

WRONG = """def pose_step(pose, distance, dtheta):
x, y, theta = pose
return [x + distance * np.sin(theta), y + distance * np.cos(theta), theta + dtheta]"""
RIGHT = WRONG.replace("np.sin", "np.COS").replace("np.cos", "np.sin").replace("np.COS", "np.cos")

# the truth stands in for what the exercises before the graph compute
OVER_ROWS = """# Bind to yaw_axes
truth = read_truth(data_path("encoder_practical.truth.csv"))
_, yaw_axes = plt.subplots()
yaw_axes.plot(truth["theta"])
yaw_axes.set(xlabel="t [s]", ylabel="yaw [rad]")"""
OVER_TIME = OVER_ROWS.replace('truth["theta"]', 'truth["time"] - truth["time"][0], truth["theta"]')


def open_notebook(page: Page, address: str, path: str) -> None:
    # a workspace of its own: otherwise JupyterLab opens what the last page had open
    page.goto(f"{address}/lab/workspaces/{path.partition('/')[0]}/tree/{path}?token={TOKEN}&reset")
    page.wait_for_selector(".jp-Notebook .jp-Cell")
    page.wait_for_function("window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'")


def run_all(page: Page) -> None:
    """Run all cells, as the menu does; it ends at the first check that fails."""
    page.evaluate("jupyterapp.commands.execute('notebook:run-all-cells')")


def select_cell(page: Page, start: str) -> None:
    """Make the cell whose source begins with `start` the active one and scroll to it."""
    index = page.evaluate(
        """async start => {
            const notebook = jupyterapp.shell.currentWidget.content;
            const index = notebook.widgets.findIndex(cell => cell.model.sharedModel.source.startsWith(start));
            notebook.activeCellIndex = index;
            await notebook.scrollToItem(index, 'center');
            return index;
        }""",
        start,
    )
    assert index >= 0, start


def write_answer(page: Page, start: str, code: str) -> None:
    """Type over the active answer, as a student does."""
    select_cell(page, start)
    editor = page.locator(".jp-Cell.jp-mod-active .cm-content")
    editor.click()
    page.keyboard.press("Control+A")
    page.keyboard.press("Delete")
    for number, line in enumerate(code.splitlines()):
        if number:
            page.keyboard.press("Enter")
        page.keyboard.insert_text(line)


def run_cell(page: Page) -> None:
    page.evaluate("jupyterapp.commands.execute('notebook:run-cell')")


@pytest.mark.parametrize(
    ("path", "exercise", "start", "answers", "told"),
    [
        pytest.param(
            *("en/odometry/pose_update", "pose_step", "def pose_step(pose", (WRONG, RIGHT), "sin and cos are exchanged"),
            marks=pytest.mark.slow,
        ),
        ("ja/odometry/pose_update", "pose_step", "def pose_step(pose", (WRONG, RIGHT), "sin と cos が入れ替わっています"),
        (
            "en/odometry/wheel_odometry",
            "yaw_axes",
            "# Bind to yaw_axes",
            (OVER_ROWS, OVER_TIME),
            "The horizontal axis counts rows",
        ),
    ],
)
def test_answer_turns_the_check_green(page, lab, path, exercise, start, answers, told):
    open_notebook(page, lab, f"{path}.ipynb")
    run_all(page)
    failed, passed = {"en": ("not right yet", "correct"), "ja": ("まだ正しくありません", "正解です")}[path[:2]]
    expect(page.locator(".check-failed").first).to_contain_text(failed)

    said = page.locator(".jp-Cell.jp-mod-active .jp-OutputArea")
    for answer, expected in zip(answers, (told, passed), strict=True):
        write_answer(page, start, answer)
        run_cell(page)
        select_cell(page, f'check("{exercise}")')
        run_cell(page)
        expect(said).to_contain_text(expected)
    expect(said.locator(".check-passed")).to_be_visible()
    assert page.locator(".jp-Cell.jp-mod-active .jp-RenderedText[data-mime-type*='stderr']").count() == 0


@pytest.mark.parametrize(
    ("path", "view"),
    [
        pytest.param("en/odometry/pose_update.ipynb", "step_view()", marks=pytest.mark.slow),
        ("ja/odometry/encoders.ipynb", "wheels_view()"),
        ("ja/odometry/frames.ipynb", "point_view()"),
    ],
)
def test_sliders_redraw_the_picture(page, lab, path, view):
    open_notebook(page, lab, path)
    for start in ("from course.", view):
        select_cell(page, start)
        run_cell(page)
    picture = page.locator(".jupyter-widgets img[alt]").first
    expect(picture).to_be_visible()
    before = picture.get_attribute("src")
    slider = page.locator(".widget-slider .noUi-handle").first
    slider.focus()
    slider.press("ArrowLeft")
    page.wait_for_function("before => document.querySelector('.jupyter-widgets img[alt]').src !== before", arg=before)
    assert page.locator(".jupyter-widgets-error-widget").count() == 0


def test_animation_plays(page, lab):
    open_notebook(page, lab, "en/odometry/encoders.ipynb")
    for start in ("from course.", "encoder_animation()"):
        select_cell(page, start)
        run_cell(page)
    frame = page.locator(".animation img").first
    expect(frame).to_be_visible()
    before = frame.get_attribute("src")
    page.locator(".anim-buttons button", has_text="▷").first.click()
    page.wait_for_function("before => document.querySelector('.animation img').src !== before", arg=before)
