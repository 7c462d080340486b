"""The Debian package that cpack -G DEB makes: what is in it, what it says of itself, and that it works from a root of its own."""

import os
import re
import shutil
import subprocess
import sysconfig

import pytest
from conftest import environment_without_build

SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")
PACKAGES = "usr/lib/python3/dist-packages"


def output_of(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL, **options).stdout


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("deb")
    output_of("cpack", "-G", "DEB", "-B", folder, "--config", f"{os.environ['PHOTIC_BUILD']}/CPackConfig.cmake")
    [package] = folder.glob("*.deb")
    return package


@pytest.fixture(scope="module")
def control(package):
    text = output_of("dpkg-deb", "--field", package)
    return dict(re.findall(r"^(\S+): (.*(?:\n .*)*)", text, re.MULTILINE))


@pytest.fixture(scope="module")
def root(package, tmp_path_factory):
    root = tmp_path_factory.mktemp("root")
    output_of("dpkg-deb", "--extract", package, root)
    return root


def test_it_says_what_it_is_and_needs(package, control, program):
    # Seen red: without shlibdeps, and with matplotlib among what it depends on.
    version = output_of(program, "--version").split()[1]
    architecture = output_of("dpkg", "--print-architecture").strip()
    assert package.name == f"photic_{version}_{architecture}.deb"
    said = {key: control[key] for key in ("Package", "Version", "Architecture", "Section", "Maintainer", "Recommends")}
    assert said == {
        "Package": "photic", "Version": version, "Architecture": architecture, "Section": "science",
        "Maintainer": "The Photic developers", "Recommends": "python3-matplotlib",
    }
    depends = {word.split()[0] for word in control["Depends"].split(", ")}
    assert {"python3", "python3-numpy", "python3-xarray", "python3-netcdf4"} <= depends
    assert {name.rstrip("0123456789-.") for name in depends} >= {"libc", "libstdc++", "libnetcdf", "libfmt"}
    assert "python3-matplotlib" not in depends
    assert control["Description"].startswith("simulator of oceanographic lidar\n ")


def test_it_holds_files_at_debians_places_and_no_others(package):
    # Seen red: without cmake/debian/finish.cmake, and with a file in /opt.
    listed = output_of("dpkg-deb", "--contents", package)
    files = {line.split()[5].removeprefix("./") for line in listed.splitlines() if not line.startswith("d")}
    assert all(line.split()[1] == "root/root" for line in listed.splitlines())
    assert files >= {
        "usr/bin/photic", "usr/share/man/man1/photic.1.gz", "usr/share/zsh/vendor-completions/_photic",
        "usr/share/bash-completion/completions/photic", "usr/share/fish/vendor_completions.d/photic.fish",
        "usr/share/photic/data/water_mason_2016.csv", "usr/share/photic/scenes/ship.toml",
        "usr/share/doc/photic/copyright", "usr/share/doc/photic/docs/guide.md", f"{PACKAGES}/photic/__init__.py",
        f"{PACKAGES}/photic/_core{SUFFIX}",
        f"{PACKAGES}/photic/data", f"{PACKAGES}/photic/scenes", f"{PACKAGES}/photic/py.typed",
    }
    folders = (
        "usr/bin/photic", "usr/share/photic/", "usr/share/doc/photic/", "usr/share/man/man1/", f"{PACKAGES}/photic",
        "usr/share/bash-completion/completions/", "usr/share/zsh/vendor-completions/", "usr/share/fish/",
    )
    assert [file for file in files if not file.startswith(folders)] == []
    assert not any(file.endswith(".pyc") for file in files)


def test_its_scripts_are_sound(package, tmp_path):
    output_of("dpkg-deb", "--control", package, tmp_path)
    for script in ("postinst", "prerm"):
        assert os.access(tmp_path / script, os.X_OK)
        output_of("sh", "-n", tmp_path / script)


def test_from_its_root_the_program_runs_and_draws(root, scene, tmp_path):
    environment = environment_without_build(root / "usr/bin")
    output_of("photic", "run", scene, "-o", "out.nc", cwd=tmp_path, env=environment)
    output_of("photic", "plot", "out.nc", "-o", "out.png", cwd=tmp_path, env=environment)
    assert (tmp_path / "out.png").read_bytes().startswith(b"\x89PNG")
    # By the package beside it, and not by that of the source tree. Seen red: with the package at another place.
    shutil.copytree(root, tmp_path / "spoilt")
    (tmp_path / "spoilt" / PACKAGES / "photic/__init__.py").write_text("raise ImportError('spoilt')")
    done = subprocess.run(
        [tmp_path / "spoilt/usr/bin/photic", "plot", "out.nc", "-o", "out.png"],
        cwd=tmp_path, env=environment, capture_output=True, text=True, check=False,
    )
    assert done.returncode != 0 and "spoilt" in done.stderr


def test_python_finds_the_package_and_its_version(root, tmp_path, control):
    # -I: nothing but the interpreter's own path; the root's stands for /usr.
    script = (
        f"import sys; sys.path.insert(0, {str(root / PACKAGES)!r})\n"
        "import importlib.metadata, photic; print(photic.__file__, importlib.metadata.version('photic'))"
    )
    file, version = output_of("/usr/bin/python3", "-I", "-c", script, cwd=tmp_path).split()
    runs = script + "\nprint(photic.Scene.new('argo').run(photons=200).attrs['photons'], photic.__version__)"
    assert output_of("/usr/bin/python3", "-I", "-W", "ignore", "-c", runs, cwd=tmp_path).split()[2:] == ["200", version]
    assert file == str(root / PACKAGES / "photic/__init__.py")
    assert version == control["Version"]


def test_man_reads_its_manual(root):
    page = output_of("man", "-M", root / "usr/share/man", "photic", env={"PATH": "/usr/bin:/bin", "MANWIDTH": "80", "LC_ALL": "C.UTF-8"})
    assert page.startswith("PHOTIC(1)")
