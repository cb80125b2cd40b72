#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""package_test.py BUILD: whether the Debian package is what it should be, see README.md. Exit status 77: skipped."""
import gzip
import hashlib
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PICTURE_BEGINS = b"\x89PNG\r\n\x1a\n"
# Each is explained in place of being mended.
ACCEPTED_TAGS = {
    "initial-upload-closes-no-bugs",  # of packages for Debian's own archive
}
failures = []


def check(good, what):
    print(("ok      " if good else "FAILED  ") + what)
    if not good:
        failures.append(what)


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=120, **options)


def pack(build, folder, epoch):
    environment = {**os.environ, "SOURCE_DATE_EPOCH": str(epoch)}
    done = run(SOURCE / "tools/package", build, folder, env=environment)
    if done.returncode != 0:
        sys.exit(f"tools/package fails:\n{done.stdout}{done.stderr}")
    return pathlib.Path(done.stdout.strip().splitlines()[-1])


def files_below(root):
    return sorted(str(path.relative_to(root)) for path in root.rglob("*"))


def check_bytes(build, work):
    """Packs twice; between the two, files of the build get another time."""
    first = pack(build, work / "first", 1700000000)
    for page in (build / "package").glob("*.gz"):
        os.utime(page)
    second = pack(build, work / "second", 1700000000)
    digests = [hashlib.sha256(package.read_bytes()).hexdigest() for package in (first, second)]
    check(digests[0] == digests[1], f"two packages have the same bytes ({digests[0][:16]})")
    other = pack(build, work / "other", 1700000001)
    check(other.read_bytes() != first.read_bytes(), "another date makes other bytes")
    return first


def check_documents(root):
    share = root / "usr/share"
    for program in ("isoscope", "isoscope-cli"):
        page = share / f"man/man1/{program}.1.gz"
        text = gzip.open(page, "rt").read() if page.exists() else ""
        check(".SH SYNOPSIS" in text and text.startswith(".TH"), f"manual page of {program}")
        spoken = run(root / "usr/bin" / program, "--help").stdout
        options = [word.strip(",[]") for word in spoken.split() if word.startswith("--")]
        check(options and all(option.replace("-", "\\-") in text for option in options if option not in ("--help-all", "--version")),
              f"every option of {program} --help stands in it: {' '.join(options)}")
        if shutil.which("man"):
            told = run("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page,
                       env={**os.environ, "LC_ALL": "C.UTF-8", "MANROFFSEQ": ""})
            check(told.returncode == 0 and not told.stderr, f"groff has nothing to say about it {told.stderr[:200]}")
    for document in ("copyright", "changelog.gz", "NEWS.gz"):
        check((share / "doc/isoscope" / document).exists(), f"document {document}")


def check_desktop(root, work):
    share = root / "usr/share"
    if shutil.which("desktop-file-validate"):
        told = run("desktop-file-validate", share / "applications/isoscope.desktop")
        check(told.returncode == 0 and not told.stdout, f"desktop file is valid {told.stdout}")
    if shutil.which("appstreamcli"):
        told = run("appstreamcli", "validate", "--no-net", share / "metainfo/org.example.Isoscope.metainfo.xml")
        check(told.returncode == 0, f"AppStream data is valid {told.stdout if told.returncode else ''}")
    if shutil.which("update-mime-database"):
        mime = work / "mime"
        (mime / "packages").mkdir(parents=True)
        shutil.copy(share / "mime/packages/isoscope.xml", mime / "packages")
        run("update-mime-database", mime)
        globs = (mime / "globs").read_text()
        for line in ("text/x-povray:*.pov", "text/x-virtualight:*.vl"):
            check(line in globs, f"the desktop knows {line}")


def check_dependencies(package, root):
    depends = run("dpkg-deb", "-f", package, "Depends").stdout
    for name in ("libqt6widgets6", "libqt6gui6", "libqscintilla2-qt6-15", "libvtk9.1", "libtbb12", "libc6",
                 "libqt6svg6", "fonts-dejavu-core"):
        check(name in depends, f"depends on {name}")
    for program in ("isoscope", "isoscope-cli"):
        missing = [line for line in run("ldd", root / "usr/bin" / program).stdout.splitlines() if "not found" in line]
        check(not missing, f"{program} finds its libraries {missing}")


def check_programs(root, work):
    binaries, examples = root / "usr/bin", root / "usr/share/isoscope/examples"
    home = work / "home"
    home.mkdir()
    environment = {"PATH": f"{binaries}:/usr/bin:/bin", "HOME": str(home), "LC_ALL": "C.UTF-8",
                   "QT_QPA_PLATFORM": "offscreen", "LIBGL_ALWAYS_SOFTWARE": "1", "XDG_RUNTIME_DIR": str(home)}
    entry = (root / "usr/share/thumbnailers/isoscope.thumbnailer").read_text()
    command = next(line for line in entry.splitlines() if line.startswith("Exec="))[5:]
    for scene in ("sphere.pov", "virtualight_surfaces.vl"):
        picture = work / f"{scene}.png"
        picture.touch()  # as file managers do
        words = [{"%i": str(examples / scene), "%o": str(picture), "%s": "128"}.get(word, word)
                 for word in shlex.split(command)]
        done = run(*words, env=environment)
        check(done.returncode == 0 and picture.read_bytes().startswith(PICTURE_BEGINS),
              f"thumbnail of {scene} {done.stderr[:200]}")
    window = work / "window.png"
    done = run(binaries / "isoscope", "--screenshot", window, "--size", "900x600", examples / "heart.pov",
               env=environment)
    check(done.returncode == 0 and window.exists() and window.stat().st_size > 20000,
          f"the window opens an example {done.stderr[:300]}")


def check_lintian(package):
    if not shutil.which("lintian"):
        return
    told = run("lintian", "--allow-root", "--tag-display-limit", "0", package)
    tags = [line for line in told.stdout.splitlines() if line[:2] in ("E:", "W:")]
    tags = [line for line in tags if line.split(": ")[2].split()[0] not in ACCEPTED_TAGS]
    check(not tags, "lintian has neither errors nor warnings" + "".join("\n        " + tag for tag in tags))


def dpkg(root, *words):
    return run("dpkg", f"--root={root}", "--force-not-root", "--force-depends", "--force-bad-path",
               f"--log={root}/dpkg.log", *words)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("dpkg-shlibdeps") or not (build / "package/isoscope.1.gz").exists():
        print("dpkg-dev or the manual pages are missing: NOT TESTED")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        package = check_bytes(build, work)
        root = work / "root"
        for part in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "var/lib/dpkg/triggers"):
            (root / part).mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        done = dpkg(root, "--install", package)
        check(done.returncode == 0, f"dpkg installs it {done.stderr[-300:] if done.returncode else ''}")
        check_documents(root)
        check_desktop(root, work)
        check_dependencies(package, root)
        check_programs(root, work)
        check_lintian(package)
        done = dpkg(root, "--purge", "isoscope")
        check(done.returncode == 0, f"dpkg removes it {done.stderr[-300:] if done.returncode else ''}")
        left = [name for name in files_below(root) if not name.startswith("var") and name != "dpkg.log"]
        left += [name for name in files_below(root) if "isoscope" in name]
        check(not left, f"nothing is left {left[:5]}")
    sys.exit(1 if failures else 0)


main()
