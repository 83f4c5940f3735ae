"""The one library of this process: a shared library of the package, or an object from the cache."""

from __future__ import annotations

import ctypes
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from covey.kernels.library.cache import (
    KERNELS,
    host_processor,
    object_file,
    read_objects,
    source_digest,
)

_ENTRY = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_char_p, ctypes.c_void_p)
"""An entry's type: words, results, status. A call lets other threads run."""

_opening = threading.Lock()
_open: Callable[[str], Any] | None = None


def load_library() -> Callable[[str], Callable[..., int]]:
    """Load the library, which is built if need be; return its entries by name."""
    global _open
    with _opening:
        _open = _open or _opened()
        return _open


def entry_point(symbol: str) -> Callable[..., int]:
    """Return an entry of the library; the first call in a process loads the library."""
    return load_library()(symbol)


def library_name(system: str, generation: str) -> str:
    """Return the file name of a library for a system, and for processors of a generation."""
    suffix = {"win32": ".dll", "darwin": ".dylib"}.get(system, ".so")
    return f"kernels-{source_digest()}{generation and '-'}{generation}{suffix}"


def packaged_library() -> Path | None:
    """Return the library that a wheel has for this processor, if this is a wheel with one."""
    for generation in _generations():
        file = KERNELS / "library" / library_name(sys.platform, generation)
        if file.exists():
            return file
    return None


def _generations() -> list[str]:
    """Return the generations of processors that this processor belongs to, the newest first."""
    from numpy._core._multiarray_umath import (  # type: ignore[import-not-found]
        __cpu_features__,
    )

    return ["v3", ""] if __cpu_features__.get("X86_V3") else [""]


def _opened() -> Callable[[str], Callable[..., int]]:
    file = packaged_library()
    if file is None:
        return _linked(read_objects(object_file(host_processor())) or _built())
    library = ctypes.CDLL(str(file))
    return lambda symbol: _ENTRY((symbol, library))


def _built() -> list[bytes]:
    from covey.kernels.library.build import built_objects  # with all that a build needs

    return built_objects()


def _linked(objects: list[bytes]) -> Callable[[str], Callable[..., int]]:
    """Link objects into this process, without a linker."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_default_triple().create_target_machine(jit=True)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    for compiled in objects:
        engine.add_object_file(llvm.ObjectFileRef.from_data(compiled))
    engine.finalize_object()

    def entry(symbol: str) -> Any:
        function: Any = _ENTRY(engine.get_function_address(symbol))
        function.engine = engine  # the machine code lives as long as the engine
        return function

    return entry
