"""Tests `hyalite live`: its page in a browser, and its server without one: PROGRAM SOURCE [SCREENSHOTS]."""

import http.client
import json
import pathlib
import struct
import sys
import tempfile
import time
import unittest

from browser import console_complaints, open_browser
from live_server import PASSES, SIDE, LiveServer, replace, save
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

PROGRAM, SOURCE = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
SCREENSHOTS = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None

LIMIT = "4"  # [s] for a kernel; the driver compiles the slowest one within a second


class Live(unittest.TestCase):
    options = ("--edit", "--limit", LIMIT)
    scene = "cornell-caustics.yaml"

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.server = LiveServer(PROGRAM, SOURCE, cls.folder, *cls.options, scene=cls.scene)
        cls.addClassCleanup(cls.end)
        cls.server.wait_for_picture(patience=120)

    @classmethod
    def end(cls):
        assert cls.server.stop() == 0, "Ctrl-C does not end it as it should"

    def shader(self, name):
        """Restores the file after the test, and waits until the picture shows it again."""
        path = self.server.shaders / name
        text = path.read_text()

        def restore():
            if path.read_text() != text:
                changes = self.server.state()["changes"]
                save(path, text)
                self.server.wait_for(lambda state: state["changes"] > changes and not state["busy"] and not state["errors"])
        self.addCleanup(restore)
        return path

    def picture_after(self, change, **wanted):
        """Makes a change; returns the state of the first full picture that shows it."""
        before = self.server.state()["picture"]["id"]
        change()
        return self.server.wait_for_picture(newer_than=before, **wanted)


class Page(Live):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = open_browser(1440, 900)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get(cls.server.url)

    def setUp(self):
        # The server may have rendered the files that the last test restored before the page shows them
        state = self.server.wait_for(lambda state: not state["busy"])
        self.wait(lambda: self.number("id") == state["picture"]["id"])

    def tearDown(self):
        self.assertEqual(console_complaints(self.browser), [])

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def wait(self, condition, patience=60):
        """What the condition returns once it is true; it is asked again where the page replaced an element meanwhile."""
        stale = (StaleElementReferenceException,)
        return WebDriverWait(self.browser, patience, poll_frequency=0.05, ignored_exceptions=stale).until(lambda _: condition())

    def canvas(self):
        return self.find("#picture")

    def number(self, name):
        return int(self.canvas().get_attribute("data-" + name) or -1)

    def drawn(self):
        """The pixels of the canvas."""
        return self.browser.execute_script("return document.getElementById('picture').toDataURL()")

    def screenshot(self, name):
        if SCREENSHOTS:
            self.browser.save_screenshot(str(SCREENSHOTS / f"{name}.png"))

    def test_the_picture_is_refined_to_the_last_pass(self):
        self.wait(lambda: self.number("passes") == PASSES)
        self.assertIn(f"pass {PASSES} of {PASSES}", self.find("#status").text)
        self.screenshot("wide")

    def test_a_drag_turns_the_camera_and_the_key_0_turns_it_back(self):
        self.wait(lambda: self.number("passes") == PASSES)
        before, revision = self.drawn(), self.number("revision")
        ActionChains(self.browser).drag_and_drop_by_offset(self.canvas(), 60, 25).perform()
        self.wait(lambda: self.number("revision") > revision and self.drawn() != before)
        # Orbiting keeps the distance from look_at: 3.9 m in this scene
        camera = self.server.state()["scene"]["camera"]
        distance = sum((a - b) ** 2 for a, b in zip(camera["position"], camera["look_at"])) ** 0.5
        self.assertAlmostEqual(distance, 3.9, places=6)
        self.assertNotEqual(camera["position"], [0, 0, 3.9])
        self.canvas().send_keys("0")
        self.wait(lambda: self.number("passes") == PASSES and self.drawn() == before)

    def test_a_shader_that_is_saved_changes_the_picture(self):
        self.wait(lambda: self.number("passes") == PASSES)
        before = self.drawn()
        replace(self.shader("kernels/resolve_film.comp"), "args.scale", "0.5 * args.scale")
        self.wait(lambda: self.drawn() != before and self.number("passes") == PASSES)

    def test_a_shader_with_a_mistake_shows_its_place_and_the_picture_stays(self):
        self.wait(lambda: self.number("passes") == PASSES)
        before = self.drawn()
        number = self.canvas().get_attribute("data-id")
        path = self.shader("bsdf/diffuse.glsl")
        save(path, path.read_text() + "float oops() { return missing; }\n")
        line = len(path.read_text().splitlines())
        card = self.wait(lambda: [card.text for card in self.browser.find_elements(By.CSS_SELECTOR, ".error")])[0]
        for part in ("'gather_radiance'", "missing", f"shaders/bsdf/diffuse.glsl:{line}", "float oops"):
            self.assertIn(part, card)
        time.sleep(1)
        self.assertEqual((self.canvas().get_attribute("data-id"), self.drawn()), (number, before))
        self.screenshot("mistake")
        # Clicking the place opens the file there, with the error in its margin
        self.find(".error .place").click()
        self.wait(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#editor .problem"))
        self.assertEqual(self.find("#file").get_attribute("value"), "shaders/bsdf/diffuse.glsl")
        # One mistake, however many kernels include the file
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".error")), 1)
        self.screenshot("mistake-editor")

    def test_a_click_shows_the_path_of_the_pixel_on_both_sides(self):
        ActionChains(self.browser).move_to_element_with_offset(self.canvas(), 0, 60).click().perform()
        self.wait(lambda: self.find("#path-title").text.endswith("vertex by vertex"))
        text = self.find("#path").text
        self.assertRegex(text, r"(?s)Vertex 1.*object \d+, \w+, front.*ends on a diffuse surface")
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, "#path .vertex th")) % 3, 0)
        self.screenshot("path")

    def test_views_and_layers_can_be_chosen(self):
        self.wait(lambda: self.number("passes") == PASSES)
        before = self.drawn()
        Select(self.find("#layer")).select_by_value("caustic")
        self.wait(lambda: self.drawn() != before)
        Select(self.find("#layer")).select_by_value("picture")
        self.wait(lambda: self.drawn() == before)
        for view in ("normals", "depth", "bounces", "photons", "radius"):
            revision, last = self.number("revision"), self.drawn()
            Select(self.find("#shown")).select_by_value(view)
            self.wait(lambda: self.number("revision") > revision and self.canvas().get_attribute("data-preview") == "false")
            self.wait(lambda: self.drawn() != last)
            self.screenshot("view-" + view)
        Select(self.find("#shown")).select_by_value("picture")
        self.wait(lambda: self.number("passes") == PASSES and self.drawn() == before)

    def test_settings_change_the_picture_and_refused_ones_say_why(self):
        self.find("#open-settings").click()
        field = self.find("[id='render.max_depth']")
        field.send_keys(Keys.CONTROL, "a")
        field.send_keys("999", Keys.TAB)
        self.wait(lambda: "'max_depth' must be" in self.find("#errors").text)
        self.find("#reset-all").click()
        self.wait(lambda: self.find("#errors").text == "")
        Select(self.find("[id='render.integrator']")).select_by_value("whitted")
        self.wait(lambda: self.server.state()["scene"]["settings"]["render.integrator"] == "whitted")
        self.find("#reset-all").click()
        self.wait(lambda: self.server.state()["scene"]["settings"]["render.integrator"] == "ppm")

    def test_the_editor_saves_and_prints_appear(self):
        path = self.shader("kernels/generate_camera_rays.comp")
        self.find("#open-editor").click()
        self.wait(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#editor .CodeMirror, #editor textarea.plain"))
        self.wait(lambda: len(Select(self.find("#file")).options) > 40)
        Select(self.find("#file")).select_by_value("shaders/kernels/generate_camera_rays.comp")
        self.wait(lambda: "generate_camera_rays" in self.find("#file").get_attribute("value"))
        time.sleep(0.3)
        wanted = path.read_text().replace('#include "lib/thread.glsl"', '#include "lib/thread.glsl"\n#include "lib/debug.glsl"')
        start = "        NextRay start ="
        wanted = wanted.replace(start, "        if (pixel == 5u) {\n            debugPrint(args.camera.position);\n        }\n" + start)
        self.browser.execute_script("document.querySelector('#editor .CodeMirror').CodeMirror.setValue(arguments[0])", wanted)
        self.find("#save").click()
        self.wait(lambda: path.read_text() == wanted)
        line = 1 + wanted[: wanted.index("debugPrint(args.camera")].count("\n")
        # The thread's number is the pixel's; the camera stands at (0, 0, 3.9)
        printed = f"generate_camera_rays:{line} thread 5: 0 0 3.9"
        self.wait(lambda: self.server.state()["prints"])
        self.assertEqual(self.server.state()["prints"][0], printed)
        self.find("#open-prints").click()
        self.wait(lambda: printed in self.find("#prints").text)
        self.assertIn(printed, self.server.lines)
        self.screenshot("prints")

    def test_no_width_needs_sideways_scrolling(self):
        self.addCleanup(self.browser.set_window_size, 1440, 900)
        for width, height in ((500, 900), (1920, 1080)):
            self.browser.set_window_size(width, height)
            for tab in ("settings", "stages", "path", "editor"):
                self.find(f"#open-{tab}").click()
                wide, window = self.browser.execute_script("return [document.documentElement.scrollWidth, window.innerWidth]")
                self.assertLessEqual(wide, window, (width, tab))
            self.find("#open-settings").click()
            time.sleep(0.3)
            self.screenshot(f"width-{width}")


class Failures(Live):
    """Errors in kernels and in the scene; without a browser."""

    def stops(self, edit):
        """The server's message for a kernel broken in this way."""
        edit()
        state = self.server.wait_for(lambda s: any(e["source"] == "worker" for e in s["errors"]))
        # Rendering continues with the last good version
        self.server.wait_for_picture(newer_than=state["picture"]["id"], passes=PASSES)
        return next(e for e in state["errors"] if e["source"] == "worker")

    def test_a_kernel_that_never_ends_is_stopped_and_named(self):
        self.server.wait_for_picture(passes=PASSES)
        before = self.server.pixels()
        path = self.shader("kernels/sample_lights.comp")
        # A loop with an effect: drivers optimise others away
        loop = "    while (args.shadowRays.at[i].tMax >= 0.0) {\n        args.shadowRays.at[i].tMax += 1.0;\n    }\n"
        said = self.stops(lambda: replace(path, "    args.shadowRays.at[i].tMax = 0.0;\n", "    args.shadowRays.at[i].tMax = 0.0;\n" + loop))
        self.assertEqual(said["kernel"], "sample_lights")
        self.assertIn(f"kernel 'sample_lights' did not end within {LIMIT} s", said["message"])
        self.assertEqual(self.server.pixels(), before)
        self.assertTrue(any("sample_lights" in line for line in self.server.lines))

    def test_a_kernel_that_writes_out_of_bounds_is_survived(self):
        self.server.wait_for_picture(passes=PASSES)
        before = self.server.pixels()
        path = self.shader("kernels/accumulate_film.comp")
        said = self.stops(lambda: replace(path, "args.film.at[", "args.film.at[0x10000000u * 12u + "))
        self.assertIn("accumulate_film", said["kernel"])
        self.assertIn("crashed", said["message"])
        self.assertEqual(self.server.pixels(), before)

    def test_a_scene_with_a_mistake_keeps_the_former_one(self):
        text = self.server.scene.read_text()
        self.addCleanup(self.server.scene.write_text, text)
        before = self.server.wait_for_picture(passes=PASSES)["picture"]["id"]
        self.server.scene.write_text(text.replace("radius: 0.33", "raduis: 0.33"))
        error = self.server.wait_for(lambda s: s["errors"])["errors"][0]
        self.assertEqual((error["source"], error["name"]), ("scene", "scene/cornell-caustics.yaml"))
        self.assertIn("raduis", error["message"])
        self.assertGreater(error["line"], 0)
        self.server.scene.write_text(text)
        self.server.wait_for(lambda s: not s["errors"] and s["picture"]["id"] > before)

    def test_first_pixels_and_reloads_are_fast(self):
        # Required times, with a margin for a busy machine: docs/live.md has the measured ones
        self.server.wait_for_picture(passes=2)
        for angle in range(3):
            revision = self.server.state()["revision"]
            self.server.request("POST", "/api/change", {"settings": {"camera.position": f"[{0.1 * angle}, 0.2, 3.9]"}})
            state = self.server.wait_for(lambda s: s["picture"]["revision"] > revision)
        self.assertLess(state["first_pixel_seconds"], 1.5)
        path = self.shader("kernels/resolve_film.comp")
        before = state["picture"]["id"]
        start = time.monotonic()
        replace(path, "args.scale", "0.5 * args.scale")
        self.server.wait_for(lambda s: s["reload_seconds"] > 0 and s["picture"]["id"] > before)
        self.assertLess(time.monotonic() - start, 5)


class DeviceTimeout(Live):
    """The worker ends by itself when the device takes too long; --limit would stop it only after the test."""
    options = ("--limit", "1000", "--device-timeout", "3")

    def test_a_kernel_that_exceeds_the_device_timeout_is_named(self):
        self.server.wait_for_picture(passes=PASSES)
        loop = "    while (args.shadowRays.at[i].tMax >= 0.0) {\n        args.shadowRays.at[i].tMax += 1.0;\n    }\n"
        path = self.shader("kernels/sample_lights.comp")
        replace(path, "    args.shadowRays.at[i].tMax = 0.0;\n", "    args.shadowRays.at[i].tMax = 0.0;\n" + loop)
        state = self.server.wait_for(lambda s: any(e["source"] == "worker" for e in s["errors"]))
        said = next(e for e in state["errors"] if e["source"] == "worker")
        self.assertEqual(said["kernel"], "sample_lights")
        self.assertIn("--device-timeout", said["message"])


class Polls(Live):
    options = ()

    def test_more_pages_than_threads_leave_the_server_an_answer_for_others(self):
        state = self.server.wait_for(lambda s: not s["busy"])
        # Long polls, more than the server's 24 threads, while nothing changes
        pages = [http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=60) for _ in range(40)]
        for page in pages:
            self.addCleanup(page.close)
            page.request("GET", f"/api/state?seen={state['version']}")
        start = time.monotonic()
        self.assertEqual(self.server.request("GET", "/")[0], 200)
        self.assertLess(time.monotonic() - start, 10)  # a request for the state waits 20 s


class Ipv6(Live):
    options = ("--host", "[::1]")

    def test_the_printed_address_has_brackets_and_can_be_opened(self):
        self.assertEqual(self.server.url, f"http://[::1]:{self.server.port}/")
        self.assertEqual(self.server.request("GET", "/", host="::1")[0], 200)
        self.assertEqual(self.server.request("GET", "/", host="::1", headers={"Host": "evil.example"})[0], 403)


class Security(Live):
    options = ()
    scene = "experiments/marble-ball.yaml"

    def refused(self, *arguments, status=403, **options):
        self.assertEqual(self.server.request(*arguments, **options)[0], status, (arguments, options))

    def test_other_names_and_other_pages_are_refused(self):
        own = {"Host": f"127.0.0.1:{self.server.port}"}
        self.assertEqual(self.server.request("GET", "/api/state?seen=0", headers=own)[0], 200)
        for host in ("evil.example", f"evil.example:{self.server.port}", "127.0.0.1", ""):
            self.refused("GET", "/api/state?seen=0", headers={"Host": host})
        self.refused("GET", "/", headers={**own, "Origin": "http://evil.example"})
        self.refused("POST", "/api/change", {"shown": "depth"}, headers={**own, "Origin": "null"})
        self.refused("GET", "/api/state?seen=0", headers={**own, "Sec-Fetch-Site": "cross-site"})
        # A form on another site may send text without a preflight request
        self.refused("POST", "/api/change", {"shown": "depth"}, headers={**own, "Content-Type": "text/plain"})

    def test_no_file_but_shaders_and_scene_is_read(self):
        (self.folder / "secret.glsl").write_text("secret")
        (self.server.shaders / "lib/out.glsl").symlink_to(self.folder / "secret.glsl")
        (self.server.shaders / "notes.txt").write_text("not a shader")
        good = self.server.request("GET", "/api/file?name=shaders/lib/math.glsl")
        self.assertEqual(good[0], 200)
        for name in ("shaders/../secret.glsl", "shaders/lib/out.glsl", "shaders/notes.txt", "scene/secret.glsl", "scene/falloff.glsl", "/etc/passwd",
                     "scene/../../etc/passwd", "shaders//etc/passwd", "scene/", "", "shaders/lib/math.glsl%00.glsl"):
            self.refused("GET", "/api/file?name=" + name, status=404)
        names = json.loads(self.server.request("GET", "/api/files")[1])["files"]
        self.assertIn("shaders/lib/math.glsl", names)
        self.assertIn("scene/marble-ball.yaml", names)
        self.assertIn("scene/marble.glsl", names)  # that the scene names
        self.assertFalse([name for name in names if "out.glsl" in name or "notes" in name or "secret" in name])

    def test_nothing_is_saved_without_edit(self):
        before = self.server.scene.read_text()
        self.refused("POST", "/api/file", {"name": "scene/marble-ball.yaml", "text": "gone"})
        self.assertEqual(self.server.scene.read_text(), before)

    def test_code_of_the_scene_is_reloaded_and_its_mistakes_are_shown(self):
        code = self.folder / "marble.glsl"
        text = code.read_text()
        self.addCleanup(code.write_text, text)
        before = self.server.wait_for_picture(passes=PASSES)
        pixels = self.server.pixels()
        state = self.picture_after(lambda: replace(code, "0.85, 0.83, 0.8", "0.1, 0.9, 0.1"), passes=PASSES)
        self.assertNotEqual(self.server.pixels(), pixels)
        self.assertEqual(state["revision"], before["revision"])
        replace(code, "vec3 p = position", "vec3 p = oops")
        error = self.server.wait_for(lambda s: s["errors"])["errors"][0]
        self.assertEqual((error["name"], error["line"]), ("scene/marble.glsl", 1 + text[: text.index("vec3 p = position")].count("\n")))
        self.assertIn("oops", error["message"])
        code.write_text(text)
        self.server.wait_for(lambda s: not s["errors"])

    def test_nonsense_is_answered_with_an_error(self):
        for body in ({"settings": 3}, {"shown": 7}, {"settings": {"render.photons": 5}}, [1], {"pixel": -1}):
            self.refused("POST", "/api/change", body, status=400)
        self.assertIn("error", json.loads(self.server.request("POST", "/api/inspect", {"x": 5000, "y": 0})[1]))

    def test_pictures_can_be_kept(self):
        self.server.wait_for_picture(passes=2)
        png = self.server.request("GET", "/api/picture.png")[1]
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", png[16:24]), (SIDE, SIDE))
        exr = self.server.request("GET", "/api/picture.exr")[1]
        self.assertEqual(exr[:4], b"\x76\x2f\x31\x01")
        self.assertIn(b"caustic.R", exr)

    def test_another_address_needs_the_token(self):
        (self.folder / "token").mkdir()
        server = LiveServer(PROGRAM, SOURCE, self.folder / "token", "--host", "0.0.0.0")
        self.addCleanup(server.stop)
        token = server.url.split("token=")[1]
        self.assertRegex(token, r"^[0-9a-f]{32}$")
        self.assertEqual(server.request("GET", "/")[0], 403)
        self.assertEqual(server.request("GET", "/?token=" + "0" * 32)[0], 403)
        self.assertEqual(server.request("GET", "/?token=" + token)[0], 200)
        self.assertEqual(server.request("GET", "/", headers={"Cookie": "hyalite_token=" + token})[0], 200)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=2)
