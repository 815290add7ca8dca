# vertexContact: explicit large-strain contact dynamics in OpenFOAM
# Copyright (C) 2026 vertexContact developers
# SPDX-License-Identifier: GPL-3.0-or-later

from pathlib import Path

from spack.package import *

try:
    from spack_repo.builtin.build_systems.generic import Package
except ImportError:
    pass    # before Spack 1.0 spack.package has it

# etc/spack/spack_repo/vertexcontact/packages/vertexcontact/package.py
CHECKOUT = Path(__file__).resolve().parents[6]


class Vertexcontact(Package):
    """Explicit contact dynamics of solids at large strains, in OpenFOAM."""

    # What is committed in the checkout where this recipe is
    git = CHECKOUT.as_uri()

    license("GPL-3.0-or-later")

    version("main", branch="main")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("gmake", type="build")
    depends_on("openfoam@1912:")

    def setup_build_environment(self, env):
        env.set("FOAM_MODULE_LIBBIN", self.prefix.lib)
        env.set("FOAM_MODULE_APPBIN", self.prefix.bin)
        # For every processor of the target, not only this one
        env.set("VERTEXCONTACT_PORTABLE", "1")

    def setup_run_environment(self, env):
        env.prepend_path("PATH", self.prefix.bin)
        env.prepend_path("LD_LIBRARY_PATH", self.prefix.lib)

    def install(self, spec, prefix):
        # Spack's OpenFOAM says where it is by FOAM_PROJECT_DIR
        Executable("bash")(
            "-c", '. "$FOAM_PROJECT_DIR/etc/bashrc"; exec ./Allwmake -j "$1"',
            "bash", str(make_jobs))
        install_tree("tutorials", prefix.tutorials)
        install("COPYING", prefix)
