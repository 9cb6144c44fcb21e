"""Opens, inspects and clicks the page of `hyalite parity --report`: PROGRAM SOURCE."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from browser import console_complaints, open_browser, resources
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

PROGRAM, SOURCE = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
MOST_BYTES = 5_000_000


def write_report(folder, *options, exit_code=0):
    """Writes the report on the default scene; returns its path."""
    scene = SOURCE / "scenes/cornell-caustics.yaml"
    done = subprocess.run([PROGRAM, "parity", scene, "--report", folder, *options], capture_output=True, text=True, timeout=300)
    assert done.returncode == exit_code, done.stdout + done.stderr
    return folder / "parity.html"


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.browser = open_browser()
        cls.addClassCleanup(cls.browser.quit)

    def open(self, page):
        self.browser.get(page.as_uri())

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def tearDown(self):
        self.assertEqual(console_complaints(self.browser), [])
        self.assertEqual(resources(self.browser), [])


class ReportThatPassed(Page):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = write_report(cls.folder)

    def setUp(self):
        self.open(self.page)

    def click_pixel(self, view, x, y):
        """Clicks a view at a position given as fractions of its width and height."""
        self.browser.execute_script(
            "const [view, x, y] = arguments; view.scrollIntoView({block: 'center'}); const box = view.getBoundingClientRect();"
            "document.elementFromPoint(box.left + x * box.width, box.top + y * box.height).dispatchEvent("
            "new MouseEvent('click', {bubbles: true, clientX: box.left + x * box.width, clientY: box.top + y * box.height}))",
            self.find(view), x, y)

    def test_the_page_is_small_and_says_what_was_compared_where(self):
        self.assertLess(self.page.stat().st_size, MOST_BYTES)
        self.assertIn("parity passed", self.find("#verdict").text)
        machine = self.find("#machine").text
        for part in ("Mesa", "LLVM", "bits"):
            self.assertIn(part, machine)

    def test_a_click_on_a_stage_shows_its_fields_and_another_hides_them(self):
        row = self.find("#stage-trace_closest")
        row.click()
        fields = self.find("td.fields")
        self.assertRegex(fields.text, r"(?s)object.*primitive.*place")
        self.assertGreater(len(fields.find_elements(By.CSS_SELECTOR, "svg.bars rect")), 0)
        row.click()
        self.assertEqual(self.find_all("td.fields"), [])
        row.send_keys(Keys.ENTER)
        self.assertEqual(len(self.find_all("td.fields")), 1)

    def test_the_slider_pulls_one_picture_over_the_other(self):
        for image in self.find_all(".view img"):
            self.assertEqual(image.get_property("naturalWidth"), 64)
        slider = self.find("#slider")
        over = self.find("#both img.over")
        for key, share in ((Keys.HOME, "0%"), (Keys.END, "100%")):
            slider.send_keys(key)
            self.assertIn(share + ")", over.value_of_css_property("clip-path"))

    def test_a_click_on_a_pixel_shows_its_path_on_both_sides(self):
        for view in ("#both", "#difference"):
            self.click_pixel(view, (40 + 0.5) / 64, (50 + 0.5) / 64)
            self.assertEqual(self.find("#path-title").text, "Path of pixel 40, 50")
            sides = [cell.text for cell in self.find_all("#path tbody td.side")]
            self.assertGreaterEqual(sides.count("device"), 1)
            self.assertEqual(sides.count("device"), sides.count("twin"))
            self.assertTrue(self.find(f"{view} .mark").is_displayed())
            self.click_pixel(view, 0.01, 0.01)
            self.assertEqual(self.find("#path-title").text, "Path of pixel 0, 0")

    def test_paths_that_part_unfold_and_their_difference_is_marked(self):
        paths = self.find_all("#worst details")
        self.assertGreater(len(paths), 0)
        summary = paths[0].find_element(By.CSS_SELECTOR, "summary")
        self.assertRegex(summary.text, r"differs at vertex \d+, first in \w+: \w+")
        summary.click()
        # The `toggle` event builds the table, some time after the click
        marked = WebDriverWait(self.browser, 30).until(lambda _: paths[0].find_elements(By.CSS_SELECTOR, "tr.differs"))
        vertex = re.search(r"differs at vertex (\d+)", summary.text)[1]
        self.assertEqual(marked[0].find_element(By.CSS_SELECTOR, "td").text, vertex)

    def test_a_narrow_window_needs_no_sideways_scrolling(self):
        self.addCleanup(self.browser.set_window_size, 1280, 900)
        self.browser.set_window_size(500, 900)
        wide, window = self.browser.execute_script("return [document.documentElement.scrollWidth, window.innerWidth]")
        self.assertLessEqual(wide, window)


class ReportThatFailed(Page):
    def test_the_stage_to_mend_is_open_with_its_offenders(self):
        shaders = self.folder / "shaders"
        shutil.copytree(SOURCE / "shaders", shaders)
        fresnel = shaders / "bsdf/interface.glsl"
        text = fresnel.read_text()
        fresnel.write_text(text.replace("0.5 * (s * s + p * p)", "s * s"))
        self.assertNotEqual(fresnel.read_text(), text)
        self.open(write_report(self.folder, "--shaders", shaders, exit_code=1))
        self.assertIn("the sides first differ in shade_surface", self.find("#verdict").text)
        self.assertIn("bad", self.find("#verdict").get_attribute("class"))
        fields = self.find("td.fields")
        self.assertIn("nothing explains it", fields.text)
        fields.find_element(By.CSS_SELECTOR, "details summary").click()
        self.assertTrue(re.search(r"device .*, twin ", fields.text))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
