"""A running `hyalite live` for tests: on a free port, with its own copies of scene and shaders folder, which tests may change."""

import http.client
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import urllib.parse

# Small enough to be refined within a second, large enough for a first preview at lower resolution.
SIDE = 144
PASSES = 6
SETTINGS = (f"camera.resolution={SIDE}x{SIDE}", "render.photons=8000", "render.caustic_photons=3000", f"render.passes={PASSES}")


class LiveServer:
    def __init__(self, program, source, folder, *options, scene="cornell-caustics.yaml", settings=SETTINGS):
        self.shaders = folder / "shaders"
        self.scene = folder / pathname(scene)
        if not self.shaders.exists():
            shutil.copytree(source / "shaders", self.shaders)
        shutil.copy(source / "scenes" / scene, self.scene)
        for code in (source / "scenes" / scene).parent.glob("*.glsl"):
            shutil.copy(code, folder)
        command = [program, "live", self.scene, "--port", "0", "--shaders", self.shaders, *options]
        if "HYALITE_VALIDATION" in os.environ:
            command.append("--validation")
        for setting in settings:
            command += ["--set", setting]
        environment = {**os.environ, "XDG_CACHE_HOME": str(folder / "cache")}
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment)
        self.lines = []
        self.first_line = threading.Event()
        threading.Thread(target=self._read, daemon=True).start()
        assert self.first_line.wait(60), "no address was printed"
        self.url = re.search(r"http://\S+", self.lines[0])[0]
        self.port = int(re.search(r":(\d+)/", self.url)[1])
        self.host = urllib.parse.urlsplit(self.url).hostname
        if self.host == "0.0.0.0":
            self.host = "127.0.0.1"

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))
            self.first_line.set()
        self.first_line.set()

    def stop(self):
        """Ends it as Ctrl-C does; returns its exit code."""
        self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(30)
        finally:
            self.process.kill()
            self.process.wait()
            self.process.stdout.close()
            complaints = [line for line in self.lines if "VUID" in line or "validation" in line.lower()]
            assert not complaints, complaints[:5]

    def request(self, method, path, body=None, headers=None, host=None):
        """Status and content of a response."""
        connection = http.client.HTTPConnection(host or self.host, self.port, timeout=60)
        given = {"Content-Type": "application/json"} if body is not None else {}
        try:
            connection.request(method, path, body if body is None else json.dumps(body), {**given, **(headers or {})})
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def state(self, seen=0):
        return json.loads(self.request("GET", f"/api/state?seen={seen}")[1])

    def wait_for(self, condition, patience=60):
        """The first state that satisfies the condition."""
        end = time.monotonic() + patience
        state = self.state()
        while not condition(state):
            assert time.monotonic() < end, f"not within {patience} s; last: {json.dumps(state)[:2000]}; said: {self.lines[-5:]}"
            state = self.state(state["version"])
        return state

    def wait_for_picture(self, passes=1, revision=0, newer_than=0, patience=60):
        def arrived(state):
            picture = state["picture"]
            return (picture is not None and not picture["preview"] and picture["passes"] >= passes
                    and picture["revision"] >= revision and picture["id"] > newer_than)
        return self.wait_for(arrived, patience)

    def pixels(self):
        return self.request("GET", "/api/picture?layer=picture")[1]


def pathname(scene):
    return scene.rsplit("/", 1)[-1]


def replace(path, old, new):
    """Edits a file as an editor does; the old text must occur in it."""
    text = path.read_text()
    assert old in text, (path, old)
    save(path, text.replace(old, new))


def save(path, text):
    """Replaces a file as a whole: written in place, it would be seen empty for a moment."""
    with tempfile.NamedTemporaryFile("w", delete=False) as temporary:
        temporary.write(text)
    shutil.move(temporary.name, path)
