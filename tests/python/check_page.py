"""Use the page web/index.html as a reader does, in a browser without a screen, and compare with the command.

    python check_page.py target/web/index.html target/release/groundwave

Numbers of five cases must be those of the command to 1e-9; faults stand at their fields in the command's words, and the page goes
on when they are mended; a slider is dragged over 50 steps; layers are dragged, deleted and moved by keys; nothing is fetched and
nothing complains. Needs what requirements.txt lists and a Chromium. Exits with 1 on any fault.
"""

import json
import math
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py
import numpy as np
from browser import check, faults, opened

CASES = Path(__file__).resolve().parents[2] / "soil_cases"
OPENED = [
    "lamprea2022_ballasted",
    "lamprea2022_slab",
    "lamprea2022_half_space",
    "mezher2016_profile3_slab",
    "kaynia2000_ledsgard_power_car_last",
]
# [s], measured 0.4 to 1.3 on two cores with five times as much to do; the page promises this
FIRST = 3.0
# [s], measured 0.07 to 0.16 there; promised is 0.1 on a core of one's own, where the request takes 0.03
COARSE = 0.3
# [s], measured 0.26 to 0.65 there; promised is 0.5 on a core of one's own, where the request takes 0.12
FULL = 1.5


def settle(page, how="whole"):
    page.wait_for_function("() => document.body.dataset.settled", timeout=120_000)
    found = page.evaluate("document.body.dataset.settled")
    check(found == how, f"the page is {found}, not {how}: {page.locator('.fault, .faults').all_inner_texts()}")


def open_file(page, name, text):
    page.set_input_files("#open", files=[{"name": name, "mimeType": "text/plain", "buffer": text}])
    page.wait_for_function(f"() => document.getElementById('opened').textContent.includes({json.dumps(name)})")


def field(page, key):
    return page.locator(f"[data-keys~='{key}']").first


def write(page, key, text):
    field(page, key).fill(text)


def command(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True)


def differ(ours, theirs):
    """Largest difference over the largest value; what is no number must be none in both."""
    ours, theirs = (np.array(values, dtype=float).ravel() for values in (ours, theirs))
    if ours.shape != theirs.shape or (np.isnan(ours) != np.isnan(theirs)).any():
        return math.inf
    scale = np.nanmax(abs(theirs), initial=0)
    return 0.0 if scale == 0 else np.nanmax(abs(ours - theirs)) / scale


def same_numbers(page, program, folder):
    """Every array and answer of five cases, in the page and by the command."""
    for name in OPENED:
        path = CASES / name / "case.toml"
        open_file(page, f"{name}.toml", path.read_bytes())
        settle(page)
        case = folder / f"{name}.toml"
        case.write_text(page.locator("#case").text_content())
        out = folder / name
        ran = command(program, "run", case, "--out", out, "--no-pictures")
        check(ran.returncode == 0, f"{name}: {ran.stderr}")
        summary, worst, count = json.loads((out / "summary.json").read_text()), 0.0, 0
        with h5py.File(out / "results.h5") as results:
            for study in ("critical_speed", "dispersion", "track_response", "contour"):
                told = page.evaluate(f"shown.{study}.told")
                arrays = {n: results[study][n][()] for n in results[study]}
                check(set(told["arrays"]) == set(arrays), f"{name}/{study}: arrays {set(told['arrays']) ^ set(arrays)}")
                pairs = [(told["arrays"][n], arrays[n]) for n in arrays]
                pairs += [(answer["value"], summary[study][answer["key"]]) for answer in told["answers"]]
                for ours, theirs in pairs:
                    worst, count = max(worst, differ(ours, theirs)), count + np.size(theirs)
        # measured 1.7e-11: vectors of another length, functions of another library, an accuracy of 1e-3 on the way
        check(worst <= 1e-9, f"{name}: {worst:.1e} from the command")
        print(f"{name}: {count} numbers, worst {worst:.1e}")
    # what was opened is what the file says: c_s of E, ν and ρ
    open_file(page, "first.toml", (CASES / OPENED[0] / "case.toml").read_bytes())
    speed = math.sqrt(60e6 / (2 * 1.35) / 1500)
    check(abs(page.evaluate("state.layers[0].shear_speed") / speed - 1) < 1e-14, "c_s of an opened layer")
    settle(page)


def squeezed(text):
    return re.sub(r"[^A-Za-z0-9.]", "", text)


FAULTS = [
    ("soil.layer[0].thickness", "-1"),
    ("soil.layer[0].thickness", "5 cm, perhaps"),
    ("soil.layer[0].poisson", "0.5"),
    ("soil.layer[0].density", "0"),
    ("soil.layer[0].damping_ratio", "a bit"),
    ("soil.layer[0].shear_speed", "2,5"),
    ("soil.layer[0].shear_speed", "1e-300"),
    ("soil.half_space.shear_speed", "1e300"),
    ("critical_speed.line_speed", "fast"),
    ("critical_speed.line_speed", "1e9 km/h"),
    ("critical_speed.speeds", "900"),
    ("train.count", "0"),
]


def same_words(page, program, folder):
    """Faults at their fields, in the words of the command; the page goes on."""
    page.select_option("#train", "lamprea2022_axle")
    settle(page)
    for key, text in FAULTS:
        before = field(page, key).input_value()
        write(page, key, text)
        settle(page, "faulty")
        case = folder / "faulty.toml"
        case.write_text(page.locator("#case").text_content())
        said = command(program, "check", case)
        check(said.returncode != 0, f"{key} = {text}: the command takes it")
        shown = page.locator(".fault, #faults p").all_inner_texts()
        words = squeezed(said.stderr + said.stdout)
        check(bool(shown), f"{key} = {text}: no message")
        for message in shown:
            # the help stands in brackets
            for part in re.split(r" \((?=[^()]*(?:\([^()]*\)[^()]*)*\)$)", message):
                check(squeezed(part) in words, f"{key} = {text}: «{part}» is not what the command says: {said.stderr}")
        where = page.locator("[aria-invalid]")
        check(where.count() > 0, f"{key} = {text}: no field is marked: {shown}")
        described = where.first.get_attribute("aria-describedby")
        check(page.locator(f"#{described}").count() == 1, f"{key}: the message is not that of its field")
        write(page, key, before)
        settle(page)
        check(page.locator(".fault").count() == 0, f"{key}: a mended fault stays")
    print(f"{len(FAULTS)} faults at their fields")


FILES = {
    "no case": (b"dear diary\n", "cannot be read from here on"),
    "binary": (bytes(range(256)) * 8, "cannot be read from here on"),
    "without a base": (b'title = "x"\ntrack = "lamprea2022_slab"\ntrain = "lamprea2022_axle"\n[soil]\n[[soil.layer]]\nthickness = 2.0\nyoung = 6e7\npoisson = 0.3\ndensity = 1500.0\nloss_factor = 0.06\n[critical_speed]\nspeeds = [10.0, 20.0]\n', "half_space"),
    "misspelt": (b'title = "x"\nsoil = "lamprea2022_layred"\ntrack = "lamprea2022_slab"\ntrain = "lamprea2022_axle"\n[critical_speed]\nspeeds = [10.0, 20.0]\n', "did you mean `lamprea2022_layered`?"),
    "on springs": (b'title = "x"\ntrain = "lamprea2022_axle"\n[foundation]\nkind = "winkler"\nstiffness = 1e8\nloss_factor = 0.1\n[track]\nkind = "beam"\nbeam.bending_stiffness = 1.2e7\nbeam.mass = 120.0\n[critical_speed]\nspeeds = [10.0, 20.0]\n', "the page knows layered ground"),
    "a record beside it": ((CASES / "kaynia2000_ledsgard_185" / "case.toml").read_bytes(), "a page reads one file"),
    "huge": (b"#" * 2_000_000, "no case file"),
}


def files(page):
    """Files that cannot be opened are told of and change nothing."""
    for name, (text, words) in FILES.items():
        before = page.locator("#case").text_content()
        open_file(page, f"{name}.toml", text)
        told = page.locator("#opened").inner_text()
        check(words in told, f"{name}: {told}")
        check(page.locator("#case").text_content() == before, f"{name}: the case has changed")
    # the same by dropping
    page.evaluate("""() => {
        const carried = new DataTransfer();
        carried.items.add(new File(["dear diary"], "dropped.toml"));
        document.body.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: carried }));
    }""")
    page.wait_for_function("() => document.getElementById('opened').textContent.includes('dropped.toml')")
    check("line 1" in page.locator("#opened").inner_text(), "a dropped file")
    print(f"{len(FILES)} files that are no case for the page")


def drag(page):
    """A slider over 50 steps: how old each coarse answer is when it is shown, how long the page stands still, and the full curve."""
    page.evaluate("""() => {
        window.coarse = []; window.full = []; window.gaps = [];
        const ask = asking.ask.bind(asking);
        asking.ask = (request, done, slow) => {
            const since = performance.now(), study = /^\\[(critical_speed)\\]$/m.test(request.case);
            ask(request, (reply) => { done(reply); if (study) (slow ? full : coarse).push(performance.now() - since); }, slow);
        };
        let last = performance.now();
        const frame = (now) => { gaps.push(now - last); last = now; if (window.gaps) requestAnimationFrame(frame); };
        requestAnimationFrame(frame);
    }""")
    slider = page.locator("#layers input[type=range]").first
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    before = page.locator("#number").get_attribute("data-value")
    x, y = box["x"] + 0.55 * box["width"], box["y"] + 0.5 * box["height"]
    page.mouse.move(x, y)
    page.mouse.down()
    values = set()
    for step in range(50):
        page.mouse.move(x + 0.25 * box["width"] * math.sin(step / 8), y)
        page.wait_for_timeout(40)
        values.add(page.locator("#number").get_attribute("data-value"))
    page.mouse.up()
    settle(page)
    coarse, full, gaps = (sorted(page.evaluate(name)) for name in ("coarse", "full", "gaps"))
    check(page.locator("#number").get_attribute("data-value") != before and len(values) > 10, f"{len(values)} critical speeds while dragging")
    check(len(full) > 0, "no full curve after a drag")
    middle = lambda times: times[len(times) // 2] / 1e3
    check(middle(coarse) <= COARSE, f"coarse answers take {middle(coarse):.3f} s")
    check(full[-1] / 1e3 <= FULL, f"the full curve takes {full[-1] / 1e3:.3f} s")
    # measured 33 to 133 on the busy machine: nothing is computed between frames
    check(gaps[-1] <= 250, f"the page stood still for {gaps[-1]:.0f} ms")
    print(
        f"drag of 50 steps: {len(coarse)} coarse answers, {middle(coarse) * 1e3:.0f} ms in the middle, {coarse[-1]:.0f} at most; "
        f"{len(values)} critical speeds; full curve {full[-1]:.0f} ms; longest frame {gaps[-1]:.0f} ms"
    )


def layers(page):
    """Layers come, move by mouse and by keys, and go."""
    names = lambda: page.locator("#layers [data-keys$='.thickness']").evaluate_all("all => all.map(i => i.value)")
    page.select_option("#soils", "kaynia2000_ledsgard_high_speed")
    settle(page)
    check(names() == ["1.1", "3", "4.5", "6"], f"layers {names()}")
    first, third = page.locator(".handle").nth(0), page.locator("#layers > li").nth(2)
    first.scroll_into_view_if_needed()
    start, end = first.bounding_box(), third.bounding_box()
    page.mouse.move(start["x"] + 5, start["y"] + 5)
    page.mouse.down()
    page.mouse.move(start["x"] + 5, end["y"] + end["height"] - 4, steps=12)
    page.mouse.up()
    check(names() == ["3", "4.5", "1.1", "6"], f"after a drag {names()}")
    page.locator(".handle").nth(2).focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowUp")
    check(names() == ["1.1", "3", "4.5", "6"], f"after two arrow keys {names()}")
    page.locator(".remove").nth(1).click()
    page.locator("#add").click()
    check(names() == ["1.1", "4.5", "6", "6"], f"after a deletion and an addition {names()}")
    settle(page)
    for n in range(4):
        page.locator(".remove").first.click()
    settle(page)
    page.locator("label", has_text="rock").locator("input").check()
    settle(page, "faulty")
    page.locator("#add").click()
    settle(page)
    check('base = "rigid"' in page.locator("#case").text_content(), "no rock in the case")
    page.select_option("#train", "goicolea2014_ice3_train")
    page.select_option("#track", "lamprea2022_slab")
    settle(page)
    check("one axle" in page.locator("#what").inner_text(), "the critical speed of a train is not said to be one axle's")
    print("layers dragged, moved, deleted, added")


def readable(page):
    """Every field has a name, the page fits a telephone, prints, and tells values under the pointer."""
    nameless = page.evaluate("""() => [...document.querySelectorAll("input, select, button")].filter(
        (e) => !e.labels?.length && !e.getAttribute("aria-label") && !e.textContent.trim()).map((e) => e.outerHTML)""")
    check(not nameless, f"without a name: {nameless}")
    for svg in page.locator("figure > svg").all():
        check(bool(svg.get_attribute("aria-label")), "a picture without a description")
    for name in ("curve", "waves", "rail", "ground"):
        figure = page.locator(f"#{name}")
        plain = figure.locator(".told").inner_text()
        figure.locator("svg").last.hover(position={"x": 150, "y": 120})
        told = figure.locator(".told").inner_text()
        check(told != plain and re.search(r"\d", told), f"{name} tells {told}")
    check(page.pdf(format="A4")[:4] == b"%PDF", "no print")
    page.set_viewport_size({"width": 360, "height": 740})
    page.wait_for_timeout(300)
    wide = page.evaluate("document.documentElement.scrollWidth")
    check(wide <= 360, f"{wide} pixels on a screen of 360")


def main(path, program):
    path, program = Path(path), Path(program).resolve()
    size = path.stat().st_size / 1e6
    check(size <= 5, f"{size:.1f} MB")
    with opened(path) as page, tempfile.TemporaryDirectory() as folder:
        since = time.monotonic()
        page.wait_for_function("() => document.getElementById('number').dataset.value", timeout=60_000)
        # since the navigation began
        first = page.evaluate("performance.now()") / 1e3
        settle(page)
        print(f"page {size:.2f} MB, first answer {first:.2f} s, all {first + time.monotonic() - since:.2f} s")
        check(first <= FIRST, f"first answer after {first:.1f} s")
        drag(page)
        same_numbers(page, program, Path(folder))
        same_words(page, program, Path(folder))
        files(page)
        layers(page)
        readable(page)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
