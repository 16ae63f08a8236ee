import ast
import pathlib

import scanfuse
from scanfuse import _scanfuse


def test_every_public_name_has_a_type_and_words():
    stub = pathlib.Path(scanfuse.__file__).with_name("_scanfuse.pyi")
    tree = ast.parse(stub.read_text(encoding="utf-8"))
    names = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    public = {name for name in vars(_scanfuse) if not name.startswith("_")}
    assert public <= names
    for name in public:
        assert getattr(_scanfuse, name).__doc__, name
