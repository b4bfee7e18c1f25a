"""A compiled kernel is kept under the name of all that it is made of, and of nothing else."""

import ast
from pathlib import Path

import gasbox
from gasbox import jit

KERNELS = Path(gasbox.__file__).parent / "kernels"


def imported(module):
    """Modules of kernels that a module imports, as Python sees it."""
    path = Path(gasbox.__file__).parent.joinpath(*module.split(".")[1:])
    source = path.with_suffix(".py") if path.with_suffix(".py").exists() else path / "__init__.py"
    found = set()
    for node in ast.walk(ast.parse(source.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("gasbox.kernels"):
            found |= {node.module, *(f"{node.module}.{name.name}" for name in node.names)}
        elif isinstance(node, ast.Import):
            found |= {name.name for name in node.names if name.name.startswith("gasbox.kernels")}
    return found & set(jit._sources())


def test_every_import_counts():
    for module in jit._sources():
        made_of = set(jit._made_of(module))
        assert module in made_of
        for part in made_of:
            assert imported(part) <= made_of, (module, part)


def test_what_is_not_imported_does_not_count():
    made_of = jit._made_of("gasbox.kernels.stepped.advance")
    assert "gasbox.kernels.hall.motion" in made_of
    assert not any("event_driven" in module or "forced" in module for module in made_of)
    assert jit.cache_folder("gasbox.kernels.stepped.advance") != jit.cache_folder(
        "gasbox.kernels.forced.advance"
    )


def test_all_kernels_together_have_a_folder_for_their_mark():
    assert len(jit._made_of("")) == len(list(KERNELS.rglob("*.py")))
    assert jit._mark().parent == jit.cache_folder()
