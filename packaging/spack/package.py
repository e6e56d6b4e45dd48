# SPDX-License-Identifier: BSD-3-Clause
"""Recipe of Spack for Barreno: see docs/install.md for how to use it, and for what of it was tried."""

from spack.package import *


class Barreno(CMakePackage):
    """Material point method for shaped-charge jets that penetrate sandstone, with the sandstone model Arenisca."""

    license("BSD-3-Clause")

    # Sources are those of this tree: `spack dev-build` or `spack develop --path` in it, without a download.
    sanity_version = "0.1.0"
    version(sanity_version)

    variant("native", default=True, description="Compile for the processor of this machine")
    variant("python", default=True, description="What report, film, converge, sweep, uncertainty, compare and fit need")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("python@3.9:", type=("build", "run"))

    # mpirun is what the commands start.
    depends_on("mpi", type=("build", "link", "run"))
    depends_on("trilinos@13.2:13 cxxstd=17 +mpi +shared +tpetra +kokkos +belos +ifpack2 +muelu +exodus")
    depends_on("hdf5@1.10: +mpi")
    depends_on("libdeflate")
    depends_on("cgal@5:", type="build")
    depends_on("cli11@2:", type="build")
    depends_on("nlohmann-json@3.9:", type="build")

    with when("+python"):
        depends_on("py-numpy", type="run")
        depends_on("py-scipy", type="run")
        depends_on("py-matplotlib", type="run")
        depends_on("py-pandas", type="run")
        depends_on("py-netcdf4", type="run")
        depends_on("py-jinja2", type="run")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("BARRENO_TESTS", False),
            self.define_from_variant("BARRENO_NATIVE", "native"),
            self.define("BARRENO_PYTHON", self.spec["python"].command.path),
        ]

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def check_installation(self):
        """Version, and the plan of a shipped deck, from the installed commands."""
        barreno = Executable(self.prefix.bin.barreno)
        barreno("--version")
        barreno("check", join_path(self.prefix.share, "barreno", "input_xml", "perforation_quick.xml"))
