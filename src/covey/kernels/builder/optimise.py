"""From LLVM code to an object: linked, optimised as a whole, emitted for one processor."""

from __future__ import annotations

from typing import NamedTuple

import llvmlite.binding as llvm

_LEVEL = 3

_LIBRARY_NAMES = {"numba_frexp": "frexp", "numba_ldexp": "ldexp"}
"""Helpers of numba's that do what a function of the C library does."""


class Target(NamedTuple):
    """What an object is for."""

    triple: str  # of LLVM: processor, vendor, system
    processor: str = ""  # name; empty: any of its kind
    features: str = ""


def host_target() -> Target:
    """Return this machine's system and processor."""
    return Target(
        llvm.get_process_triple(), llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()
    )


def linked(texts: list[str]) -> str:
    """Return one module of LLVM code, of which the entries alone are seen from outside."""
    whole = llvm.parse_assembly("")
    for text in texts:
        # numba's "common" variables are shared by modules, and the whole is one module.
        whole.link_in(
            llvm.parse_assembly(_with_library_names(text.replace("= common ", "= internal ")))
        )
    for function in whole.functions:
        if not function.is_declaration and not function.name.startswith("covey_"):
            function.linkage = "internal"
    return str(whole)


def _with_library_names(text: str) -> str:
    for helper, name in _LIBRARY_NAMES.items():
        text = text.replace(f'@"{helper}"', f"@{name}").replace(f"@{helper}", f"@{name}")
    return text


def compiled_object(text: str, target: Target) -> bytes:
    """Return the object of a module, optimised for a target."""
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(target.triple).create_target_machine(
        cpu=target.processor, features=target.features, opt=_LEVEL, reloc="pic", codemodel="default"
    )
    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = target.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(_LEVEL)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return machine.emit_object(module)
