#!/usr/bin/env python3
"""Looks at a page of --page in headless Chromium as its user does: by clicks and keys.

usage: page_in_browser.py FOLDER CHROMIUM CHROMEDRIVER

FOLDER has `page.html` of 60 cells, and `cells.csv`, their statistics.
"""
import csv
import json
import sys
import tempfile
import time
import unittest
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

FOLDER, CHROMIUM, CHROMEDRIVER = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
PROFILE = tempfile.TemporaryDirectory()
ARGUMENTS = ["--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--window-size=1000,750", "--user-data-dir=" + PROFILE.name]

# Red, green and blue of the middle of a picture, of its corner, and the number of its colours.
LOOK = """
const done = arguments[1];
const image = new Image();
image.onload = () => {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [image.width, image.height];
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  const at = (x, y) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3);
  const all = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
  done({ middle: at(image.width / 2, image.height / 2), corner: at(12, 12), colors: new Set(all).size });
};
image.src = 'data:image/png;base64,' + arguments[0];
"""


def start():
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for argument in ARGUMENTS:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(options=options, service=Service(CHROMEDRIVER))


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.driver = start()
        cls.driver.set_script_timeout(30)
        cls.driver.get("about:blank")
        cls.driver.get_log("performance")  # Of the browser's own first page.
        with open(FOLDER / "cells.csv", newline="") as file:
            cls.cells = list(csv.DictReader(file))

    @classmethod
    def tearDownClass(cls):
        cls.driver.quit()
        PROFILE.cleanup()

    def setUp(self):
        self.driver.get((FOLDER / "page.html").as_uri())
        self.wait(lambda: self.driver.execute_script("return document.documentElement.dataset.ready"))
        self.view = self.find("view")

    def find(self, name):
        return self.driver.find_element(By.ID, name)

    def wait(self, condition):
        WebDriverWait(self.driver, 60).until(lambda driver: condition())

    def picture(self):
        """The view as it is once it has been drawn."""
        self.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
        return self.view.screenshot_as_base64

    def look(self, picture):
        return self.driver.execute_async_script(LOOK, picture)

    def expect_other_picture(self, before, action):
        action()
        after = self.picture()
        self.assertNotEqual(before, after)
        return after

    def click_middle(self):
        ActionChains(self.driver).move_to_element(self.view).click().perform()

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def choose(self, name, value):
        Select(self.find(name)).select_by_value(value)

    def slide(self, name, keys):
        self.find(name).send_keys(*keys)

    def selected_label(self):
        return self.driver.find_element(By.CSS_SELECTOR, "#selection h3").text.split()[1]

    def column(self, name):
        """The texts of a column of the table, of the rows that there are elements of."""
        heads = [head.get_attribute("data-column") for head in self.driver.find_elements(By.CSS_SELECTOR, "#table th")]
        cells = f"#table tr[data-cell] td:nth-child({heads.index(name) + 1})"
        return [cell.text for cell in self.driver.find_elements(By.CSS_SELECTOR, cells)]

    def sort(self, name):
        self.driver.find_element(By.CSS_SELECTOR, f'#table th[data-column="{name}"] button').click()

    def test_first_picture_shows_the_tissue_and_its_file(self):
        seen = self.look(self.picture())
        self.assertGreater(seen["colors"], 100)
        self.assertNotEqual(seen["middle"], seen["corner"])
        self.assertEqual(self.find("title").text, "a <b>&'.mha")
        self.assertIn("60 cells", self.find("facts").text)
        self.assertFalse(self.find("failure").is_displayed())
        milliseconds = self.driver.execute_script("return document.documentElement.dataset.firstPicture")
        print(f"first picture after {milliseconds} ms")

    def test_a_click_selects_a_cell_and_a_row_does_too(self):
        before = self.picture()
        self.expect_other_picture(before, self.click_middle)
        label = self.selected_label()
        find_row = lambda: self.driver.find_element(By.CSS_SELECTOR, '#table tr[aria-selected="true"]')
        self.assertEqual(find_row().find_element(By.TAG_NAME, "td").text, label)
        volume = next(float(cell["Volume"]) for cell in self.cells if cell["Label"] == label)
        shown = self.find("selection").text.split("\nVolume\n")[1].split()[0]
        self.assertAlmostEqual(float(shown), volume, delta=1e-4 * volume)
        # It was the cell in the middle, which is there without all others.
        self.choose("scope", "one")
        seen = self.look(self.picture())
        self.assertNotEqual(seen["middle"], seen["corner"])
        self.driver.execute_script("arguments[0].scrollIntoView({ block: 'center' })", self.find("table"))
        other = find_row().find_element(By.XPATH, "following-sibling::tr[@data-cell][1] | preceding-sibling::tr[@data-cell][1]")
        other_label = other.find_element(By.TAG_NAME, "td").text
        other.click()
        self.assertEqual(self.selected_label(), other_label)
        self.press(Keys.ESCAPE)
        self.assertEqual(self.find("selection").text, "No cell is selected.")

    def test_a_click_beside_the_tissue_selects_nothing(self):
        self.click_middle()
        ActionChains(self.driver).move_to_element_with_offset(self.view, -int(self.view.size["width"] * 0.45), 0).click().perform()
        self.assertEqual(self.find("selection").text, "No cell is selected.")

    def test_the_table_sorts_and_finds(self):
        self.sort("Volume")
        ascending = [float(text) for text in self.column("Volume")]
        self.assertEqual(ascending, sorted(ascending))
        least = min(float(cell["Volume"]) for cell in self.cells)
        self.assertAlmostEqual(ascending[0], least, delta=1e-4 * least)
        self.sort("Volume")
        descending = [float(text) for text in self.column("Volume")]
        self.assertEqual(descending, sorted(descending, reverse=True))
        self.find("find").send_keys("59")
        self.assertEqual(self.column("Label"), ["59"])
        self.assertEqual(self.find("rows").text, "1 of 60 cells")

    def test_colours_have_their_legend(self):
        before = self.picture()
        legend = lambda: self.find("legend").get_attribute("aria-label")
        self.assertEqual(legend().split(",")[0], "Legend and histogram: Volume (unit³)")
        self.choose("color-by", "Sphericity")
        self.assertEqual(legend().split(",")[0], "Legend and histogram: Sphericity")
        before = self.expect_other_picture(before, lambda: self.choose("color-by", "Layer"))
        self.assertIn("1 (epidermis)", self.find("legend").text)
        self.expect_other_picture(before, lambda: self.choose("color-by", ""))
        self.choose("color-by", "Volume")
        bars = self.driver.find_elements(By.CSS_SELECTOR, "#legend svg rect title")
        counts = [int(bar.get_attribute("textContent").split()[0]) for bar in bars]
        self.assertEqual(sum(counts), len(self.cells))

    def test_layers_explosion_and_cut_change_the_picture(self):
        picture = self.picture()
        outer = self.driver.find_element(By.CSS_SELECTOR, '#layers input[data-layer="1"]')
        self.expect_other_picture(picture, outer.click)
        outer.click()
        self.assertEqual(self.picture(), picture)
        cut = self.expect_other_picture(picture, lambda: self.choose("cut-axis", "x"))
        moved = self.expect_other_picture(cut, lambda: self.slide("cut-at", [Keys.ARROW_RIGHT] * 20))
        self.expect_other_picture(moved, self.find("cut-flip").click)
        self.choose("cut-axis", "none")
        self.assertEqual(self.picture(), picture)
        self.expect_other_picture(picture, lambda: self.slide("explode", [Keys.ARROW_RIGHT] * 20))
        self.slide("explode", [Keys.HOME])
        self.assertEqual(self.picture(), picture)

    def test_a_cut_through_a_cell_is_filled_and_can_be_clicked(self):
        self.choose("cut-axis", "view")
        seen = self.look(self.picture())
        self.assertNotEqual(seen["middle"], seen["corner"])
        self.click_middle()
        label = self.selected_label()
        # Of the cell alone the cut is still there: flat, in the colour that all of it has.
        self.choose("scope", "one")
        self.assertNotEqual(self.look(self.picture())["middle"], seen["corner"])
        self.assertEqual(self.selected_label(), label)

    def test_keys_do_what_the_page_says(self):
        self.click_middle()
        self.press(Keys.ESCAPE)
        first = self.picture()
        turned = self.expect_other_picture(first, lambda: self.press(Keys.ARROW_LEFT))
        near = self.expect_other_picture(turned, lambda: self.press("+"))
        self.expect_other_picture(near, lambda: self.press("-", "r"))
        self.assertEqual(self.picture(), first)
        self.press("n")
        self.assertEqual(self.selected_label(), "1")
        self.press("n")
        self.assertEqual(self.selected_label(), "2")
        self.press("p")
        self.assertEqual(self.selected_label(), "1")
        self.press(Keys.ESCAPE)
        self.assertEqual(self.find("selection").text, "No cell is selected.")
        self.expect_other_picture(first, lambda: self.press("c"))
        self.expect_other_picture(first, lambda: self.press("r", "e"))

    def test_every_control_is_reached_by_tab_and_has_a_name(self):
        reached = set()
        for _ in range(120):
            self.press(Keys.TAB)
            element = self.driver.switch_to.active_element
            reached.add(element.get_attribute("id"))
        for name in ("view", "zoom-in", "reset", "save", "color-by", "color-map", "explode", "cut-axis", "scope", "find"):
            self.assertIn(name, reached)
        for control in self.driver.find_elements(By.CSS_SELECTOR, "button, select, input"):
            self.assertTrue(control.accessible_name, control.get_attribute("outerHTML"))

    def test_the_report_is_there(self):
        text = self.find("report").text
        self.assertIn("Adjacency after each stage", text)
        self.assertIn("time (s)", text)
        self.assertIn("Remarks on cells", text)
        self.assertIn("the voxels are exactly 1 x 1 x 1", text)

    def test_dark_and_narrow_are_fine(self):
        light = self.look(self.picture())["corner"]
        dark = {"features": [{"name": "prefers-color-scheme", "value": "dark"}]}
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", dark)
        self.assertLess(sum(self.look(self.picture())["corner"]), 0.3 * sum(light))
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
        narrow = {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", narrow)
        self.picture()
        self.assertLessEqual(self.driver.execute_script("return document.documentElement.scrollWidth"), 390)
        self.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def tearDown(self):
        self.assertEqual([entry["message"] for entry in self.driver.get_log("browser")], [])
        messages = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        urls = [m["params"]["request"]["url"] for m in messages if m["method"] == "Network.requestWillBeSent"]
        self.assertEqual([url for url in urls if not url.startswith(("file:", "data:"))], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
