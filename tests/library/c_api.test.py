"""The C interface as programs in C and Fortran get it: pkg-config, static and shared library, the page's programs, the layout of structures."""

import ctypes
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from unittest import SkipTest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "cli"))
from claims import claim, main  # noqa: E402

C = ["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-pedantic", "-Werror"]
FORTRAN = ["gfortran", "-std=f2018", "-O1", "-Wall", "-Wextra", "-pedantic", "-Werror"]

# FCCDA_ABI_VERSION 1, for pointers of 64 bits: size of each structure, place of each member. These numbers never change.
LAYOUT = {
    "fccda_vectors": (48, {"x": 0, "y": 8, "z": 16, "count": 24, "stride": 32, "type": 40, "reserved": 44}),
    "fccda_numbers": (40, {"first": 0, "count": 8, "stride": 16, "value": 24, "type": 32, "reserved": 36}),
    "fccda_points": (224, {"x_t0": 0, "x_t1": 48, "velocity": 96, "mass": 144, "radius": 184}),
    "fccda_surface_options": (24, {"weld_distance": 0, "name": 8, "orientation": 16, "reserved": 20}),
    "fccda_surface_info": (136, {"panels": 0, "panel_vertices": 8, "triangles": 16, "vertices": 24, "repairs": 32, "is_closed": 40, "area": 48, "volume": 56,
                                 "centroid": 64, "low": 88, "high": 112}),
    "fccda_hull": (112, {name: 8 * at for at, name in enumerate(["length", "breadth", "draft", "freeboard", "stem_angle", "waterline_angle", "fullness", "stern_angle",
                                                                 "stern_waterline_angle", "bilge_radius", "stem_radius", "flare", "edge_length", "bow_edge_length"])}),
    "fccda_propeller": (104, {"diameter": 0, "pitch_ratio": 8, "area_ratio": 16, "hub_ratio": 24, "hub_length": 32, "rake": 40, "skew": 48, "thickness_factor": 56,
                              "edge_thickness": 64, "edge_length": 72, "blade_edge_length": 80, "blades": 88, "axis": 92, "is_left_handed": 96, "reserved": 100}),
    "fccda_box": (48, {"size": 0, "centre": 24}),
    "fccda_sectors": (96, {"axis": 0, "point": 24, "radius": 48, "length": 56, "hub_radius": 64, "sector_angle": 72, "start_angle": 80, "blades": 88, "reserved": 92}),
    "fccda_pose": (56, {"position": 0, "attitude": 24}),
    "fccda_motion": (144, {"t0": 0, "t1": 56, "centre": 112, "dt": 136}),
    "fccda_body_properties": (256, {"mass": 0, "centre_of_mass": 8, "inertia": 32, "added_mass": 104, "pose": 128, "velocity": 184, "angular_velocity": 208,
                                    "is_free": 232}),
    "fccda_body_state": (112, {"centre_of_mass": 0, "velocity": 24, "angular_velocity": 48, "attitude": 72, "constraint_work": 104}),
    "fccda_contact": (136, {"point": 0, "panel": 8, "time_fraction": 16, "hit": 24, "normal": 48, "relocation": 72, "depth": 96, "radius": 104, "normal_t0": 112}),
    "fccda_contact_sum": (56, {"impulse": 0, "angular_impulse": 24, "contacts": 48}),
    "fccda_deforming_contact": (208, {"contact": 0, "vertices": 136, "weights": 160, "displacement": 184}),
}
CONSTANTS = {"ABI_VERSION": 1, "OK": 0, "INPUT_ERROR": 1, "RUN_ERROR": 2, "INTERNAL_ERROR": 3, "UNSET": 0, "DOUBLE": 1, "FLOAT": 2, "ONE": 3, "UNDECLARED": 0,
             "NORMALS": 1, "REVERSED": 2, "REFUSE_BEYOND": 0, "IGNORE_BEYOND": 1}


def expected_layout():
    """Lines "structure size" and "structure.member place size". There is no padding: a member ends where the next begins."""
    text = ""
    for struct, (size, members) in LAYOUT.items():
        begins = [*members.values(), size]
        text += f"{struct} {size}\n" + "".join(f"{struct}.{name} {place} {end - place}\n" for (name, place), end in zip(members.items(), begins[1:]))
    return text + "".join(f"{name} {value}\n" for name, value in CONSTANTS.items())


def places(scene):
    return {name: Path(place) for name, place in json.loads(Path(scene.program).read_text()).items()}


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


def expect_program(name):
    if shutil.which(name) is None:
        raise SkipTest(f"{name} is not installed")


def pkg_config(prefix, *arguments):
    expect_program("pkg-config")
    folder = next(prefix.rglob("fccda.pc")).parent
    return run(["pkg-config", *arguments, "fccda"], env={**os.environ, "PKG_CONFIG_PATH": str(folder)}).split()


def program_of_page(scene, page, language):
    text = (places(scene)["source"] / "docs/library" / page).read_text()
    return re.search(rf"```{language}\n(.*?)```", text[text.index("## A complete program"):], re.DOTALL)[1]


def build(scene, prefix, compiler, source, text, *libs):
    """Compiles and runs the program; what it prints."""
    path = scene.folder / source
    path.write_text(text)
    module = pkg_config(prefix, "--variable=fortran_module") if source.endswith(".f90") else []
    run([*compiler, *module, path, "-o", scene.folder / "app", *pkg_config(prefix, "--cflags", "--libs", *libs)], cwd=scene.folder)
    return run([scene.folder / "app"], env={**os.environ, "OMP_WAIT_POLICY": "passive"})


def header(scene):
    return re.sub(r"//.*|/\*.*?\*/", "", (places(scene)["folder"] / "fccda/include/fccda/fccda/fccda.h").read_text())


def functions(scene):
    """Names and numbers of arguments of all functions but the inline ones."""
    found = re.findall(r"^(?:fccda_status|int|const char\*|void) (fccda_\w+)\(([^;{]*)\);", header(scene), re.MULTILINE)
    assert len(found) > 40
    return {name: 0 if arguments.strip() == "void" else arguments.count(",") + 1 for name, arguments in found}


@claim("the programs of the pages in C, Fortran and C++ print the same, built by pkg-config, with --static too")
def pages(scene):
    prefix = places(scene)["folder"] / "fccda"
    of_c = build(scene, prefix, C, "app.c", program_of_page(scene, "c_api.md", "c"))
    scene.assertRegex(of_c, r"^impulse -\d+\.\d+ N s, 0 points inside\n$")
    scene.assertEqual(build(scene, prefix, C, "app.c", program_of_page(scene, "c_api.md", "c"), "--static"), of_c)
    cpp = [places(scene)["compiler"], "-std=c++20", "-O1", "-fopenmp"]
    scene.assertEqual(build(scene, prefix, cpp, "app.cpp", program_of_page(scene, "README.md", "cpp")), of_c)
    expect_program("gfortran")
    scene.assertEqual(build(scene, prefix, FORTRAN, "app.f90", program_of_page(scene, "c_api.md", "fortran")), of_c)


@claim("structures and constants of the C interface have the sizes, places and values of binary interface 1")
def layout(scene):
    lines = []
    for struct, (_, members) in LAYOUT.items():
        lines.append(f'  printf("{struct} %zu\\n", sizeof({struct}));')
        lines += [f'  printf("{struct}.{member} %zu %zu\\n", offsetof({struct}, {member}), sizeof((({struct}*)0)->{member}));' for member in members]
    lines += [f'  printf("{name} %d\\n", (int)FCCDA_{name});' for name in CONSTANTS]
    text = "#include <fccda/fccda.h>\n#include <stdio.h>\nint main(void) {\n" + "\n".join(lines) + "\n  return 0;\n}\n"
    scene.assertEqual(build(scene, places(scene)["folder"] / "fccda", C, "layout.c", text), expected_layout())
    scene.assertEqual(set(re.findall(r"^typedef struct (\w+) \{", header(scene), re.MULTILINE)), set(LAYOUT))
    scene.assertEqual(set(re.findall(r"^  FCCDA_(\w+) = ", header(scene), re.MULTILINE)) | {"ABI_VERSION"}, set(CONSTANTS))


@claim("the Fortran module has every function of the C header with as many arguments, and structures of the same layout")
def fortran(scene):
    prefix = places(scene)["folder"] / "fccda"
    module = next(prefix.rglob("fccda.f90")).read_text()
    declared = re.findall(r"(?:function|subroutine) (fccda_\w+)\(([^)]*)\)\s*bind\(C\)", module.replace("&\n", ""))
    scene.assertEqual({name: len(arguments.split(",")) if arguments.strip() else 0 for name, arguments in declared}, functions(scene))
    expect_program("gfortran")
    lines = []
    for number, (struct, (_, members)) in enumerate(LAYOUT.items()):
        lines.append(f"  call show('{struct}', int(c_sizeof(s{number})))")
        for member in members:
            lines.append(f"  call show('{struct}.{member}', place(c_loc(s{number}), c_loc(s{number}%{member})), &\n    int(c_sizeof(s{number}%{member})))")
    lines += [f"  call show('{name}', int(FCCDA_{dict(UNSET='TYPE_UNSET', ONE='TYPE_ONE', ABI_VERSION='ABI_VERSION_OF_MODULE').get(name, name)}))" for name in CONSTANTS]
    text = "program layout\n  use fccda\n  implicit none\n"
    text += "".join(f"  type({struct}), target :: s{number}\n" for number, struct in enumerate(LAYOUT)) + "\n".join(lines)
    text += """
contains
  subroutine show(name, number, size)
    character(len=*), intent(in) :: name
    integer, intent(in) :: number
    integer, intent(in), optional :: size
    if (present(size)) then
      print '(a, 2(1x, i0))', name, number, size
    else
      print '(a, 1x, i0)', name, number
    end if
  end subroutine
  integer function place(struct, member)
    type(c_ptr), intent(in) :: struct, member
    place = int(transfer(member, 0_c_intptr_t) - transfer(struct, 0_c_intptr_t))
  end function
end program
"""
    scene.assertEqual(build(scene, prefix, FORTRAN, "layout.f90", text), expected_layout())


@claim("views of arrays and of sections of them in Fortran, and lists and texts that C returns, are those of the program")
def fortran_views(scene):
    expect_program("gfortran")
    text = """program views
  use fccda
  implicit none
  real(c_double), target :: x(3, 6), mass(6), transposed(6, 3)
  real(c_float), target :: single(3, 4)
  real(c_double), target :: corners(3, 4) = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 4])
  integer(c_int32_t) :: faces(3, 4) = reshape([1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4], [3, 4])
  type(c_ptr) :: surface, detector, list, at(2)  ! gfortran 12 fails at c_loc(x(1, 2)) as an argument of c_associated
  type(fccda_vectors) :: view
  type(fccda_numbers) :: numbers
  type(fccda_points) :: points
  type(fccda_motion) :: rest
  type(fccda_contact), pointer :: contacts(:)
  integer(c_size_t) :: count
  view = fccda_xyz(x(:, 2::2))
  at = [c_loc(x(1, 2)), c_loc(x(3, 2))]
  print *, view%count, view%stride, view%type, c_associated(view%x, at(1)), c_associated(view%z, at(2))
  view = fccda_xyz(single)
  at(1) = c_loc(single(2, 1))
  print *, view%count, view%stride, view%type, c_associated(view%y, at(1))
  numbers = fccda_each(mass(6:1:-1))
  at(1) = c_loc(mass(6))
  print *, numbers%count, numbers%stride, c_associated(numbers%first, at(1))
  view = fccda_xyz(x(:, 1:0))
  print *, view%count, c_associated(view%x)
  view = fccda_three(x(1, :), x(2, :), x(3, :))
  at = [c_loc(x(1, 1)), c_loc(x(3, 1))]
  print *, view%count, view%stride, view%type, c_associated(view%x, at(1)), c_associated(view%z, at(2))
  view = fccda_three(single(1, 1:2), single(2, 1:2), single(3, 3:4))
  at(1) = c_loc(single(3, 3))
  print *, view%count, view%stride, view%type, c_associated(view%z, at(1))

  if (fccda_surface_create(fccda_xyz(corners), faces - 1, 4_c_size_t, 3, surface=surface) /= FCCDA_OK) error stop fccda_message()
  print *, fccda_text(fccda_surface_report(surface))
  if (fccda_detector_create(surface, 0d0, detector) /= FCCDA_OK) error stop fccda_message()
  x(:, 1:3) = reshape([-5d0, 0.1d0, 0.1d0, -5d0, 0d0, 9d0, -5d0, 0.2d0, 0.2d0], [3, 3])   ! at t0
  x(:, 4:6) = x(:, 1:3)
  x(1, 4:6) = 0.1d0
  points = fccda_points(x_t0=fccda_xyz(x(:, 1:3)), x_t1=fccda_xyz(x(:, 4:6)))
  rest%dt = 1
  if (fccda_detect(detector, rest, points, count) /= FCCDA_OK) error stop fccda_message()
  if (fccda_detector_contacts(detector, list, count) /= FCCDA_OK) error stop fccda_message()
  call c_f_pointer(list, contacts, [count])
  print *, contacts%point + 1
  print '(*(f8.3))', contacts(2)%hit, contacts(2)%normal
  ! other shapes: what is no view is refused
  points = fccda_points(x_t0=fccda_xyz(transposed), x_t1=fccda_xyz(transposed))
  if (fccda_detect(detector, rest, points) == FCCDA_INPUT_ERROR) print '(a)', fccda_message()
  points = fccda_points(x_t0=fccda_three(mass, mass(1:5), mass), x_t1=fccda_three(mass, mass, mass))
  if (fccda_detect(detector, rest, points) == FCCDA_INPUT_ERROR) print '(a)', fccda_message()
  points = fccda_points(x_t0=fccda_three(mass, mass, mass(6:1:-1)), x_t1=fccda_three(mass, mass, mass))
  if (fccda_detect(detector, rest, points) == FCCDA_INPUT_ERROR) print '(a)', fccda_message()
  if (fccda_detector_moved(detector, -1_c_int64_t) == FCCDA_INPUT_ERROR) print '(a)', fccda_message()
end program
"""
    lines = build(scene, places(scene)["folder"] / "fccda", FORTRAN, "views.f90", text).splitlines()
    scene.assertEqual([line.split() for line in lines[:4]], [["3", "48", "1", "T", "T"], ["4", "12", "2", "T"], ["6", "-8", "T"], ["0", "F"]])
    scene.assertEqual([line.split() for line in lines[4:6]], [["6", "24", "1", "T", "T"], ["2", "12", "2", "T"]])
    scene.assertEqual(lines[6].strip(), "4 panels, 4 triangles, 4 vertices, 1 components, closed")
    scene.assertEqual([[float(word) for word in line.split()] for line in lines[-6:-4]], [[1, 3], [0, 0.2, 0.2, -1, 0, 0]])
    scene.assertEqual(lines[-4:-1], 3 * ["fccda: the array `x_t0` has the type 0, but it must be FCCDA_DOUBLE or FCCDA_FLOAT."])
    scene.assertEqual(lines[-1], "fccda: the number of a point is -1, but they are counted from 0.")


@claim("views in Fortran of an array without the attribute target, and of an expression, do not compile")
def fortran_targets(scene):
    expect_program("gfortran")
    module = pkg_config(places(scene)["folder"] / "fccda", "--variable=fortran_module")
    for argument in ("fccda_xyz(x)", "fccda_xyz(2 * y)", "fccda_three(x(1, :), x(2, :), x(3, :))", "fccda_xyz(y)"):
        text = f"program views\n  use fccda\n  implicit none\n  real(c_double) :: x(3, 2)\n  real(c_double), target :: y(3, 2)\n  type(fccda_vectors) :: view\n  x = 1; y = x\n  view = {argument}\n  print *, view%count\nend program\n"
        (scene.folder / "views.f90").write_text(text)
        compiled = subprocess.run(["gfortran", "-fsyntax-only", f"-J{scene.folder}", *module, scene.folder / "views.f90"], capture_output=True, text=True)
        scene.assertEqual(compiled.returncode == 0, argument == "fccda_xyz(y)", argument)


def shared(scene):
    """A prefix with a shared library, of the objects that were compiled for the static one, and the fccda.pc of a shared build."""
    at = places(scene)
    prefix = scene.folder / "shared"
    shutil.copytree(at["folder"] / "fccda", prefix)
    static = next(prefix.rglob("libfccda.a"))
    run([at["compiler"], "-shared", "-fopenmp", "-Wl,-soname,libfccda.so.0.1", "-Wl,--whole-archive", static, "-Wl,--no-whole-archive", "-lz", "-o", static.with_name("libfccda.so.0.1")])
    static.with_name("libfccda.so").symlink_to("libfccda.so.0.1")
    static.unlink()
    build = scene.folder / "build"
    run(["cmake", "-G", "Ninja", "-S", at["source"] / "src/fccda", "-B", build, f"-DCMAKE_CXX_COMPILER={at['compiler']}", "-DBUILD_SHARED_LIBS=ON"])
    shutil.copy(build / "fccda.pc", next(prefix.rglob("fccda.pc")))
    return prefix, static.with_name("libfccda.so")


@claim("a shared library exports every function of the C interface, and C programs need nothing else to link with it")
def shared_library(scene):
    prefix, library = shared(scene)
    exported = {line.split()[-1] for line in run(["nm", "--dynamic", "--defined-only", library]).splitlines()}
    scene.assertEqual(set(functions(scene)) - exported, set())
    libs = pkg_config(prefix, "--libs")
    scene.assertEqual([word for word in libs if word.startswith("-l")], ["-lfccda"])
    scene.assertIn("-lz", pkg_config(prefix, "--libs", "--static"))
    (scene.folder / "app.c").write_text(program_of_page(scene, "c_api.md", "c"))
    run([*C, scene.folder / "app.c", "-o", scene.folder / "app", *pkg_config(prefix, "--cflags"), *libs, f"-Wl,-rpath,{library.parent}"])
    scene.assertRegex(run([scene.folder / "app"]), r"^impulse -\d+\.\d+ N s, 0 points inside\n$")


@claim("a program in another language opens the shared library and calls it by the layout of the structures alone")
def foreign(scene):
    library = ctypes.CDLL(str(shared(scene)[1]))
    library.fccda_last_error.restype = library.fccda_version.restype = ctypes.c_char_p
    scene.assertEqual(library.fccda_abi_version(), CONSTANTS["ABI_VERSION"])
    scene.assertEqual(library.fccda_version(), b"0.1.0")
    surface, body, energy = ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_double()
    scene.assertEqual(library.fccda_surface_read(b"none.stl", None, ctypes.byref(surface)), CONSTANTS["INPUT_ERROR"])
    scene.assertIn(b"none.stl: there is no such file", library.fccda_last_error())
    properties = (ctypes.c_char * LAYOUT["fccda_body_properties"][0])()

    def put(member, *numbers):
        places_of = LAYOUT["fccda_body_properties"][1]
        (ctypes.c_double * len(numbers)).from_buffer(properties, places_of[member])[:] = numbers

    put("mass", 3.0)
    put("velocity", 0, 0, 2)
    scene.assertEqual(library.fccda_body_create(properties, ctypes.byref(body)), CONSTANTS["INPUT_ERROR"])  # an attitude of length 0
    put("pose", 0, 0, 0, 1, 0, 0, 0)
    scene.assertEqual(library.fccda_body_create(properties, ctypes.byref(body)), CONSTANTS["OK"])
    scene.assertEqual(library.fccda_body_kinetic_energy(body, ctypes.byref(energy)), CONSTANTS["OK"])
    scene.assertEqual(energy.value, 6.0)
    library.fccda_body_destroy(body)


@claim("CMake finds fccda for programs in C and Fortran, and says what a project without C++ lacks")
def cmake(scene):
    at = places(scene)
    (scene.folder / "app.c").write_text(program_of_page(scene, "c_api.md", "c"))
    (scene.folder / "app.f90").write_text(program_of_page(scene, "c_api.md", "fortran"))

    def configure(languages, target):
        text = f"cmake_minimum_required(VERSION 3.25)\nproject(app LANGUAGES {languages})\nfind_package(fccda 0.1 REQUIRED)\n"
        (scene.folder / "CMakeLists.txt").write_text(text + f"add_executable(app {target})\ntarget_link_libraries(app PRIVATE fccda::fccda)\n")
        shutil.rmtree(scene.folder / "build", ignore_errors=True)
        command = ["cmake", "-G", "Ninja", "-S", scene.folder, "-B", scene.folder / "build", f"-DCMAKE_PREFIX_PATH={at['folder'] / 'fccda'}"]
        return subprocess.run([*command, f"-DCMAKE_CXX_COMPILER={at['compiler']}"], capture_output=True, text=True)

    def output():
        run(["cmake", "--build", scene.folder / "build"])
        return run([scene.folder / "build/app"])

    without = configure("C", "app.c")
    scene.assertNotEqual(without.returncode, 0)
    scene.assertIn("add CXX to the LANGUAGES of project()", " ".join(without.stderr.split()))
    scene.assertEqual(configure("C CXX", "app.c").returncode, 0)
    of_c = output()
    scene.assertRegex(of_c, r"^impulse -\d+\.\d+ N s, 0 points inside\n$")
    expect_program("gfortran")
    scene.assertEqual(configure("Fortran CXX", "${fccda_FORTRAN_MODULE} app.f90").returncode, 0)
    scene.assertEqual(output(), of_c)


main()
