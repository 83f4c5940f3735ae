"""The builder of the compiled kernels: the only room, beside `_jit`, that knows the compiler.

Read `lower` (numba: from kernels to unoptimised LLVM code), then `optimise` (LLVM: from the code to
an object for one processor), then `parts`, which builds two objects side by side. `platforms` links
libraries for wheels; `header` tells the entries as C declares them.
"""
