"""How the documentation is built: `make docs` makes static pages of the texts and the source."""

from __future__ import annotations

import sys
from pathlib import Path

import covey

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS / "_ext"))

project = "covey"
author = "The covey developers"
project_copyright = author
version = release = covey.__version__
html_title = f"covey {release}"

extensions = [
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_copybutton",
    "sphinx_design",
    "sphinx_gallery.gen_gallery",
    "docstrings",
    "keys",
    "mathml",
    "messages",
    "notebooks",
    "shell",
    "unbroken",
]
exclude_patterns = ["_ext", "_templates", "gallery", "generated/gallery/*.ipynb"]
templates_path = ["_templates"]
nitpicky = True

# Texts
myst_enable_extensions = ["attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
myst_dmath_double_inline = True
html_math_renderer = "mathml"

# Programs in texts are run whenever the pages are built, and an error in one ends the build.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_execution_in_temp = True
nb_merge_streams = True
nb_render_markdown_format = "myst"

# The gallery: what each short file draws
sphinx_gallery_conf = {
    "examples_dirs": "gallery",
    "gallery_dirs": "generated/gallery",
    "filename_pattern": "/plot_",
    "image_scrapers": ["pictures.scrape"],
    "abort_on_example_error": True,
    "download_all_examples": False,
    "show_signature": False,
    "write_computation_times": False,
    "min_reported_time": 60,
    "capture_repr": (),
}

# Pages
html_theme = "furo"
html_static_path = ["_static"]
html_css_files = ["covey.css"]
html_copy_source = False
html_show_copyright = False
pygments_style = "friendly"
highlight_language = "none"  # of a block that names no language
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True

# The reference of Python
autodoc_preserve_defaults = True
autodoc_member_order = "bysource"
default_role = "autolink"  # `covey.plan` in a docstring
python_use_unqualified_type_names = True
numpydoc_show_class_members = False
autodoc_type_aliases = {
    name: name for name in ("npt.ArrayLike", "Floats", "Ints", "PursuerPolicy", "TeamPolicy")
}

# What is public has a page. Other libraries have pages elsewhere.
nitpick_ignore_regex = [
    ("py:.*", r"(?!covey\.).*"),
    ("py:.*", r"covey\.(scenarios|studies|views)"),
    ("py:.*", r"covey\.(bounds|model|planning|players|simulation)\..*"),
    ("py:.*", r"covey\.\w+\.\w+\..*"),
]
