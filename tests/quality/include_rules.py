"""Who includes whom in src/. Two claims:

 1. what the sources include is what their module DEPENDS on (or LINKs, of other libraries), by the add_module lines of
    src/*/CMakeLists.txt, directly or through what that depends on: so the build and the includes never disagree;
 2. those lines keep to the layers below, whatever becomes of them.

    include_rules.py SRC
"""

import re
import sys
from pathlib import Path

# Constants and setups of what several materials share, and all of the deck model
CONSTANTS = ["perimpact/materials/elastic", "perimpact/materials/ice", "perimpact/materials/plasticity"]
DECK = ["perimpact/deck_model", *CONSTANTS]

# The layers: module or folder → what it may depend on, at most. A folder stands for all modules in it.
LAYERS = {
    "base": [],
    "mesh": ["base"],
    "mesh_io": ["base", "mesh"],
    "mesh_io/vtk": ["base", "mesh", "mesh_io/file"],
    "mesh_io/gmsh": ["base", "mesh", "mesh_io/file"],
    "mesh_io/keyword": ["base", "mesh", "mesh_io/file"],
    "fccda": ["base", "mesh", "mesh_io", "marine"],
    "fccda/rigid_body": ["base", "mesh"],
    "fccda/contact_bounds": ["base", "mesh"],
    "fccda/detect": ["base", "mesh", "fccda/contact_bounds", "fccda/rigid_body"],
    "fccda/respond": ["base", "mesh", "fccda"],
    "fccda/deforming": ["base", "mesh", "fccda/contact_bounds", "fccda/rigid_body", "fccda/detect", "fccda/respond"],
    "marine": ["base", "mesh", "fccda/rigid_body"],
    "perimpact": ["base", "mesh", "mesh_io", "marine", "fccda"],
    "perimpact/deck_model": ["base", *CONSTANTS],
    "perimpact/ranks": ["base"],
    "perimpact/particles": ["base", "perimpact/ranks"],
    "perimpact/family": ["base", *DECK, "perimpact/ranks", "perimpact/particles"],
    "perimpact/fragments": ["base", *DECK, "perimpact/ranks", "perimpact/particles", "perimpact/family"],
    "perimpact/force": ["base", *DECK, "perimpact/ranks", "perimpact/particles", "perimpact/family"],
    "perimpact/damage": ["base", *DECK, "perimpact/ranks", "perimpact/particles", "perimpact/family", "perimpact/force"],
    "perimpact/materials": ["base", *DECK, "perimpact/ranks", "perimpact/particles", "perimpact/family", "perimpact/force", "perimpact/damage"],
    "perimpact/materials/elastic": ["base"],
    "perimpact/materials/ice": ["base"],
    "perimpact/materials/plasticity": ["base"],
    "perimpact/self_contact": ["base", *DECK, "perimpact/ranks", "perimpact/particles", "perimpact/family"],
    "perimpact/discretisation": ["base", "mesh", "mesh_io", *DECK, "perimpact/ranks", "perimpact/particles"],
    "perimpact/impactor": ["base", "mesh", "mesh_io", "marine", "fccda", *DECK, "perimpact/contact_bounds", "perimpact/ranks", "perimpact/particles", "perimpact/discretisation"],
    "perimpact/contact_bounds": ["base", "mesh", "fccda", *DECK],
    "io": ["base", "mesh", "mesh_io", "marine", "fccda", "perimpact"],
    "io/deck": ["base", "mesh", *DECK],
    "io/hdf5": ["base", "mesh", "io/output"],
    "io/frames": ["base", "mesh", "mesh_io", *DECK, "io/output", "io/hdf5"],
    "io/statistics": ["base", "mesh", "mesh_io", *DECK, "io/output", "io/hdf5", "io/frames", "io/deck"],
    "io/report": ["base", "mesh", "mesh_io", *DECK, "io/output", "io/hdf5", "io/frames", "io/deck", "io/statistics"],
    "io/output": ["base", "mesh"],
    "ranks_mpi": ["base", "perimpact/ranks"],
    "run": ["base", "mesh", "mesh_io", "marine", "fccda", "perimpact", "io/output", "io/hdf5", "io/frames", "io/deck", "io/results", "io/checkpoint"],
}

# Headers of other libraries → what a module that includes them must LINK
LIBRARIES = {"fmt/": "fmt::fmt", "yaml-cpp/": "yaml-cpp", "udunits2.h": "${UDUNITS2_LIBRARY}", "zlib.h": "ZLIB::ZLIB", "hdf5.h": "${HDF5_LIBRARY}", "CLI/": "CLI11::CLI11", "mpi.h": "MPI::MPI_CXX"}
ONLY_IN = {"omp.h": "base/parallel.hpp", "CLI/": "cli/parse_command_line.cpp", "mpi.h": "ranks_mpi/mpi_ranks.hpp", "cuda": "gpu_cuda/open_device.cu"}  # the one home of loops over threads, and a header that is slow to compile

# Features: a line add_material(name …) declares the module in this folder. Its setup.hpp and setup.cpp are part of the deck model.
FEATURES = {"material": "perimpact/materials", "boundary_condition": "perimpact/boundary_conditions", "contact_bounds": "perimpact/contact_bounds"}
DECK_PART = re.compile(r"perimpact/(materials|boundary_conditions|contact_bounds)/\w+/setup\.[ch]pp$")
GENERATED = {f"{folder}/all_{of}.hpp": owner or folder for folder in FEATURES.values() for of, owner in (("setups", "perimpact/deck_model"), (folder.split("/")[-1], None))}
# Headers that programs include by a shorter path than that of the module they belong to
GENERATED["fccda/fccda.h"] = "fccda/c"

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)


def read_modules(src):
    """Modules as CMake knows them: path → (DEPENDS, LINK)."""
    modules, registered = {}, {}
    for file in sorted(src.glob("*/CMakeLists.txt")):
        for command, path, arguments in re.findall(r"^add_(\w+)\(([\w/]+)([^)]*)\)", file.read_text(), re.MULTILINE):
            parts = re.split(r"\b(DEPENDS|LINK)\b", arguments)
            named = {key: words.split() for key, words in zip(parts[1::2], parts[2::2])}
            if command in FEATURES:
                path = f"{FEATURES[command]}/{path}"
                registered.setdefault(FEATURES[command], []).append(path)
            elif command != "module":
                continue
            depends = [each for word in named.get("DEPENDS", []) for each in (registered[f"perimpact/{word[2:-len('_modules}')]}"] if word.endswith("_modules}") else [word])]
            modules[path] = (depends, named.get("LINK", []))
    commands = re.search(r"target_link_libraries\(perimpact PRIVATE ([^)]*)\)", (src / "cli/CMakeLists.txt").read_text())[1].split()
    targets = {path.replace("/", "_"): path for path in modules}
    modules["cli"] = ([targets[word] for word in commands if word in targets], [word for word in commands if word not in targets])
    return modules


def reachable(modules, path):
    """What the module depends on, directly or not."""
    found, todo = set(), list(modules[path][0])
    while todo:
        dependency = todo.pop()
        if dependency not in found:
            found.add(dependency)
            todo += modules[dependency][0]
    return found


def module_of(path, modules):
    """The module that owns src/<path>: the longest that is a folder above it; of a feature's deck part, the deck model."""
    if DECK_PART.match(path):
        return "perimpact/deck_model"
    owners = [module for module in modules if path.startswith(module + "/")]
    return max(owners, key=len, default=None)


def is_in(module, layer):
    return module == layer or module.startswith(layer + "/")


def layer_faults(modules):
    for module in modules:
        below = reachable(modules, module)
        if module in below:
            yield f"{module} depends on itself through others"
        for layer, allowed in LAYERS.items():
            if is_in(module, layer):
                for dependency in sorted(below):
                    if not any(is_in(dependency, each) for each in [layer, *allowed]):
                        yield f"{module} depends on {dependency}, but below {layer} there is only: {', '.join(allowed) or 'nothing'}"
        if module != "cli" and "cli" in below:
            yield f"{module} depends on cli, which is the program and no library"


def include_faults(src, modules):
    files = sorted(path for path in src.rglob("*") if path.suffix in (".hpp", ".cpp"))
    assert len(files) > 50, f"there are hardly any sources in {src}"
    for file in files:
        name = file.relative_to(src).as_posix()
        module = module_of(name, modules)
        if module is None:
            yield f"{name} belongs to no module: its folder has no add_module line"
            continue
        below = reachable(modules, module)
        links = set(modules[module][1]).union(*(modules[each][1] for each in below))
        for mark, include in INCLUDE.findall(file.read_text()):
            if (src / include).is_file() or include in GENERATED:
                owner = GENERATED.get(include) or module_of(include, modules)
                if owner != module and owner not in below:
                    yield f"{name} includes {include}, but {module} does not depend on {owner}"
            elif mark == '"':
                yield f'{name} includes "{include}", which is no path from src/'
            for prefix, library in LIBRARIES.items():
                if include.startswith(prefix) and library not in links:
                    yield f"{name} includes {include}, but {module} does not link {library}"
            for prefix, home in ONLY_IN.items():
                if include.startswith(prefix) and name != home:
                    yield f"{name} includes {include}, which only {home} may"


def main():
    src = Path(sys.argv[1])
    modules = read_modules(src)
    faults = [*layer_faults(modules), *include_faults(src, modules)]
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
