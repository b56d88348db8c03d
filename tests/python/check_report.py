"""Read a report with a pointer, in a browser without a screen, and compare with results.h5.

    python check_report.py results_of_the_main_case

Values told under the pointer must be those of results.h5 to the digits shown, copied tables too; curves hide and show by
mouse and keys, a drag zooms and a double click brings the whole picture back; in print and without scripts the report is whole,
and its pictures look like the PNGs beside it; nothing is fetched and nothing complains. Needs what requirements.txt lists and a Chromium, found as `chromium` or by the
variable CHROMIUM. Exits with 1 on any fault.
"""

import csv
import io
import os
import re
import shutil
import sys
from pathlib import Path

import h5py
import numpy as np
from PIL import Image
from playwright.sync_api import sync_playwright

faults = []


def check(holds, text):
    if not holds:
        print(f"FAULT: {text}")
        faults.append(text)


def numbers(text):
    """All numbers of a text, powers of ten included."""
    powers = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")
    text = re.sub("·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", lambda found: "e" + found[1], text).translate(powers)
    return [float(found) for found in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text)]


def agree(value, exact):
    """True where `value` is `exact` to the five digits that are shown at least: half a unit of the fifth, and single precision."""
    return abs(value - exact) <= 0.5 * 10 ** (np.floor(np.log10(abs(exact))) - 4) + 1e-7 * abs(exact) if exact else value == 0


class Figure:
    """A figure of the report, found by its title."""

    def __init__(self, page, title):
        self.page = page
        self.figure = page.locator("figure").filter(has=page.locator("figcaption", has_text=title)).first
        self.svg = self.figure.locator("svg").first
        self.told = self.figure.evaluate("f => JSON.parse(f.querySelector('script').textContent)")
        self.svg.scroll_into_view_if_needed()

    def screen(self, x, y):
        """Where a place of the page [px of the SVG] is on the screen."""
        box = self.svg.bounding_box()
        scale = box["width"] / self.svg.evaluate("s => s.viewBox.baseVal.width")
        return box["x"] + scale * x, box["y"] + scale * y

    def pixel(self, way, value):
        (low, high), (first, last) = self.told[way]["range"], self.told[way]["pixels"]
        bend = np.log10 if self.told[way]["log"] else float
        return first + (bend(value) - bend(low)) / (bend(high) - bend(low)) * (last - first)

    def at(self, x, y):
        """What is told with the pointer at the values x, y."""
        self.page.mouse.move(*self.screen(self.pixel("x", x), self.pixel("y", y)))
        return self.figure.locator(".tip div").all_inner_texts()

    def middle(self):
        left, top, right, bottom = self.told["frame"]
        return 0.5 * (left + right), 0.5 * (top + bottom)

    def drag(self, from_, to):
        self.page.mouse.move(*self.screen(*from_))
        self.page.mouse.down()
        self.page.mouse.move(*self.screen(*to), steps=4)
        self.page.mouse.up()



def curves(page, results):
    """Speed curves: values of both axes and both units, legend, zoom, keys."""
    group = results["critical_speed"]
    speed, down = group["speed"][()], group["max_down"][()] * 1e3
    figure = Figure(page, "Rail deflection against speed")
    plain = figure.svg.inner_html()
    compared = 0
    for i in range(0, len(speed), 7):
        lines = figure.at(3.6 * speed[i], down[i])
        first = numbers(lines[0])
        check(agree(first[0], 3.6 * speed[i]) and agree(first[1], speed[i]), f"abscissa {lines[0]} of {speed[i]}")
        told = [n for line in lines[1:] for n in numbers(line.rsplit(":", 1)[-1])]
        check(any(agree(n, down[i]) for n in told), f"{lines} of {down[i]} at {speed[i]}")
        compared += 1
    print(f"{compared} speeds told as results.h5 has them")

    # drag over the middle half: the same values under the pointer's new places, other ticks
    left, top, right, bottom = figure.told["frame"]
    figure.drag((left + 0.25 * (right - left), top + 10), (left + 0.75 * (right - left), bottom - 10))
    zoomed = figure.svg.locator(".ticks.x text").all_inner_texts()
    page.mouse.move(*figure.screen(*figure.middle()))
    lines = figure.figure.locator(".tip div").all_inner_texts()
    near = int(np.argmin(abs(3.6 * speed - numbers(lines[0])[0])))
    check(agree(numbers(lines[0])[1], speed[near]), f"zoomed: {lines[0]}")
    check(any(agree(n, down[near]) for line in lines[1:] for n in numbers(line.rsplit(":", 1)[-1])), f"zoomed: {lines}")
    page.mouse.dblclick(*figure.screen(*figure.middle()))
    page.mouse.move(0, 0)
    check(figure.svg.locator(".ticks.x text").all_inner_texts() != zoomed, "the ticks did not change with the zoom")
    check(figure.svg.inner_html() == plain, "a double click leaves traces of the zoom")

    # arrow keys read values too
    figure.svg.focus()
    page.keyboard.press("ArrowRight")
    check(figure.figure.locator(".tip").is_visible(), "no value after an arrow key")
    page.keyboard.press("Escape")
    check(not figure.figure.locator(".tip").is_visible(), "Escape leaves the value")


def legend(page):
    """Entries hide and show, by mouse and by keys."""
    figure = Figure(page, "Rail deflection against speed")
    keys, shown = figure.svg.locator(".key"), lambda: [
        g.evaluate("g => getComputedStyle(g).visibility !== 'hidden'") for g in figure.svg.locator(".curve").all()
    ]
    check(keys.count() >= 2 and all(shown()), f"{keys.count()} entries, {shown()}")
    keys.nth(0).click()
    check(shown()[0] is False and shown()[1], "a click does not hide")
    check(keys.nth(0).get_attribute("aria-pressed") == "false", "a hidden curve is not said to be hidden")
    keys.nth(0).focus()
    page.keyboard.press("Enter")
    check(all(shown()), "Enter does not show")
    page.keyboard.press(" ")
    check(not shown()[0], "Space does not hide")
    ticks = figure.svg.locator(".ticks.x text").all_inner_texts()
    (x, y), (left, top, *_) = figure.middle(), figure.told["frame"]
    figure.drag((left + 20, top + 20), (x, y))
    check(figure.svg.locator(".ticks.x text").all_inner_texts() != ticks, "a drag does not zoom")
    page.pdf(format="A4", prefer_css_page_size=True)
    check(all(shown()), "a hidden curve is missing in print")
    check(figure.svg.locator(".ticks.x text").all_inner_texts() == ticks, "the zoom is printed")


def copied(page, results):
    """The table of a button is that of results.h5."""
    page.evaluate("() => { navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }; }")
    figure = Figure(page, "Rail deflection against speed")
    figure.figure.locator("button").click()
    head, *rows = csv.reader(io.StringIO(page.evaluate("() => window.copied")))
    group = results["critical_speed"]
    speed, down = group["speed"][()], group["max_down"][()] * 1e3
    table = {float(row[0]): [float(cell) for cell in row[1:] if cell] for row in rows if len(row) > 1}
    # seven digits, half a unit of the last, and single precision
    check(np.allclose(sorted(table), 3.6 * speed, rtol=6e-7), "copied speeds")
    for v, u in zip(speed, down):
        near = table[min(table, key=lambda s: abs(s - 3.6 * v))]
        check(any(abs(cell - u) <= 6e-7 * abs(u) for cell in near), f"copied {near} of {u} at {v}")
    print(f"{len(rows)} rows copied under {head}")


def fields(page, results):
    """Values of the ground's surface under the pointer."""
    figure = Figure(page, "Ground surface at 493 km/h (137.0 m/s)")
    group = results["contour"]
    x, y = group["x"][()], group["y"][()]
    field = group["u_z"][int(np.argmin(abs(group["speed"][()] - 137.0)))] * 1e3
    generator, worst = np.random.default_rng(1), 0.0
    step = figure.told["field"]["step"]
    for _ in range(40):
        i, j = generator.integers(len(x)), generator.integers(len(y))
        lines = figure.at(x[i], y[j])
        u, v, w = (numbers(line)[-1] for line in lines)
        # a field that was thinned tells the place of its value too
        i, j = int(np.argmin(abs(x - u))), int(np.argmin(abs(y - v)))
        worst = max(worst, abs(w - field[j, i]))
        # half a step of 16 bits and half a unit of the last digit, which is twice a step at least
        unit = 10 ** np.ceil(np.log10(2 * step))
        check(abs(w - field[j, i]) <= 0.5 * step + 0.5 * unit, f"{lines} of {field[j, i]} at {x[i]}, {y[j]}")
    print(f"40 places of the field told, worst {worst:.2e} mm of {abs(field).max():.3g} mm")


def likeness(page, title, png):
    """Correlation of darkness between a figure on the screen and its PNG, in blocks of about 15 px."""
    figure = page.locator("figure").filter(has=page.locator("figcaption", has_text=title)).first.locator("svg").first
    blocks = [np.asarray(Image.open(source).convert("L").resize((60, 54), Image.Resampling.BOX), dtype=float)
              for source in (io.BytesIO(figure.screenshot()), png)]
    return np.corrcoef(blocks[0].ravel(), blocks[1].ravel())[0, 1]


def main(folder):
    folder = Path(folder).resolve()
    chromium = os.environ.get("CHROMIUM") or shutil.which("chromium")
    address = (folder / "report.html").as_uri()
    requests, complaints = [], []
    with sync_playwright() as play, h5py.File(folder / "results.h5") as results:
        browser = play.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1200, "height": 900})
        page.on("request", lambda request: requests.append(request.url))
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(address)
        ready = "() => document.querySelectorAll('figure > script').length === document.querySelectorAll('figure > .tip').length"
        page.wait_for_function(ready)
        curves(page, results)
        legend(page)
        copied(page, results)
        fields(page, results)
        fetched = [url for url in requests if url != address and not url.startswith(("data:", "blob:"))]
        check(not fetched, f"fetched {fetched}")
        check(not complaints, f"the browser says {complaints}")

        bare = browser.new_context(java_script_enabled=False, viewport={"width": 1200, "height": 900}).new_page()
        bare.goto(address)
        figures = page.locator("figure svg").count()
        check(bare.locator("figure svg").count() == figures, "figures are missing without scripts")
        check(bare.locator("figure button").count() == 0, "a button without a script")
        for title, name in [("Rail deflection against speed", "critical_speed"), ("Rayleigh waves", "dispersion"),
                            ("Ground surface at 493 km/h", "contour_u_z_137"), ("Train, track and ground", "model")]:
            alike = likeness(bare, title, folder / f"{name}.png")
            # measured 0.991 to 0.9996; the contour of another speed 0.97, other pictures below 0.7
            check(alike > 0.98, f"{name}: screen and PNG correlate by {alike:.3f}")
            print(f"{name}: screen and PNG correlate by {alike:.4f}")
        print(f"{figures} figures, report of {(folder / 'report.html').stat().st_size // 1000} kB")
        browser.close()
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
