"""What script/engines installs engines from, and how it builds their adapters."""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADAPTERS = ROOT / "examples/engines"

# What an engine is installed from, and which version; its adapter says what it is asked about.
ENGINES = {
    "rapier": ("npm", "@dimforge/rapier3d-compat", "0.21.0"),
    "jolt": ("npm", "jolt-physics", "1.1.0"),
    "physx": ("npm", "physx-js-webidl", "2.7.3"),
    "havok": ("npm", "@babylonjs/havok", "1.3.14"),
    "planck": ("npm", "planck", "1.5.0"),
    "rapier2d": ("npm", "@dimforge/rapier2d-compat", "0.21.0"),
    "fcl": ("debian", "libfcl-dev", "fcl"),
    "fcl-bodies": ("debian", "libfcl-dev", "fcl"),
    "bullet": ("debian", "libbullet-dev", "bullet"),
    "box2d": ("source", "", ""),
    "box3d": ("source", "", ""),
    "tight-inclusion": ("source", "", ""),
    "ipc-toolkit": ("source", "", ""),
    "tdib-ccd": ("source", "", ""),
}
# The options with which an adapter is asked about all that corpus/engines keeps of its engine.
TAKES = {
    "rapier": "mesh=1:overlap=1",
    "physx": "mesh=1:overlap=1",
    "rapier2d": "overlap=1",
    "planck": "spins=1",
    "fcl-bodies": "far=1:overlap=1",
    "bullet": "mesh=1:spins=1",
    "box2d": "turns=1",
    "box3d": "turns=1",
    "tight-inclusion": "all=1:any-numbers=1",
}
# A folder with a folder of sources for each of the last ones, where --source names none.
SOURCES = os.environ.get("CCDFUZZ_ENGINE_SOURCES")


class BuildError(Exception):
    """The engine is there, and its adapter does not build."""


def fail(text):
    print(f"script/engines: {text}", file=sys.stderr)
    sys.exit(2)


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise RuntimeError(last_lines(command, done.stderr or done.stdout))
    return done.stdout


def last_lines(command, text):
    return "\n".join([f"{' '.join(map(str, command[:3]))} …:", *text.strip().splitlines()[-8:]])


def build_adapter(log, *commands):
    """Runs these commands. What they print is in the file `log`."""
    log.write_text("")
    for command in commands:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        with log.open("a") as file:
            file.write(f"$ {shlex.join(map(str, command))}\n{done.stdout}")
        if done.returncode != 0:
            raise BuildError(f"does not build, see {log}: {last_lines(command, done.stdout)}")


def install_npm(build, name, package, version, only_installed=False):
    """A folder with the package, and a plug-in that runs the adapter there. A version may be `file:`
    and the path of a folder: a package that is not published."""
    if shutil.which("npm") is None:
        raise RuntimeError("npm is not installed")
    folder = build / f"{name}@{version}".replace("/", "-").replace(":", "-")
    adapter = folder / name / "adapter.mjs"
    if only_installed and not (folder / "node_modules").exists():
        raise RuntimeError("it is not installed")
    shutil.rmtree(adapter.parent, ignore_errors=True)  # of an adapter that had other files
    adapter.parent.mkdir(parents=True)
    if not only_installed:
        run(["npm", "install", "--prefix", folder, "--no-audit", "--no-fund", "--no-save",
             f"{package}@{version}"])
    for part in [*(ADAPTERS / name).glob("*.mjs"), *(ADAPTERS / name).glob("*.json")]:
        shutil.copy(part, adapter.parent)
    shutil.copy(ADAPTERS / "bodies.mjs", folder)
    # WebAssembly reserves much more address space than it uses.
    starter = folder / "start"
    starter.write_text(f'#!/bin/sh\nexec node "{adapter}"\n')
    starter.chmod(0o755)
    return folder, f"plugin-exec:{starter}:mb=65536:seconds=10", version


def install_debian(build, name, package, module):
    folder = build / name
    folder.mkdir(parents=True, exist_ok=True)
    found = subprocess.run(["pkg-config", "--modversion", module], capture_output=True, text=True)
    if found.returncode != 0:
        raise RuntimeError(f"Debian's package {package} is not installed")
    version = found.stdout.strip()
    flags = [flag for flag in run(["pkg-config", "--cflags", "--libs", module]).split()
             if not flag.startswith("-std=")]
    library = folder / f"lib{name}_adapter.so"
    build_adapter(folder / "build.log",
                  ["c++", "-std=c++17", "-O2", "-shared", "-fPIC", f"-I{ROOT}/src/method/plugin",
                   f'-DENGINE_VERSION="{version}"', ADAPTERS / name / "adapter.cpp", "-o", library, *flags])
    return folder, f"plugin:{library}", version


def install_source(build, name, tree):
    """Builds the adapter with the engine's own sources."""
    if not tree and SOURCES and (pathlib.Path(SOURCES) / name).exists():
        tree = pathlib.Path(SOURCES) / name
    if not tree:
        raise RuntimeError("--source FOLDER says where its sources are")
    if not pathlib.Path(tree).is_dir():
        fail(f"--source: {tree} is no folder")
    folder = build / name
    (folder / "finds").mkdir(parents=True, exist_ok=True)
    build_adapter(folder / "build.log",
                  ["cmake", "-S", ADAPTERS, "-B", folder / "build", f"-DENGINE={name}",
                   f"-DENGINE_SOURCE={pathlib.Path(tree).resolve()}", "-DCMAKE_BUILD_TYPE=Release"],
                  ["cmake", "--build", folder / "build"])
    return (folder, f"plugin:{folder / 'build/libadapter.so'}:seconds=10",
            (folder / "build/version.txt").read_text())


def install(name, version, arguments):
    """The folder of an engine, the plug-in that asks it, and its version. Raises RuntimeError where it
    cannot be installed here, and BuildError where its adapter does not build."""
    source, package, usual = ENGINES[name]
    if version and source != "npm":
        fail(f"{name}@{version}: only packages of npm have versions to choose")
    if source == "source":
        return install_source(arguments.folder, name, arguments.source)
    if source == "npm":
        return install_npm(arguments.folder, name, package, version or usual, arguments.installed)
    return install_debian(arguments.folder, name, package, usual)
