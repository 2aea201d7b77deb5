"""How Sphinx makes the site of the Markdown pages (scripts/build_docs.sh). The pages know nothing of it: they are plain Markdown with links
between files, and read as well without it."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FRONT = "docs/index"

project = "perimpact"
copyright = "the perimpact authors, BSD 3-Clause"
release = re.search(r"project\(perimpact VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

# What is under each heading of the navigation, in order.
NAVIGATION = {
    "Guide": [
        "guide/getting_started", "guide/install", "guide/tutorials/1_plate", "guide/tutorials/2_your_part", "guide/tutorials/3_ice_and_hull", "guide/comparison",
        "guide/units_and_axes", "guide/solids", "guide/user_materials", "guide/surface_meshes", "guide/shapes", "guide/surface_formats",
        "guide/real_surfaces", "guide/elastic_impactors", "guide/spacing_and_layers", "guide/calibration", "guide/ship_in_level_ice", "guide/contact_bounds", "guide/results", "guide/loads", "guide/report", "guide/restart", "guide/command_line", "guide/messages", "guide/cluster", "guide/gpu", "guide/python", "guide/python_reference",
        "guide/troubleshooting", "guide/diagnoses", "guide/errors"],
    "Deck reference": ["guide/deck/index"] + [f"guide/deck/{name}" for name in (
        "time", "bodies", "moving_window", "shapes", "cracks", "particle_sets", "materials", "ice", "plasticity", "failure", "boundary_conditions", "impactors", "surfaces",
        "remeshing", "contact_bounds", "motion", "gauges", "contact", "output")],
    "Cases": [
        f"/cases/{name}/README" for name in ("plate_impact", "ship_ice", "uikku_ice", "propeller_ice", "submarine_surfacing", "ice_sphere", "hull_panel", "ice_specimens", "ice_paddle", "floating_strip",
                                             "crack_branching", "kalthoff_winkler")],
    "Theory": [
        f"theory/{name}" for name in ("peridynamics", "ordinary_state", "correspondence", "lattice", "damage", "time_step", "relaxation", "boundary_conditions", "floating_bodies", "moving_window", "ice", "ice_plasticity",
                                      "contact", "contact_bounds", "contact_response", "deforming_contact", "short_range", "energy", "remeshing", "convergence", "detection_evidence", "floating_strip",
                                      "resistance", "fccda_variants", "glossary")],
    "Library": ["library/README", "library/recipes", "library/deforming_surfaces", "library/c_api", "library/couplings", "library/reference"],
    "Validation": ["validation"],
    "Developer": ["developer/structure", "developer/ranks", "developer/gpu", "developer/testing", "/validation/README", "/benchmarks/README", "/CONTRIBUTING", "/CHANGELOG"],
}

extensions = ["myst_parser"]
root_doc = FRONT
include_patterns = ["docs/**.md", "cases/*/README.md", "benchmarks/README.md", "README.md", "CHANGELOG.md", "CONTRIBUTING.md"] + [
    f"{folder}/**.md" for folder in ("validation", "python", "report") if (ROOT / folder).is_dir()]
exclude_patterns = ["**/node_modules"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
highlight_language = "none"  # formulas stand in plain blocks
suppress_warnings = ["misc.highlighting_failure"]  # code that leaves something out with "…"

html_theme = "furo"
html_title = f"perimpact {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = ["root"]
html_copy_source = False
html_show_sphinx = False


def setup(app):
    app.connect("source-read", add_navigation)
    app.connect("source-read", show_headers)
    app.connect("source-read", link_cpp_reference)
    app.connect("build-finished", complete_theme)


def add_navigation(app, page, source):
    """The front page gets the navigation; pages that have no place in it come last. The README of the repository is no part of the site's."""
    if page == "README":
        source[0] = "---\norphan: true\n---\n" + source[0]
    if page != FRONT:
        return
    headings = {heading: [each if each.startswith("/") else f"/docs/{each}" for each in pages] for heading, pages in NAVIGATION.items()}
    listed = {FRONT, "README", *(each.removeprefix("/") for pages in headings.values() for each in pages)}
    if rest := sorted(app.env.found_docs - listed):
        headings["More"] = [f"/{each}" for each in rest]
    for heading, pages in headings.items():
        source[0] += f"\n\n```{{toctree}}\n:hidden:\n:caption: {heading}\n\n" + "\n".join(pages) + "\n```\n"


def complete_theme(app, failure):
    """Debian's furo expects a web server: its style sheet imports another by an absolute path, and its script, which the pages load as a plain one,
    imports a module. Opened from the disk, pages would have neither dark mode nor a table of contents that follows."""
    if failure:
        return
    static = Path(app.outdir) / "_static"
    style = static / "styles/furo.css"
    normalize = "/javascript/normalize.css/normalize.css"
    style.write_text(style.read_text(encoding="utf-8").replace(f"url({normalize})", "url(normalize.css)"), encoding="utf-8")
    style.with_name("normalize.css").write_bytes(Path("/usr/share" + normalize).read_bytes())
    script = static / "scripts/furo.js"
    module = 'import Gumshoe from "./gumshoe-patched.js";'
    script.write_text(script.read_text(encoding="utf-8").replace(module, script.with_name("gumshoe-patched.js").read_text(encoding="utf-8")), encoding="utf-8")


def link_cpp_reference(app, page, source):
    """Pages name the C++ reference by its place in the built site, which Markdown cannot link to: the site links there."""
    up = "../" * page.count("/")
    source[0] = re.sub(r"`build/docs/(cpp/\w+/index\.html)`", lambda found: f'<a href="{up}{found[1]}"><code>{found[1]}</code></a>', source[0])


def show_headers(app, page, source):
    """A link to a header that stands alone on its line is followed by the header itself, as it is."""
    if page == "docs/library/reference":
        source[0] = re.sub(r"^\[[\w/]+\.h(?:pp)?\]\((\S+)\)$", r"\g<0>\n\n```{literalinclude} \1\n:language: cpp\n```", source[0], flags=re.MULTILINE)
