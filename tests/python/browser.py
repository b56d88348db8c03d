"""A browser without a screen, and what a page does in it that it should not."""

import os
import shutil
from contextlib import contextmanager

from playwright.sync_api import sync_playwright

faults = []


def check(holds, text):
    """Tells and counts what does not hold."""
    if not holds:
        print(f"FAULT: {text}")
        faults.append(text)


@contextmanager
def opened(path, width=1200, height=900):
    """The page at `path` opened from the disk by a Chromium, found as `chromium` or by the variable CHROMIUM.

    At the end it must have fetched nothing and complained of nothing.
    """
    requests, complaints = [], []
    with sync_playwright() as play:
        chromium = os.environ.get("CHROMIUM") or shutil.which("chromium")
        browser = play.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": width, "height": height})
        page.on("request", lambda r: requests.append(r.url))
        page.on("console", lambda m: complaints.append(m.text))
        page.on("pageerror", lambda e: complaints.append(str(e)))
        address = path.resolve().as_uri()
        page.goto(address)
        yield page
        fetched = [url[:80] for url in requests if url != address and not url.startswith(("data:", "blob:"))]
        check(not fetched, f"fetched {fetched}")
        check(not complaints, f"the browser says {complaints}")
        browser.close()
