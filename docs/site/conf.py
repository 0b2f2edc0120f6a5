"""Configuration of the site (scripts/site): Sphinx reads it from the folder that docs/site/stage.py has filled."""

import os

project = "SMAT"
author = "SMAT developers"
copyright = "SMAT developers, MIT licence"
release = os.environ["SMAT_VERSION"]
source = os.environ["SMAT_SITE_SOURCE"]
version = release

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_design",
    "sphinx-mathjax-offline",
]
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 5
nitpicky = False  # types of Python in docstrings are words, not links
napoleon_numpy_docstring = True
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True
autodoc_member_order = "groupwise"
autodoc_typehints = "none"
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = f"SMAT {release}"
html_show_sphinx = False
html_copy_source = False
exclude_patterns = ["extra", "static"]
html_extra_path = [f"{source}/extra"]
html_static_path = [f"{source}/static"]
html_favicon = f"{source}/static/smat.svg"
html_theme_options = {
    "light_logo": "smat.svg",
    "dark_logo": "smat.svg",
    "top_of_page_buttons": [],
}
