"""Games described in files: TOML in, all its mistakes told at once, and a scenario out.

Read schema and strategies (what may stand in a file), values (what a value may be), mistakes and
consistency (what is wrong with a file), then load, build and scenario. Studies read their files by
the same types. about and json_schema are for the reference and for editors. The public names stand
in `__init__.pyi`; pydantic is loaded with the first file that is read.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
