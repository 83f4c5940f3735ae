"""From kernels to LLVM code: numba lowers entries with all that they call, and optimises nothing.

By itself numba optimises a kernel again in each kernel that calls it, and makes machine code of
each. The code library below keeps the text of each function instead, so that LLVM can optimise the
whole once.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numba
import numpy as np
from numba import types
from numba.core import codegen
from numba.core.registry import cpu_target
from numba.extending import intrinsic
from numba.np.arrayobj import get_cfarray_intrinsic

import covey.kernels
from covey.kernels._jit import OPTIONS, compiled, compiled_kernels, entries
from covey.kernels.library.entry import symbol_of
from covey.kernels.library.layout import (
    Annotations,
    Leaf,
    fields_of,
    is_record,
    leaves,
    parameters_of,
    results_of,
)

Progress = Callable[[float], None]


class _TextLibrary(codegen.CPUCodeLibrary):  # type: ignore[misc] # numba's types are skipped
    """The text of one compiled function, and the libraries of the functions that it calls."""

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self.texts: list[str] = []

    def add_ir_module(self, module: Any) -> None:
        self.texts.append(str(module))

    def finalize(self) -> None:
        self._finalized = True
        self.codegen.count_function()

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002 nobody calls it here
        return 0

    def with_callees(self, seen: set[int]) -> Iterator[_TextLibrary]:
        """Yield this library and all that it calls, each once."""
        if id(self) not in seen:
            seen.add(id(self))
            yield self
            for library in self._linking_libraries:
                if isinstance(library, _TextLibrary):  # and not numba's runtime, which is not used
                    yield from library.with_callees(seen)


class _TextCodegen(codegen.JITCPUCodegen):  # type: ignore[misc] # numba's types are skipped
    """Makes text libraries, and tells how many of about `expected` are done."""

    _library_class = _TextLibrary

    def __init__(self, expected: int, progress: Progress) -> None:
        super().__init__("covey")
        self._expected, self._progress, self._done = expected, progress, 0

    def set_env(self, name: str, environment: object) -> None:
        """Nothing runs, so nothing needs an environment."""

    def count_function(self) -> None:
        self._done += 1
        self._progress(min(self._done / self._expected, 1.0))


def import_kernels() -> dict[str, Any]:
    """Import all kernels, and return those that Python calls, by name."""
    for module in pkgutil.walk_packages(covey.kernels.__path__, "covey.kernels."):
        if not module.name.startswith(("covey.kernels.builder", "covey.kernels.library")):
            importlib.import_module(module.name)
    return {kernel.__name__: kernel for kernel in entries}


def lowered_texts(kernels: Iterable[Any], external: Any, progress: Progress) -> list[str]:
    """Return the LLVM code of entries and of what they call, in modules to be linked.

    Calls of the `external` kernel stay calls of a symbol, which another object has.
    """
    context = cpu_target.target_context
    context.refresh()
    context._internal_codegen = _TextCodegen(len(compiled_kernels), progress)
    # Python calls nothing here, so nothing needs a wrapper for it.
    context.create_cpython_wrapper = context.create_cfunc_wrapper = lambda *_, **__: None
    seen: set[int] = set()
    texts = []
    for kernel in kernels:
        function, library = _lower(kernel)
        texts += [text for each in library.with_callees(seen) for text in each.texts]
        texts.append(_exported(symbol_of(kernel), function))
    return [_with_shared_name(text, external) for text in texts]


def _with_shared_name(text: str, kernel: Any) -> str:
    """Give a kernel the name under which the objects share it; numba's differs by process."""
    for overload in kernel.overloads.values():
        text = text.replace(f'@"{overload.fndesc.llvm_func_name}"', f"@{_shared_name(kernel)}")
    return text


def _shared_name(kernel: Any) -> str:
    return f"{symbol_of(kernel)}_shared"


def defines(text: str, kernel: Any) -> bool:
    """Return whether LLVM code defines the kernel that the objects share."""
    return f"define i32 @{_shared_name(kernel)}(" in text


def stand_in_for(kernel: Any) -> Any:
    """Return a kernel of the same name and type that does nothing: another object has the code."""
    zeros = {"float": "0.0", "int": "0", "bool": "False"}
    results = ", ".join(zeros[kind] for kind in results_of(kernel))
    names: dict[str, Any] = {}
    exec(f"def {kernel.__name__}({', '.join(parameters_of(kernel))}): return {results}", names)
    return compiled(names[kernel.__name__])


def _lower(kernel: Callable[..., object]) -> tuple[str, _TextLibrary]:
    """Return the name of a kernel's flat function in LLVM code, and its library."""
    flat = numba.njit(**OPTIONS)(_flat(kernel))
    words, floats = types.CPointer(types.int64), types.CPointer(types.float64)
    flat.compile((words, floats, words, floats))
    (overload,) = flat.overloads.values()
    return overload.fndesc.llvm_func_name, overload.library


def _flat(kernel: Callable[..., object]) -> Callable[..., None]:
    """Return a function of pointers that calls a kernel: (words, as floats, results, as floats)."""
    parameters, kinds = parameters_of(kernel), results_of(kernel)
    used = list(leaves(parameters))
    size = sum(leaf.words for leaf in used)
    names: dict[str, Any] = {"array_at": get_cfarray_intrinsic("C", None), "kernel": kernel}
    names |= {f"pointer_to_{each}": _pointer_to(each) for each in {u.kind for u in used if u.ndim}}
    arguments = _Reader(used, names).arguments(parameters)
    targets = [
        f"{'float_results' if kind == 'float' else 'results'}[{k}]" for k, kind in enumerate(kinds)
    ]
    source = [
        "def flat(words, floats, results, float_results):",
        f"    words, floats = array_at(words, ({size},)), array_at(floats, ({size},))",
        f"    results = array_at(results, ({len(kinds)},))",
        f"    float_results = array_at(float_results, ({len(kinds)},))",
        f"    {', '.join(targets)}{' = ' if targets else ''}kernel({', '.join(arguments)})",
    ]
    exec("\n".join(source), names)
    flat: Callable[..., None] = names["flat"]
    flat.__name__ = f"flat_{kernel.__name__}"
    return flat


class _Reader:
    """Writes the expressions that read a kernel's arguments from its words."""

    def __init__(self, used: list[Leaf], names: dict[str, Any]) -> None:
        self._at, self._leaves, self._names = 0, {leaf.source: leaf for leaf in used}, names

    def arguments(self, annotations: Annotations) -> list[str]:
        """Return an expression for each annotated source, whose words come next."""
        return [self._argument(*each) for each in annotations.items()]

    def _argument(self, source: str, annotation: Any) -> str:
        if is_record(annotation):
            name = annotation.__name__
            self._names[name] = annotation
            return f"{name}({', '.join(self.arguments(fields_of(source, annotation)))})"
        leaf = self._leaves[source]
        at, self._at = self._at, self._at + leaf.words
        if leaf.ndim:
            shape = ", ".join(f"words[{at + 1 + axis}]" for axis in range(leaf.ndim))
            return f"array_at(pointer_to_{leaf.kind}(words[{at}]), ({shape},))"
        return {"float": f"floats[{at}]", "int": f"words[{at}]", "bool": f"words[{at}] != 0"}[
            leaf.kind
        ]


def _pointer_to(dtype: str) -> Any:
    """Return a function that makes a pointer to numbers of a dtype from an address."""
    pointer = types.CPointer(numba.from_dtype(np.dtype(dtype)))

    @intrinsic  # type: ignore[untyped-decorator] # numba's types are skipped
    def pointer_to(typing_context: Any, address: Any) -> Any:  # noqa: ARG001
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ARG001
            return builder.inttoptr(arguments[0], context.get_value_type(pointer))

        return pointer(types.int64), generate

    return pointer_to


def _exported(symbol: str, function: str) -> str:
    """Return the LLVM code of an entry: numba's calling convention behind one of C.

    numba's functions take a pointer for what they return, and a pointer for an exception, first.
    """
    return f"""
declare i32 @"{function}"(ptr, ptr, ptr, ptr, ptr, ptr)
define i64 @{symbol}(ptr %words, ptr %results) {{
  %nothing = alloca ptr
  %exception = alloca ptr
  %status = call i32 @"{function}"(ptr %nothing, ptr %exception,
                                   ptr %words, ptr %words, ptr %results, ptr %results)
  %wide = sext i32 %status to i64
  ret i64 %wide
}}
"""
