#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""portable_test.py BUILD: whether the archive of tools/portable runs by itself, see README.md. Exit status 77: skipped."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
# What every desktop has, and has to have its own of: C library, drivers, display, fonts.
OF_THE_SYSTEM = re.compile(r"(ld-linux|lib(c|m|dl|rt|pthread|resolv|nss_\w+|GL|GLX|EGL|EGL_\w+|GLX_\w+|OpenGL|GLdispatch|gbm|drm\w*|"
                           r"X11|X11-xcb|xcb|xcb-\w+|fontconfig|wayland-\w+)[-.])")
failures = []


def check(good, what):
    print(("ok      " if good else "FAILED  ") + what)
    if not good:
        failures.append(what)


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=120, **options)


def loaded(log):
    """Libraries that a run of the loader's LD_DEBUG=libs has initialised."""
    return {line.split("calling init: ")[1].strip() for file in log.parent.glob(log.name + ".*") for line in file.read_text(errors="replace").splitlines()
            if "calling init:" in line}


def check_run(root, work, what, *words):
    home = work / "home"
    home.mkdir(exist_ok=True)
    log = work / f"{what}.log"
    done = run(*words, cwd=work, env={"PATH": "/nowhere", "HOME": str(home), "LC_ALL": "C.UTF-8", "XDG_RUNTIME_DIR": str(home),
                                      "QT_QPA_PLATFORM": "offscreen", "LIBGL_ALWAYS_SOFTWARE": "1", "LD_DEBUG": "libs",
                                      "LD_DEBUG_OUTPUT": str(log)})
    check(done.returncode == 0, f"{what} ends well {done.stderr[-300:] if done.returncode else ''}")
    libraries = loaded(log)
    # Drivers bring libraries of their own.
    drivers = any("_dri" in name or "libgallium" in name or "libEGL_" in name for name in libraries)
    own = [name for name in libraries if name.startswith(str(root))]
    others = [name for name in libraries - set(own) if not OF_THE_SYSTEM.match(os.path.basename(name))]
    check(len(own) > 5, f"{what} uses {len(own)} libraries of the archive")
    check(drivers or not others, f"{what} uses none of the system's but what each has {sorted(others)[:5]}")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("patchelf") or not (build / "isoscope").exists() or not (build / "isoscope-cli").exists():
        print("patchelf or the programs are missing: NOT TESTED")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        packed = run(SOURCE / "tools/portable", build, work)
        check(packed.returncode == 0, f"it is packed {packed.stderr[-300:]}")
        if packed.returncode == 0:
            archive = pathlib.Path(packed.stdout.strip().splitlines()[-1])
            with tarfile.open(archive) as tar:
                tar.extractall(work / "any where")
            root = next((work / "any where").iterdir())
            examples = root / "usr/share/isoscope/examples"
            check((root / "AppRun").resolve() == (root / "usr/bin/isoscope").resolve(), "AppRun is the window")
            for name in ("isoscope.desktop", "isoscope.svg"):
                check((root / name).exists(), f"an AppImage finds {name}")
            picture = work / "sphere.png"
            check_run(root, work, "picture", root / "usr/bin/isoscope-cli", "render", examples / "sphere.pov", "-o", picture,
                      "--width", "64", "--height", "48")
            check(picture.exists() and picture.read_bytes()[1:4] == b"PNG", "the command line draws a picture")
            window = work / "window.png"
            check_run(root, work, "window", root / "AppRun", "--screenshot", window, "--size", "900x600", examples / "heart.pov")
            check(window.exists() and window.stat().st_size > 20000, "the window opens an example")
    sys.exit(1 if failures else 0)


main()
