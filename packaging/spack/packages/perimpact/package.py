# Spack recipe of perimpact: spack repo add packaging/spack && spack install perimpact
from spack.package import *


class Perimpact(CMakePackage):
    """Peridynamic impact with rigid bodies of any shape, with continuous contact detection."""

    # not released yet: put the address of your clone or mirror here, or use `spack dev-build` in a clone
    homepage = "https://example.org/perimpact"
    git = "https://example.org/perimpact.git"

    license("BSD-3-Clause")
    version("main", branch="main")

    variant("python", default=False, description="Build the Python package")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("fmt@9:")
    depends_on("yaml-cpp@0.7:")
    depends_on("udunits@2.2:")
    depends_on("cli11@2.1:", type="build")
    depends_on("zlib-api")
    depends_on("hdf5@1.10: ~mpi")
    depends_on("python@3.11:", when="+python", type=("build", "run"))
    depends_on("py-pybind11", when="+python", type="build")
    depends_on("py-numpy", when="+python", type=("build", "run"))

    conflicts("%gcc@:11", msg="C++20 of GCC 12 or newer is needed")

    generator("ninja")

    def cmake_args(self):
        return [self.define("PERIMPACT_TESTS", False), self.define("PERIMPACT_GROUPED", True), self.define_from_variant("PERIMPACT_PYTHON", "python"),
                self.define("PERIMPACT_ARCH", "")]
