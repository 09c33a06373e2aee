"""How Sphinx makes the book from the Markdown files of the repository, where they stand; run by scripts/book/build."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

from sphinxcontrib import katex

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]

project = "Coulter"
author = copyright = "The Coulter developers"  # noqa: A001: the name that Sphinx wants
release = re.search(r'^version = "([^"]+)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
language = "en_GB"

extensions = ["myst_parser", "sphinx_external_toc", "sphinxcontrib.katex", "sphinx_copybutton"]
external_toc_path = str(HERE / "toc.yml")
# Pages stand here; cases, data and source files that they link to are copied into the book.
include_patterns = ["*.md", "docs/**", "validation/**", "scripts/rivals/**", "crates/python/**"]
exclude_patterns = ["target", "results", "crates/*/src", "crates/python/tests", ".git"]
external_toc_exclude_missing = True

myst_enable_extensions = ["dollarmath", "html_image"]
myst_heading_anchors = 5
myst_dmath_double_inline = True
# Outputs of the program and of shells have no language.
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]

katex_prerender = True
# On a machine that is busy with other things [s].
katex.STARTUP_TIMEOUT = katex.RENDER_TIMEOUT = 60.0
# By a file the extension may connect before its server listens; by a port it tries again.
katex.KaTeXServer.start_server_process = katex.KaTeXServer.start_network_socket
katex_css_path = "katex.min.css"
katex_options = "throwOnError: true, strict: false"

html_theme = "furo"
html_title = f"Coulter {release}"
html_static_path = [str(HERE / "static"), os.environ["COULTER_BOOK_KATEX"]]
html_css_files = ["book.css"]
html_copy_source = False
html_show_sphinx = False

VIEWER = ROOT / "docs/data/verification.html"
MAP = "<!-- map of the files: made when the book is built -->"


def setup(app):
    app.connect("source-read", with_map)
    app.connect("source-read", with_links_of_the_book)
    app.connect("build-finished", finished)


def with_map(app, page, source):
    """Puts the map of the source files where its mark stands."""
    if MAP in source[0]:
        shown = subprocess.run([sys.executable, HERE / "map.py", "--markdown"], capture_output=True, text=True, check=True)
        source[0] = source[0].replace(MAP, shown.stdout)


def with_links_of_the_book(app, page, source):
    """A link to a folder leads nowhere in the book; the viewer of the verification is a page of it."""
    here = Path(app.env.doc2path(page)).parent
    folder = lambda found: found[1] if "//" not in found[2] and (here / found[2]).is_dir() else found[0]  # noqa: E731
    source[0] = re.sub(r"\[([^\]]*)\]\(([^)#\s]+)\)", folder, source[0])
    up = "../" * page.count("/")
    source[0] = re.sub(r"\[([^\]]*)\]\([^)]*" + VIEWER.name + r"\)", rf'<a href="{up}{VIEWER.name}">\1</a>', source[0])


def finished(app, failure):
    """Fills the viewer of the verification with its data; the first page stands where a browser looks for it."""
    if failure is not None:
        return
    out = Path(app.outdir)
    data = json.loads((ROOT / "docs/data/verification.json").read_text(encoding="utf-8"))
    paths = [path for benchmark in data["benchmarks"] for path in benchmark["pictures"]]
    data["svg"] = {path: (ROOT / "docs" / path).read_text(encoding="utf-8") for path in paths}
    mark = '<script type="application/json" id="data">'
    filled = json.dumps(data, ensure_ascii=False).replace("</", "<\\/")
    page = VIEWER.read_text(encoding="utf-8").replace(mark, mark + filled, 1)
    (out / VIEWER.name).write_text(page, encoding="utf-8")
    (out / "index.html").write_text('<meta http-equiv="refresh" content="0; url=docs/README.html">\n', encoding="utf-8")
