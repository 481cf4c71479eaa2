"""The command line: `autograder --help` lists what there is."""

import json
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table

from autograder.engine import MAX_ATTEMPTS, Options
from autograder.executed import visible
from autograder.grading import GradedNotebook, Result

if TYPE_CHECKING:
    from autograder.appeal import Appeal

app = typer.Typer(
    help="Build the notebooks, grade a class, and see what became of it. Run it in the root of the course.",
    no_args_is_help=True,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
)
console = Console(stderr=True)
# a pipe or a file has no width of its own
output = Console(width=None if sys.stdout.isatty() else 140)

Root = Annotated[
    Path, typer.Option("--root", help="The root of the course, where source/ and release/ are.", show_default="here")
]
NoSandbox = Annotated[bool, typer.Option("--no-sandbox", help="Run notebooks without a sandbox. Only for work that you trust.")]


@app.command()
def build(
    root: Root = Path(),
    verify: Annotated[bool, typer.Option("--verify", help="Change nothing; fail if release/ or the examples are stale.")] = False,
) -> None:
    """Make the student notebooks in release/en and release/ja from source/, and the public examples.

    [dim]autograder build[/] after every change of a source or an exercise; [dim]autograder build --verify[/] in CI.
    """
    from autograder.building import build as build_all
    from autograder.building import verify as stale_files
    from autograder.editions import SourceError

    try:
        found = stale_files(root.resolve()) if verify else build_all(root.resolve())
    except SourceError as error:
        _fail(str(error))
    for line in found:
        output.print(escape(line), highlight=False)
    if verify and found:
        _fail(f"{len(found)} generated files are not what the sources make. Type: autograder build")
    output.print("Everything that is generated is up to date." if not found else f"{len(found)} files brought up to date.")


@app.command()
def grade(  # noqa: PLR0913 - each is an option of the command
    assignment: Annotated[str, typer.Argument(help="The assignment, such as odometry.")],
    student: Annotated[str, typer.Option(help="Only students whose name fits this pattern, such as 's2*'.")] = "*",
    workers: Annotated[int, typer.Option(min=0, help="How many submissions at a time; 0: one for each processor.")] = 0,
    json_file: Annotated[Path | None, typer.Option("--json", help="Write one JSON object a line for each exercise.")] = None,
    regrade: Annotated[bool, typer.Option("--regrade", help="Grade again what has not changed since it was graded.")] = False,
    attempts: Annotated[
        int, typer.Option(min=1, help="How many different versions of a notebook a student may have graded.")
    ] = MAX_ATTEMPTS,
    scheduler: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Grade on a Dask cluster instead of here, such as tcp://10.0.0.5:8786.")
    ] = "",
    no_sandbox: NoSandbox = False,
    root: Root = Path(),
) -> None:
    """Grade what students handed in under submitted/STUDENT/ASSIGNMENT/, into the gradebook and autograded/.

    Each notebook runs in a sandbox of its own; the judge sits outside. A submission that cannot be read or run gets zeros with a
    reason, and never holds up the others. What has not changed since it was graded is not graded again, and a run that was
    interrupted goes on where it stopped.
    """
    options = Options(student, workers, not no_sandbox, scheduler=scheduler, regrade=regrade, attempts=attempts)
    results = grade_class(root.resolve(), assignment, options)
    if json_file is not None:
        write_json(json_file, results)
    output.print(class_table(assignment, results))


@app.command()
def check(
    notebook: Annotated[Path, typer.Argument(help="A notebook, such as release/en/odometry/pose_update.ipynb.")],
    no_sandbox: NoSandbox = False,
    root: Root = Path(),
) -> None:
    """Grade one notebook and show what each exercise would get. No gradebook is touched."""
    from autograder.grading import Work, graded_submission
    from autograder.intake import UnreadableError, submitted_bytes
    from autograder.reference import NOTEBOOKS
    from autograder.submissions import MissingReleaseError, release_notebooks
    from autograder.warm_server import NoSandboxError

    assignment = next((key.partition("/")[0] for key in NOTEBOOKS if key.partition("/")[2] == notebook.stem), None)
    if assignment is None:
        _fail(
            f"{notebook.name} is none of the course's notebooks: {', '.join(key.partition('/')[2] + '.ipynb' for key in NOTEBOOKS)}"
        )
    _need_sandbox(not no_sandbox)
    try:
        content = submitted_bytes(notebook.resolve())
        release = release_notebooks(root.resolve(), assignment)
    except (UnreadableError, MissingReleaseError) as error:
        _fail(f"{notebook}: {error}")
    try:
        [graded] = graded_submission(Work("-", assignment, {notebook.stem: content}, release, not no_sandbox))
    except NoSandboxError as error:
        _fail(str(error))
    output.print(exercise_table(graded))


@app.command()
def demo(
    root: Root = Path(),
    workers: Annotated[int, typer.Option(min=0, help="How many submissions at a time; 0: one for each processor.")] = 0,
    no_sandbox: NoSandbox = False,
) -> None:
    """Make a sample class of 12 with known mistakes in build/demo/, grade it, and compare with what each should get."""
    from autograder.gradebook import given_scores
    from autograder.sample import ASSIGNMENT, LIMITS, compared_rows, make_class
    from autograder.submissions import MissingReleaseError, release_notebooks

    try:
        release_notebooks(root.resolve(), ASSIGNMENT)
    except MissingReleaseError as error:
        _fail(str(error))
    folder = make_class(root.resolve())
    results = grade_class(folder, ASSIGNMENT, Options(workers=workers, sandbox=not no_sandbox, limits=LIMITS))
    write_json(folder / "results.json", results)
    rows = compared_rows(given_scores(folder, ASSIGNMENT, results))
    table = Table(title="Sample class: expected against given", caption=f"gradebook: {folder / 'gradebook.db'}")
    for column in ("student", "language", "exercise", "handed in", "expected", "given", "recognised as", ""):
        table.add_column(column, overflow="fold")
    for row in rows:
        table.add_row(*map(escape, row.shown), "[green]✓[/]" if row.agrees else "[red]✗[/]")
    output.print(table)
    wrong = sum(not row.agrees for row in rows)
    if wrong:
        _fail(f"{wrong} of {len(results)} results are not what was expected.")
    output.print(f"[green]All {len(results)} results are as expected[/]; the table shows those that are not simply right.")


@app.command()
def gallery(
    folder: Annotated[Path, typer.Option(help="Where the pages are written, as en.html and ja.html.")] = Path("build/gallery"),
) -> None:
    """Write a page in each language with every drawing, view and film of the course, and its alternative text.

    [dim]autograder gallery[/], then open build/gallery/en.html
    """
    from autograder.gallery import write_gallery

    for path in write_gallery(folder):
        output.print(escape(str(path)), highlight=False)


@app.command()
def explain(
    student: Annotated[str, typer.Argument(help="The student, as in submitted/.")],
    assignment: Annotated[str, typer.Argument(help="The assignment, such as odometry.")],
    exercise: Annotated[str, typer.Argument(help="The exercise, such as pose_step.")],
    full: Annotated[bool, typer.Option("--full", help="Show long arrays whole.")] = False,
    root: Root = Path(),
) -> None:
    """Show how a recorded verdict came about: the inputs, what was expected, and what the answer gave.

    For appeals. The cases are those of that grading, drawn again from the seed on record. They are secret: do not hand them on.
    """
    from autograder.appeal import AppealError, appeal

    try:
        found = appeal(root.resolve(), student, assignment, exercise, full)
    except AppealError as error:
        _fail(str(error))
    output.print(appeal_table(found))
    if not found.unchanged:
        output.print(
            "[yellow]The exercise or the judge has changed since: today's cases are shown.[/] Type: autograder grade --regrade"
        )
    if found.agrees is not None:
        output.print("Judged again just now: " + ("the same verdict." if found.agrees else "[yellow]another verdict[/]."))


@app.command()
def doctor(root: Root = Path()) -> None:
    """Say whether this machine can grade safely, what is missing, and what to type."""
    from autograder.doctor import findings

    marks = {"good": "[green]✓[/]", "weak": "[yellow]![/]", "bad": "[red]✗[/]"}
    bad = 0
    for finding in findings(root.resolve()):
        bad += finding.state == "bad"
        advice = f"\n    → {escape(finding.advice)}" if finding.advice and finding.state != "good" else ""
        output.print(f"{marks[finding.state]} [bold]{finding.what}[/]: {escape(finding.seen)}{advice}", highlight=False)
    if bad:
        _fail("this machine cannot grade safely yet.")


def grade_class(root: Path, assignment: str, options: Options) -> list[Result]:
    """Grade a class with a progress bar and return all results, by student."""
    from autograder.batch import BatchError
    from autograder.batch import grade_class as graded_class

    bar = Progress(
        SpinnerColumn(), TextColumn("grading"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"),
        console=console,
    )  # fmt: skip
    task = bar.add_task("")

    def on_progress(done: int, count: int, student: str) -> None:
        # what cannot begin shows no bar
        bar.start()
        bar.update(task, completed=done, total=count, description=escape(student[:30]))

    _stop_as_with_ctrl_c()
    try:
        return graded_class(root, assignment, options, on_progress)
    except BatchError as error:
        _fail(str(error))
    except KeyboardInterrupt:
        _fail("Stopped. What was graded so far is in the gradebook; type the same command again for the rest.")
    finally:
        bar.stop()


def _stop_as_with_ctrl_c() -> None:
    """Come to an orderly end when the system or a closed terminal says so, too."""

    def stop(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    for name in (signal.SIGTERM, signal.SIGHUP):
        # under nohup the terminal may close
        if signal.getsignal(name) == signal.SIG_DFL:
            signal.signal(name, stop)


def write_json(path: Path, results: list[Result]) -> None:
    """Write results as JSON, one object a line."""
    from autograder.files import replace_file
    from autograder.grading import result_row

    path.parent.mkdir(parents=True, exist_ok=True)
    # without the seeds: the file may be handed on, and from a seed and the sources come the cases
    rows = ({key: value for key, value in result_row(result).items() if key != "seed"} for result in results)
    lines = (json.dumps(row, ensure_ascii=False) for row in rows)
    replace_file(path.resolve(), "".join(f"{line}\n" for line in lines).encode())


def class_table(assignment: str, results: list[Result]) -> Table:
    """Return a table with a row for each student: points by notebook, mistakes recognised, and what a person has to look at."""
    notebooks = list(dict.fromkeys(result.notebook for result in results))
    table = Table(title=f"{assignment}: points")
    table.add_column("student", overflow="fold")
    for notebook in notebooks:
        table.add_column(notebook, justify="right")
    table.add_column("mistakes recognised", overflow="fold")
    table.add_column("look at", overflow="fold")
    for student in dict.fromkeys(result.student for result in results):
        own = [result for result in results if result.student == student]
        points = [_points([result for result in own if result.notebook == notebook]) for notebook in notebooks]
        mistakes = ", ".join(f"{result.exercise}: {result.misconception}" for result in own if result.misconception)
        odd = ", ".join(dict.fromkeys(f"{result.notebook}: {result.status}" for result in own if result.status != "graded"))
        table.add_row(escape(student), *points, mistakes, odd)
    return table


def exercise_table(graded: GradedNotebook) -> Table:
    """Return a table with a row for each exercise of one notebook, with its message."""
    table = Table(title=f"{graded.notebook}: {_points(list(graded.results))}", show_lines=True)
    for column in ("exercise", "points", "message"):
        table.add_column(column, overflow="fold")
    for result in graded.results:
        score = "by hand" if result.score is None else f"{result.score:g} / {result.max_score:g}"
        table.add_row(result.exercise, score, escape(result.message))
    return table


def appeal_table(found: "Appeal") -> Table:
    """Return a table with a row for each case of a recorded verdict."""
    result = found.result
    table = Table(
        title=f"{result.student}: {result.exercise}, {result.score:g} of {result.max_score:g} points, attempt {found.attempt}",
        caption=f"{result.message}\nmisconception: {result.misconception or '-'}; graded {found.receipt.begun}; seed {result.seed}",
        show_lines=True,
    )
    for column in ("kind of input", "inputs", "expected", "given", ""):
        table.add_column(column, overflow="fold")
    for case in found.cases:
        mark = "[green]✓[/]" if case.right else "[red]✗[/]"
        table.add_row(case.group.en, escape(case.inputs), escape(case.expected), escape(visible(case.given)), mark)
    return table


def _points(results: list[Result]) -> str:
    graded = [result for result in results if result.score is not None]
    return f"{sum(result.score or 0 for result in graded):g} / {sum(result.max_score for result in graded):g}"


def _need_sandbox(sandbox: bool) -> None:
    from autograder.warm_server import sandbox_problem

    problem = sandbox_problem() if sandbox else None
    if problem is not None:
        _fail(problem)


def _fail(message: str) -> NoReturn:
    """Say what went wrong and end with exit code 1."""
    # soft: a path that is broken into lines cannot be copied
    console.print(f"[red]error:[/] {escape(message)}", highlight=False, soft_wrap=True)
    sys.exit(1)


if __name__ == "__main__":
    app()
