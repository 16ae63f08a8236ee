#!/usr/bin/env python3
"""Writes type stubs of the compiled module from what it says about itself.

    write_stub.py FOLDER   # that holds scanfuse/; writes scanfuse/_scanfuse.pyi
"""

import os
import re
import sys
import textwrap

_HEADER = '''"""Type stubs, written from the module when it is built."""
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple, Union, overload

import os
import numpy

'''


def without_defaults(signature):
    """A signature with `...` for every default: some of them are no Python."""
    kept, depth, skipping, quote = "", 0, False, ""
    for k, letter in enumerate(signature):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"":
            quote = letter
        elif letter in "([{<":
            depth += 1
        elif letter in ")]}" or (letter == ">" and signature[k - 1] != "-"):
            depth -= 1
        if skipping and not quote and (depth == 0 or (depth == 1 and letter == ",")):
            skipping = False
        if not skipping:
            kept += letter
        if depth == 1 and not quote and kept.endswith(" = "):
            kept, skipping = kept + "...", True
    return kept


def plain_types(text):
    """Types as Python spells them, without what only pybind11 knows."""
    text = without_defaults(text)
    text = re.sub(r"numpy\.ndarray\[[^\[\]]*(\[[^\[\]]*\])?[^\[\]]*\]", "numpy.ndarray", text)
    text = text.replace("scanfuse._scanfuse.", "").replace("_scanfuse.", "")
    text = re.sub(r"(\w+)\[(\d+)\]", r"\1", text)  # float[2]
    text = re.sub(r"\b(List\[[^\[\]]*\])\[\d+\]", r"\1", text)  # List[float][3]
    text = text.replace("os.PathLike", "Union[str, os.PathLike]")
    return re.sub(r"\b(object|handle)\b", "Any", text)


def signatures(doc):
    """Every signature that a docstring of pybind11 starts with, and the words after each."""
    lines = (doc or "").strip("\n").split("\n")
    if len(lines) > 1 and lines[1].startswith("Overloaded function"):
        parts = re.split(r"^\d+\. ", "\n".join(lines[2:]), flags=re.M)[1:]
        return [(part.split("\n")[0], "\n".join(part.split("\n")[1:]).strip()) for part in parts]
    return [(lines[0], "\n".join(lines[1:]).strip())]


def quoted(words, indent):
    if not words:
        return " ...\n"
    return "\n" + textwrap.indent('"""' + words.replace('"""', "'''") + '"""', indent) + "\n"


def function(name, value, indent, static=False):
    found = signatures(value.__doc__)
    text = ""
    for signature, words in found:
        if not signature.startswith(name + "("):
            signature = f"{name}(*args, **kwargs) -> Any"
        if len(found) > 1:
            text += indent + "@overload\n"
        if static:
            text += indent + "@staticmethod\n"
        text += f"{indent}def {plain_types(signature)}:" + quoted(words, indent + "    ")
    return text


def attribute(name, value):
    getter = plain_types(value.fget.__doc__ or "")
    kind = re.search(r"-> (.*)", getter)
    text = f"    @property\n    def {name}(self) -> {kind.group(1) if kind else 'Any'}:"
    text += quoted((value.__doc__ or "").strip(), "        ")
    if value.fset:
        text += f"    @{name}.setter\n    def {name}(self, value: Any) -> None: ...\n"
    return text


def stub_of_class(name, kind):
    base = next((b.__name__ for b in kind.__bases__ if b.__name__ == "ValueError"), "")
    text = f"\nclass {name}{f'({base})' if base else ''}:" + quoted((kind.__doc__ or "").strip(), "    ")
    if base:
        return text
    for member, value in sorted(vars(kind).items()):
        if isinstance(value, property):
            text += attribute(member, value)
        elif isinstance(value, staticmethod):
            text += function(member, value.__func__, "    ", static=True)
        elif callable(value) and (not member.startswith("_") or member in
                                  ("__init__", "__iter__", "__next__", "__len__", "__enter__",
                                   "__exit__", "__float__")):
            text += function(member, value, "    ")
    return text


def stub_of(module):
    text = _HEADER + "__version__: str\n"
    for name, value in vars(module).items():
        if name.startswith("_"):
            continue
        text += stub_of_class(name, value) if isinstance(value, type) else "\n" + function(name, value, "")
    return text


def main():
    folder = sys.argv[1]
    sys.path.insert(0, os.path.join(folder, "scanfuse"))
    import _scanfuse

    path = os.path.join(folder, "scanfuse", "_scanfuse.pyi")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(stub_of(_scanfuse))
    os.replace(path + ".part", path)


if __name__ == "__main__":
    main()
