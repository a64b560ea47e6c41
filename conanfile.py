"""Recipe of the library for Conan 2: `conan create .` builds it from this tree and then examples/first_device against it.

Options: channel_b_compiler, the compiler of channel B, so that the two channels come from different ones (`-o channel_b_compiler=clang++-19`);
empty, the compiler of the profile compiles both.
"""
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, load


class Counterpoint(ConanFile):
    name = "counterpoint"
    description = "CANopen Safety (EN 50325-5) kernel with two diverse channels"
    license = "Apache-2.0"
    topics = ("canopen", "canopen-safety", "functional-safety", "embedded")
    package_type = "static-library"
    test_package_folder = "tests/integration/conan"
    settings = "os", "arch", "compiler", "build_type"
    options = {"channel_b_compiler": ["", "ANY"]}
    default_options = {"channel_b_compiler": ""}
    exports_sources = ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "cmake/*", "version/*", "names/*", "safety_core/*", "channel_a/*", "channel_b/*",
                       "hal/*", "canopen/*", "runtime/*.hpp", "docs/*.md", "examples/*")

    def set_version(self):
        text = load(self, f"{self.recipe_folder}/CMakeLists.txt")
        self.version = re.search(r"project\(Counterpoint VERSION (\S+)", text).group(1)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["COUNTERPOINT_HOST"] = False
        toolchain.cache_variables["COUNTERPOINT_WERROR"] = False
        toolchain.cache_variables["COUNTERPOINT_CHANNEL_B_COMPILER"] = str(self.options.channel_b_compiler)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="counterpoint_package")

    def package(self):
        CMake(self).install(component="library")
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        # The package's own CMake files say what there is.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/Counterpoint"]
        self.cpp_info.includedirs = ["include/counterpoint"]
        self.cpp_info.libdirs = ["lib/counterpoint"]
