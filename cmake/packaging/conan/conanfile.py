"""NOT TRIED: Conan could not be had where this was written. Conan 2 recipe of the library, built from the checkout that it
lies in:  conan create cmake/packaging/conan -s compiler.cppstd=20 --build=missing"""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Graze(ConanFile):
    name = "graze"
    license = "MIT"
    description = "Certified casts for convex shapes"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"

    @property
    def _checkout(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    def set_version(self):
        self.version = load(self, os.path.join(self._checkout, "CMakeLists.txt")).split("VERSION ")[2].split()[0]

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "core/*", "scene/*", "engines/adapter/*"):
            copy(self, pattern, self._checkout, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.4 <6]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(GRAZE_TOOLS=False, GRAZE_TESTS=False)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        # CMake finds the package's own files. The rest is for other build systems.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/graze"]
        self.cpp_info.libs = ["graze_scene", "graze"]
        self.cpp_info.defines = ["GRAZE_COMPILED"]
        if self.settings.os == "Linux":
            self.cpp_info.system_libs = ["pthread"]
