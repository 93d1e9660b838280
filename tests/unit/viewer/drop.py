"""A source of drag and drop under X11: what a file manager does, by the letter of XDND version 5 (freedesktop.org)."""
import select
import time

from Xlib import X, Xatom, display
from Xlib.protocol import event

VERSION = 5


def drop(name: str, window: int, files, timeout: float = 240.0):
    """Drops files in the middle of a window of the display `name`; returns when the window says that it has taken them."""
    connection = display.Display(name)
    try:
        source = connection.screen().root.create_window(-10, -10, 1, 1, 0, X.CopyFromParent)
        target = connection.create_resource_object("window", window)
        Source(connection, source, target, files).run(time.monotonic() + timeout)
    finally:
        connection.close()


class Source:
    def __init__(self, connection, source, target, files):
        self.connection, self.source, self.target = connection, source, target
        self.uris = "".join(file.resolve().as_uri() + "\r\n" for file in files).encode()
        self.type = self.atom("text/uri-list")

    def atom(self, name: str) -> int:
        return self.connection.intern_atom(name)

    def send(self, name: str, *data):
        numbers = [self.source.id, *data, 0, 0, 0, 0][:5]
        self.target.send_event(event.ClientMessage(window=self.target, client_type=self.atom(name), data=(32, numbers)))
        self.connection.flush()

    def run(self, end: float):
        version = self.target.get_full_property(self.atom("XdndAware"), Xatom.ATOM)
        assert version and version.value[0] >= VERSION, "the window takes no drops"
        self.source.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        geometry = self.target.get_geometry()
        middle = self.target.translate_coords(self.connection.screen().root, 0, 0)
        x, y = geometry.width // 2 - middle.x, geometry.height // 2 - middle.y
        self.send("XdndEnter", VERSION << 24, self.type)
        self.send("XdndPosition", 0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy"))
        while True:
            happened = self.next_event(end)
            if happened.type == X.SelectionRequest:
                self.answer(happened)
            elif happened.type == X.ClientMessage and happened.client_type == self.atom("XdndStatus"):
                assert happened.data[1][1] & 1, "the window refuses the drop"
                self.send("XdndDrop", 0, X.CurrentTime)
            elif happened.type == X.ClientMessage and happened.client_type == self.atom("XdndFinished"):
                # A flag by the letter; GLFW writes how many bytes it has read.
                assert happened.data[1][1], "the window did not take the drop"
                return

    def next_event(self, end: float):
        while not self.connection.pending_events():
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.connection], [], [], left)[0]:
                raise AssertionError("the window does not answer a drop")
        return self.connection.next_event()

    def answer(self, request):
        request.requestor.change_property(request.property, self.type, 8, self.uris)
        request.requestor.send_event(event.SelectionNotify(
            time=request.time, requestor=request.requestor, selection=request.selection, target=request.target,
            property=request.property))
        self.connection.flush()
