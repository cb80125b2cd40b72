#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""screen_reader_test.py PROGRAM SCENE: what a screen reader learns of the running window, asked through AT-SPI.

Runs inside `dbus-run-session`, with a display. Status 77: no AT-SPI on this machine.
"""
import os
import subprocess
import sys
import tempfile
import time
import warnings

try:
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError):
    print("skipped: no AT-SPI for Python")
    sys.exit(77)

warnings.simplefilter("ignore")  # names of AT-SPI that are older than its others
PATIENCE = 90  # seconds


def pump():
    context = GLib.MainContext.default()
    while context.pending():
        context.iteration(False)
    time.sleep(0.05)


def wait_for(what, find):
    """What `find` finds; ends the test when it finds nothing for too long."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        pump()
        try:
            found = find()
        except GLib.Error:  # the tree changed meanwhile
            found = None
        if found:
            return found
    sys.exit(f"FAIL: {what}")


def walk(node, depth=0):
    if node is None or depth > 40:
        return
    yield node
    for index in range(node.get_child_count()):
        yield from walk(node.get_child_at_index(index), depth + 1)


def application():
    desktop = Atspi.get_desktop(0)
    for index in range(desktop.get_child_count()):
        child = desktop.get_child_at_index(index)
        if child is not None and child.get_name() == "isoscope":
            return child
    return None


def labelled(root, description):
    """The text of the label that is described so."""
    for node in walk(root):
        if node.get_role() == Atspi.Role.LABEL and node.get_description() == description:
            return node
    return None


def main():
    program, scene = sys.argv[1:3]
    if not Atspi.init() in (0, 1):
        print("skipped: AT-SPI does not start")
        return 77
    home = tempfile.mkdtemp()
    environment = dict(os.environ, QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", LIBGL_ALWAYS_SOFTWARE="1", LC_ALL="C.UTF-8",
                       HOME=home, XDG_CONFIG_HOME=home, XDG_DATA_HOME=home, XDG_CACHE_HOME=home)
    process = subprocess.Popen([program, scene], env=environment)
    try:
        return ask(wait_for("the program appears", application))
    finally:
        process.terminate()
        process.wait(20)


def ask(root):
    changes = []

    def changed(event):
        if event.source is not None:
            changes.append((event.source.get_description(), event.source.get_name()))

    listener = Atspi.EventListener.new(changed)
    listener.register("object:property-change:accessible-name")

    # The status line: its text is its name, what it stands for its description.
    state = wait_for("the state of the picture is read", lambda: labelled(root, "State of the picture"))
    wait_for("it says that the picture is finished", lambda: state.get_name().startswith("Finished"))
    caret = wait_for("the place of the caret is read", lambda: labelled(root, "Place of the caret"))
    wait_for("the caret is in a line", lambda: caret.get_name().startswith("Line "))

    # Every slider has a name and a value.
    sliders = [node for node in walk(root) if node.get_role() == Atspi.Role.SLIDER]
    assert len(sliders) >= 5, len(sliders)
    for slider in sliders:
        assert slider.get_name(), "a slider without a name"
        assert slider.get_value_iface() is not None, slider.get_name()

    # The tabs are there, and can be pressed; the rows of Gradient tell their values.
    tab = wait_for("the tab Gradient", lambda: next((node for node in walk(root) if node.get_role() ==
                                                    Atspi.Role.PAGE_TAB and node.get_name() == "Gradient"), None))
    tab.get_action_iface().do_action(0)
    for row in ("max_gradient", "Holes", "Along rays", "On the surface", "Proven", "Suggested", "This view"):
        value = wait_for(f"the row {row}", lambda: labelled(root, row))
        wait_for(f"the value of {row}", lambda: any(c.isdigit() for c in value.get_name()))
        print(f"{row}: {value.get_name()}")

    # A change of a number is announced: the picture begins anew, and so does the measurement.
    radius = next(slider for slider in sliders if "Radius" in slider.get_name())
    interface = radius.get_value_iface()
    # Some of the pictures take as long as the one before, to the digits that are read.
    for _ in range(10):
        changes.clear()
        before = interface.get_current_value()
        interface.set_current_value(before + 2)
        wait_for("the slider moves", lambda: interface.get_current_value() != before)
        wait_for("the finished picture is announced",
                 lambda: any(what == "State of the picture" and text.startswith("Finished") for what, text in changes))
    wait_for("the new values of Gradient are announced", lambda: any(what == "Along rays" for what, _ in changes))
    print(f"{len(sliders)} sliders, {len(changes)} changes announced")
    return 0


if __name__ == "__main__":
    sys.exit(main())
