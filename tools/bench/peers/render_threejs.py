"""three.js in headless Chromium. One point light, no shadows. The GL of Chromium is written beside the picture."""
import json
import os
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import urllib.parse
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from view import view

TYPES = {".html": "text/html", ".js": "text/javascript", ".glb": "model/gltf-binary"}
GRACE_S = 300  # a page that answers nothing for so long has died
v = view()
answers = queue.Queue()


class Handler(BaseHTTPRequestHandler):
    """Serves the page, the package of `STERADIAN_THREE` and the scene; takes the picture."""

    def send(self, data, kind):
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def do_GET(self):
        path = urllib.parse.urlparse(self.path).path
        if path == "/view":
            return self.send(json.dumps(vars(v)).encode(), "application/json")
        package = Path(os.environ["STERADIAN_THREE"]).resolve()
        file = {"/": Path(__file__).with_name("threejs.html"), "/scene.glb": Path(v.scene)}.get(path)
        if file is None and path.startswith("/three/"):
            inside = (package / path.removeprefix("/three/")).resolve()
            file = inside if inside.is_relative_to(package) else None
        if file is None or not file.is_file():
            return self.send_error(404)
        self.send(file.read_bytes(), TYPES.get(file.suffix, "application/octet-stream"))

    def do_POST(self):
        data = self.rfile.read(int(self.headers["Content-Length"]))
        self.send(b"", "text/plain")
        where = urllib.parse.urlparse(self.path)
        answers.put((where.path, urllib.parse.unquote(where.query), data))

    def log_message(self, *_):
        pass


def main() -> int:
    browser = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
    if not browser:
        print("no Chromium: install the package chromium", file=sys.stderr)
        return 3
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        process = subprocess.Popen(
            [browser, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", f"--user-data-dir={profile}", "--ignore-gpu-blocklist",
             f"--use-angle={os.environ.get('STERADIAN_ANGLE', 'swiftshader')}", "--enable-unsafe-swiftshader", "--no-first-run",
             f"http://127.0.0.1:{server.server_port}/"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            what, driver, data = answers.get(timeout=GRACE_S)
        except queue.Empty:
            what, driver, data = "/error", "", b"no picture within five minutes"
        finally:
            process.terminate()
            process.wait()
    if what != "/picture":
        print(data.decode(errors="replace"), file=sys.stderr)
        return 3
    Path(v.output).write_bytes(data)
    Path(v.output).with_suffix(".driver").write_text(driver)
    return 0


if __name__ == "__main__":
    sys.exit(main())
