"""Build the page: one file, web/index.html in the target directory, that opens from the disk and fetches nothing.

    python3 web/build.py [where.html]

Needs Rust with its target wasm32-unknown-unknown (`rustup target add wasm32-unknown-unknown`) and nothing else.
"""

import base64
import gzip
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", HERE.parent / "target"))
WASM = TARGET / "wasm32-unknown-unknown" / "release" / "groundwave_web.wasm"
# vectors of two numbers are in every browser since 2023; names of functions would be a third of the size
FLAGS = "-C target-feature=+simd128 -C strip=symbols"


def program():
    environment = {**os.environ, "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS": FLAGS}
    command = ["cargo", "build", "--release", "--locked", "--target", "wasm32-unknown-unknown", "-p", "groundwave-web"]
    subprocess.run(command, cwd=HERE.parent, env=environment, check=True)
    # the same bytes from the same program, at whatever time
    return base64.b64encode(gzip.compress(WASM.read_bytes(), 9, mtime=0)).decode()


def main(out):
    parts = {path.name: path.read_text() for path in (HERE / "page").iterdir()} | {"program": program()}
    page = parts.pop("index.html")
    # a script would end at its own closing tag
    page = re.sub(r"(?:/\*)?\{\{([\w.]+)\}\}(?:\*/)?", lambda place: parts[place[1]].replace("</script", "<\\/script"), page)
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(page)
    print(f"{out}: {len(page.encode()) / 1e6:.2f} MB, of which the program {len(parts['program']) / 1e6:.2f} MB")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else TARGET / "web" / "index.html")
