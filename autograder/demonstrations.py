"""The teacher's demonstrations (tag `demo`): what they define, and whether anything depends on them.

Grading leaves out a demonstration that nothing depends on, because most of its time goes into pictures that nobody grades.
"""

import ast
import symtable
from collections.abc import Iterator, Sequence


def bound_names(source: str) -> frozenset[str]:
    """Return the names that a cell of ours defines in the notebook."""
    table = symtable.symtable(source, "cell", "exec")
    return frozenset(symbol.get_name() for symbol in table.get_symbols() if symbol.is_assigned() or symbol.is_imported())


def names_read_first(source: str) -> frozenset[str]:
    """Return the names that a cell of ours reads before it defines them itself."""
    read, bound = set[str](), set[str]()
    for statement in _in_order(ast.parse(source).body):
        table = symtable.symtable(ast.unparse(statement), "cell", "exec")
        read |= (_read(table) | _changed(statement)) - bound
        bound |= bound_names(ast.unparse(statement))
    return frozenset(read)


def dependents(sources: Sequence[str], demos: Sequence[bool]) -> Iterator[tuple[int, int, str]]:
    """Yield (demonstration, cell, name) for each cell that reads a name which it would have from a demonstration."""
    from_demo: dict[str, int] = {}
    for index, (source, demo) in enumerate(zip(sources, demos, strict=True)):
        for name in sorted(names_read_first(source) & from_demo.keys()):
            yield from_demo[name], index, name
        if demo:
            from_demo |= dict.fromkeys(bound_names(source), index)
        else:
            for name in bound_names(source):
                from_demo.pop(name, None)


def _in_order(statements: Sequence[ast.stmt]) -> Iterator[ast.stmt]:
    """Yield statements in the order in which they bind names; a loop or a block comes apart into what it consists of."""
    for statement in statements:
        match statement:
            case ast.For(target=target, iter=iterable, body=body, orelse=rest):
                yield ast.fix_missing_locations(ast.Assign([target], iterable, lineno=0))
                yield from _in_order([*body, *rest])
            case ast.With(items=items, body=body):
                for item in items:
                    target = item.optional_vars or ast.Name("_", ast.Store())
                    yield ast.fix_missing_locations(ast.Assign([target], item.context_expr, lineno=0))
                yield from _in_order(body)
            case _:
                yield statement


def _read(table: symtable.SymbolTable) -> set[str]:
    """Return the names of the notebook that a block reads, functions within it included."""
    top = table.get_type() == "module"
    own = {s.get_name() for s in table.get_symbols() if s.is_referenced() and (top or s.is_global())}
    return own.union(*map(_read, table.get_children()))


def _changed(node: ast.AST) -> set[str]:
    """Return the names that a statement must find there although it seems only to set them: by += and the like, or by del."""
    match node:
        case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef() | ast.Lambda():
            return set()
        case ast.AugAssign(target=ast.Name(id=name)) | ast.Name(id=name, ctx=ast.Del()):
            return {name}
    return set().union(*map(_changed, ast.iter_child_nodes(node)))
