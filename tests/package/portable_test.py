#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""portable_test.py BUILD: whether the archive and the AppImage of tools/portable run by themselves, see README.md. Exit status 77:
skipped."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time

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


def check_appimage(image, archive_root, work):
    """The same files as in the archive, unpacked, in the cache, and mounted where this machine can."""
    head = image.read_bytes()[:16]
    check(head[:4] == b"\x7fELF" and head[8:11] == b"AI\x02", "the AppImage has the marks of type 2")
    offset = int(run(image, "--appimage-offset").stdout)
    with open(image, "rb") as file:
        file.seek(offset)
        check(file.read(4) == b"hsqs", "a squashfs image is behind its runtime")
    check(run("ldd", image).returncode != 0, "the runtime needs no library")
    unpacked = work / "unpacked"
    unpacked.mkdir()
    check(run(image, "--appimage-extract", cwd=unpacked).returncode == 0, "--appimage-extract ends well")
    same = run("diff", "-r", "--no-dereference", archive_root, unpacked / "squashfs-root")
    check(same.returncode == 0, f"it unpacks what is in the archive {same.stdout[:300]}")
    programs = [path for path in archive_root.rglob("*") if path.is_file() and not path.is_symlink() and path.stat().st_mode & 0o100]
    check(all((unpacked / "squashfs-root" / path.relative_to(archive_root)).stat().st_mode & 0o100 for path in programs),
          "programs stay programs")

    cache = work / "cache"
    base = {"PATH": os.environ["PATH"], "HOME": str(work / "home"), "XDG_CACHE_HOME": str(cache), "TMPDIR": str(work), "LC_ALL": "C.UTF-8",
            "QT_QPA_PLATFORM": "offscreen", "LIBGL_ALWAYS_SOFTWARE": "1", "XDG_RUNTIME_DIR": str(work / "home")}
    window = work / "appimage.png"
    done = run(image, "--screenshot", window, "--size", "900x600", archive_root / "usr/share/isoscope/examples/heart.pov",
               cwd=work, env={**base, "APPIMAGE_EXTRACT_AND_RUN": "1"})
    check(done.returncode == 0 and window.exists(), f"without FUSE the window opens an example {done.stderr[-300:]}")
    trees = list((cache / "isoscope").glob("appimage-*"))
    check(len(trees) == 1, "it is unpacked into the cache")
    link = work / "isoscope-cli"
    link.symlink_to(image)
    marks = {path: path.stat().st_mtime_ns for path in trees[0].rglob("*")} if trees else {}
    done = run(link, "--appimage-extract-and-run", "evaluate", "--help", cwd=work, env=base)
    check(done.returncode == 0 and "evaluate" in done.stdout, "by the name of the command line it is that")
    check(all(path.stat().st_mtime_ns == mark for path, mark in marks.items()), "the second time nothing is unpacked")
    done = run(link, "check", "nothing.pov", cwd=work, env=base)
    check(done.returncode == 1 and "nothing.pov" in done.stderr, "the exit status is the program's")

    if not os.access("/dev/fuse", os.W_OK) or not (os.geteuid() == 0 or shutil.which("fusermount3")):
        print("this machine has no FUSE: mounting is NOT TESTED")
        return
    shutil.rmtree(cache)
    done = run(link, "--version", cwd=work, env=base)
    check(done.returncode == 0 and not cache.exists(), "with FUSE nothing is unpacked")
    for _ in range(100):
        if not list(work.glob(".mount_*")):
            break
        time.sleep(0.1)
    check(not list(work.glob(".mount_*")), "the folder that it was mounted on is gone")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("patchelf") or not shutil.which("mksquashfs") or not (build / "isoscope").exists() or not (build / "isoscope-cli").exists():
        print("patchelf, mksquashfs or the programs are missing: NOT TESTED")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        packed = run(SOURCE / "tools/portable", build, work)
        check(packed.returncode == 0, f"it is packed {packed.stderr[-300:]}")
        if packed.returncode == 0:
            archive, image = (pathlib.Path(line) for line in packed.stdout.strip().splitlines()[-2:])
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
            check_appimage(image, root, work)
    sys.exit(1 if failures else 0)


main()
