#!/usr/bin/env python3
"""Opens the pages of a run, a sweep, a comparison and a calibration in a headless browser, as files, and tries them out.

    scripts/report/browser.py target/release/coulter [--run DIR] [--keep DIR] [--pages PAGE …]

At 390 and 1280 pixels, light and dark: no errors on the console, no request to a network, nothing wider than the window, every chart
with curves, every picture loaded, the view in space not empty, the text of every cell of every table to be seen, numbers below their
heads, charts whose legends stand outside the axes and whose series differ without colour. Then values under the pointer and under a finger, zoom and back, the
time slider, play, turning. At last on paper: no empty page, the case unfolded. Needs Python and chromium only; --run takes a
results folder instead of computing one, --keep leaves pages, screenshots and prints in a folder, --pages opens these instead.
"""
import argparse
import base64
import fcntl
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTHS = {390: 844, 1280: 900}


class Browser:
    """Chromium, driven through two pipes by its DevTools protocol."""

    def __init__(self, profile):
        name = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
        if name is None:
            sys.exit("chromium is missing; apt-get install chromium")
        ends = [fcntl.fcntl(fd, fcntl.F_DUPFD_CLOEXEC, 20) for fd in (*os.pipe(), *os.pipe())]
        self.inbox, self.outbox = os.fdopen(ends[2], "rb", 0), os.fdopen(ends[1], "wb", 0)

        def give():
            os.dup2(ends[0], 3)
            os.dup2(ends[3], 4)

        command = [name, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
                   "--no-first-run", "--disable-dev-shm-usage", "--force-color-profile=srgb", f"--user-data-dir={profile}"]
        quiet = subprocess.DEVNULL
        self.process = subprocess.Popen(command, pass_fds=(3, 4), preexec_fn=give, stdout=quiet, stderr=quiet)
        os.close(ends[0])
        os.close(ends[3])
        self.number, self.buffer, self.events, self.session = 0, b"", [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def receive(self):
        while b"\0" not in self.buffer:
            piece = os.read(self.inbox.fileno(), 1 << 20)
            if not piece:
                sys.exit("the browser has gone")
            self.buffer += piece
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        self.outbox.write(json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def evaluate(self, script):
        result = self.call("Runtime.evaluate", expression=f"(async () => {{ {script} }})()", awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            sys.exit(f"cannot evaluate {script}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, path, width, dark, touch):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=WIDTHS[width], deviceScaleFactor=1, mobile=touch)
        self.call("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.call("Emulation.setEmulatedMedia", media="screen",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.events.clear()
        self.call("Page.navigate", url=path.resolve().as_uri())
        self.evaluate("while (document.readyState !== 'complete') await new Promise(r => setTimeout(r, 20));"
                      "await new Promise(r => setTimeout(r, 400));")

    def complaints(self):
        """Errors on the console, and requests that leave the file."""
        self.evaluate("")
        found = []
        for event in self.events:
            method, content = event.get("method"), event.get("params", {})
            if method == "Runtime.exceptionThrown":
                details = content["exceptionDetails"]
                found.append(details.get("exception", {}).get("description", details["text"]))
            elif method == "Runtime.consoleAPICalled" and content["type"] in ("error", "warning", "assert"):
                found.append(str([argument.get("value") for argument in content["args"]]))
            elif method == "Log.entryAdded" and content["entry"]["level"] == "error":
                found.append(content["entry"]["text"])
            elif method == "Network.requestWillBeSent" and not re.match("file:|data:|about:", content["request"]["url"]):
                found.append(f"asks the network for {content['request']['url']}")
        return found

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, begin, end):
        self.mouse("mouseMoved", *begin)
        self.mouse("mousePressed", *begin, button="left", clickCount=1)
        self.mouse("mouseMoved", *[0.5 * (a + b) for a, b in zip(begin, end)], button="left", buttons=1)
        self.mouse("mouseMoved", *end, button="left", buttons=1)
        self.mouse("mouseReleased", *end, button="left", clickCount=1)

    def key(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def close(self):
        self.session = None
        self.call("Browser.close")
        self.process.wait(20)


# What is wrong with a page as it stands.
LOOK = r"""
const wrong = [], wide = innerWidth;
if (document.documentElement.scrollWidth > wide) wrong.push(`the page is ${document.documentElement.scrollWidth} wide`);
for (const part of document.querySelectorAll('main *')) {
  const box = part.getBoundingClientRect();
  const hidden = part.closest('.scroll, svg, .spoken, pre, [hidden]');
  if (!hidden && box.width > 0 && box.right > wide + 1) wrong.push(`<${part.localName} class="${part.className}"> ends at ${box.right.toFixed()} of ${wide}`);
}
for (const svg of document.querySelectorAll('figure svg')) {
  const name = svg.getAttribute('aria-label');
  if (svg.getBoundingClientRect().width < 200) wrong.push(`the chart ${name} is too small`);
  const drawn = svg.matches('.chart') ? svg.querySelectorAll('.curves path[data-name]') : svg.querySelectorAll('rect, circle, path');
  if (!drawn.length) wrong.push(`the chart ${name} is empty`);
}
for (const image of document.images) {
  if (image.getBoundingClientRect().width && !(image.complete && image.naturalWidth > 100)) wrong.push(`the picture ${image.alt} is not there`);
}
const figures = document.querySelectorAll('figure').length;
if (!figures) wrong.push('the page has no figure');
for (const canvas of document.querySelectorAll('canvas')) {
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let full = 0; const colours = new Set();
  for (let n = 0; n < data.length; n += 4) if (data[n + 3]) { full++; colours.add(data[n] << 16 | data[n + 1] << 8 | data[n + 2]); }
  if (full < 0.1 * data.length / 4 || colours.size < 50) wrong.push(`the view in space has ${full} pixels of ${colours.size} colours`);
}
const text = document.querySelector('main').innerText;
for (const word of ['NaN', 'undefined', 'Infinity', '{{ ', ' }}']) if (text.includes(word)) wrong.push(`the text has ${word}`);
return wrong;
"""
# What is wrong with the tables and the legends of a page, all of it unfolded.
TABLES = r"""
const wrong = [], folded = [...document.querySelectorAll('details:not([open])')];
for (const part of folded) part.open = true;
await new Promise(r => setTimeout(r, 60));
for (const [number, table] of [...document.querySelectorAll('table')].entries()) {
  const name = `table ${number + 1} (${table.textContent.trim().slice(0, 30)})`, heads = table.tHead ? [...table.tHead.rows[0].cells] : [];
  // On a narrow screen a row becomes a block, without heads and dashes.
  const stacked = table.matches('.stack') && getComputedStyle(table).display === 'block';
  for (const cell of table.querySelectorAll('td, th')) {
    const text = cell.innerText.trim() || cell.textContent.trim();
    if (!text || stacked && (cell.localName === 'th' || text === '–')) continue;
    const range = document.createRange();
    range.selectNodeContents(cell);
    const box = range.getBoundingClientRect(), style = getComputedStyle(cell), own = cell.getBoundingClientRect();
    const clipped = style.clipPath !== 'none' || style.overflow === 'hidden' && (own.width < box.width - 2 || own.height < box.height - 2);
    if (box.width < 4 || box.height < 8 || own.width < 4 || own.height < 8 || clipped || style.visibility !== 'visible' || +style.opacity < 0.3)
      wrong.push(`${name}: the text "${text.slice(0, 30)}" is not to be seen`);
    if (/NaN|undefined|Infinity|\bnull\b|not a number/i.test(text)) wrong.push(`${name}: a cell says "${text.slice(0, 30)}"`);
    if (/\.\d*000°|[1-9]\d*\.\d{6}|0\.0*[1-9]\d{6}/.test(text)) wrong.push(`${name}: too many digits in "${text.slice(0, 30)}"`);
  }
  if (stacked) continue;
  for (const row of table.tBodies[0] ? table.tBodies[0].rows : []) {
    if (heads.length && row.cells.length !== heads.length) { wrong.push(`${name}: ${row.cells.length} cells under ${heads.length} heads`); break; }
    const apart = [...row.cells].findIndex((cell, n) => heads[n] && Math.abs(cell.getBoundingClientRect().left - heads[n].getBoundingClientRect().left) > 1.5);
    if (apart >= 0) { wrong.push(`${name}: column ${apart + 1} does not stand under its head`); break; }
  }
}
for (const part of folded) part.open = false;
for (const svg of document.querySelectorAll('svg.chart')) {
  const name = svg.getAttribute('aria-label'), [, , top] = svg.dataset.box.split(' ').map(Number), looks = new Map();
  const paths = [...svg.querySelectorAll('.curves path[data-name]')].filter(path => path.dataset.name);
  for (const path of paths) {
    const mark = path.nextElementSibling && path.nextElementSibling.matches('.mark') ? path.nextElementSibling : null;
    const look = [path.getAttribute('stroke-dasharray'), path.getAttribute('stroke-linecap'), mark && mark.getAttribute('d'), mark && mark.getAttribute('fill') === 'none'];
    if (looks.has(look.join())) wrong.push(`the chart ${name}: ${path.dataset.name} and ${looks.get(look.join())} look alike without colour`);
    looks.set(look.join(), path.dataset.name);
  }
  const frame = svg.getBoundingClientRect(), scale = frame.width / svg.viewBox.baseVal.width;
  for (const text of svg.querySelectorAll(':scope > text')) {
    const box = text.getBoundingClientRect();
    if (box.right > frame.right + 2 || box.left < frame.left - 2) wrong.push(`the chart ${name}: "${text.textContent.slice(0, 30)}" is cut off`);
    if (paths.some(path => path.dataset.name.replaceAll('_', '') === text.textContent) && box.bottom - frame.top > top * scale + 2)
      wrong.push(`the chart ${name}: its legend stands inside the axes`);
  }
}
return wrong;
"""
PICTURE = """const c = document.querySelector('#view canvas'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
let sum = 0; for (let n = 0; n < d.length; n += 41) sum = (sum * 31 + d[n]) % 1000000007; return sum;"""
PLACE = """const part = document.querySelector('%s'); part.scrollIntoView({block: 'center'});
await new Promise(r => setTimeout(r, 60)); const b = part.getBoundingClientRect(); return [b.x, b.y, b.width, b.height];"""
TIP = "const t = document.querySelector('.chart-holder .tip'); return t.hidden ? '' : t.innerText;"
RESET = "return document.querySelector('.chart-holder .reset').hidden;"
TICKS = "return document.querySelector('svg.chart .ticks').textContent;"


def try_chart(browser, touch):
    """Values under the pointer, zoom by dragging, and back."""
    x, y, wide, tall = browser.evaluate(PLACE % "svg.chart")
    wrong = []
    middle = (x + 0.6 * wide, y + 0.6 * tall)
    if touch:
        browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": middle[0], "y": middle[1]}])
        browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    else:
        browser.mouse("mouseMoved", *middle)
    tip = browser.evaluate(TIP)
    if len(re.findall(r"\d", tip)) < 2:
        wrong.append(f"no values under the {'finger' if touch else 'pointer'}: {tip!r}")
    if touch:
        return wrong
    before = browser.evaluate(TICKS)
    browser.drag((x + 0.4 * wide, y + 0.6 * tall), (x + 0.7 * wide, y + 0.61 * tall))
    if browser.evaluate(RESET) or browser.evaluate(TICKS) == before:
        wrong.append("dragging a range does not zoom")
    for count in (1, 2):
        browser.mouse("mousePressed", *middle, button="left", clickCount=count)
        browser.mouse("mouseReleased", *middle, button="left", clickCount=count)
    if not browser.evaluate(RESET) or browser.evaluate(TICKS) != before:
        wrong.append("a double click does not lead back")
    browser.evaluate("document.querySelector('svg.chart').focus()")
    browser.key("+")
    if browser.evaluate(RESET):
        wrong.append("the key + does not zoom")
    browser.key("Escape")
    return wrong


def try_view(browser):
    """The time slider, play, turning by mouse and by keys."""
    rest = "await new Promise(r => setTimeout(r, 400));"
    wrong = []

    def changes(what, action):
        before = browser.evaluate(PICTURE)
        action()
        browser.evaluate(rest)
        if browser.evaluate(PICTURE) == before:
            wrong.append(f"{what} changes nothing")

    x, y, wide, tall = browser.evaluate(PLACE % "#view canvas")
    changes("dragging the view", lambda: browser.drag((x + 0.4 * wide, y + 0.5 * tall), (x + 0.6 * wide, y + 0.55 * tall)))
    browser.evaluate("document.querySelector('#view canvas').focus()")
    changes("an arrow key", lambda: browser.key("ArrowLeft"))
    changes("the wheel", lambda: browser.mouse("mouseWheel", x + 0.5 * wide, y + 0.5 * tall, deltaX=0, deltaY=-200))
    said = browser.evaluate("return document.querySelector('#view output').textContent")
    browser.evaluate("document.querySelector('#view input').focus()")
    changes("the time slider", lambda: [browser.key("ArrowLeft") for _ in range(2)])
    if browser.evaluate("return document.querySelector('#view output').textContent") == said:
        wrong.append("the slider does not say the time")
    browser.evaluate("document.querySelector('#view input').value = 0; document.querySelector('#view input').dispatchEvent(new Event('input'));")
    changes("play", lambda: browser.evaluate("document.querySelector('#view [data-play]').click();" + rest + rest))
    return wrong


def try_page(browser, name, path, keep):
    wrong = []
    for width in WIDTHS:
        for dark in (False, True):
            touch = width == 390
            where = f"{name}, {width} px, {'dark' if dark else 'light'}"
            browser.open(path, width, dark, touch)
            found = browser.evaluate(LOOK) + browser.evaluate(TABLES)
            if keep:
                shot = browser.call("Page.captureScreenshot", format="png", captureBeyondViewport=True)
                (keep / f"{name}_{width}_{'dark' if dark else 'light'}.png").write_bytes(base64.b64decode(shot["data"]))
            if browser.evaluate("return !!document.querySelector('svg.chart')"):
                found += try_chart(browser, touch)
            if not touch and not dark and browser.evaluate("return !!document.querySelector('#view')"):
                found += try_view(browser)
            wrong += [f"{where}: {what}" for what in found + browser.complaints()]
    return wrong + [f"{name}, on paper: {what}" for what in try_print(browser, name, keep)]


def try_print(browser, name, keep):
    """No empty page; what is folded is open."""
    browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
    browser.call("Emulation.setEmulatedMedia", media="", features=[])
    made = browser.call("Page.printToPDF", printBackground=False, preferCSSPageSize=False, paperWidth=8.27, paperHeight=11.69)
    pdf = base64.b64decode(made["data"])
    if keep:
        (keep / f"{name}.pdf").write_bytes(pdf)
    objects = dict(re.findall(rb"(?:^|\n)(\d+) 0 obj\n(.*?)\nendobj", pdf, re.S))
    pages = [re.search(rb"/Contents (\d+) 0 R", content) for content in objects.values() if re.search(rb"/Type /Page\b", content)]
    wrong = [] if pages else ["it has no pages"]
    for number, found in enumerate(pages, 1):
        stream = re.search(rb"stream\r?\n(.*?)\r?\nendstream", objects[found[1]], re.S)[1] if found else b""
        # The last byte may look like part of a line end; what is before it suffices.
        drawn = zlib.decompressobj().decompress(stream) if stream[:1] == b"\x78" else stream
        if len(re.findall(rb"\b(?:Tj|TJ|Do|S|f)\b", drawn)) < 3:
            wrong.append(f"page {number} of {len(pages)} is empty")
    browser.call("Emulation.setEmulatedMedia", media="print")
    if browser.evaluate("const p = document.querySelector('.typed pre'); return p && p.getBoundingClientRect().height < 20"):
        wrong.append("the case stays folded")
    return wrong


def make_pages(coulter, folder, run):
    """The pages of a run, a sweep, a comparison and a calibration."""
    def call(*arguments):
        done = subprocess.run([coulter, *map(str, arguments)], cwd=ROOT, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            sys.exit(f"coulter {' '.join(map(str, arguments))}: {done.stderr or done.stdout}")

    if run is None:
        run = folder / "run"
        call("run", "cases/towed_disc.toml", "-o", run, "--set", 'run.tow_distance="0.02 m"')
    copy = folder / "report"
    shutil.copytree(run, copy, symlinks=True, ignore=lambda *_: {"checkpoints"}, dirs_exist_ok=True)
    measured = folder / "measured.csv"
    measured.write_text("displacement [mm],drag [N],sinkage [mm]\n0,1,20\n5,20,24\n10,30,30\n20,42,38\n")
    call("report", copy, "--with", run, "--with", measured)
    call("compare", run, measured, "-o", folder / "compare")
    study = folder / "study.toml"
    study.write_text(STUDY)
    call("sweep", study, "-o", folder / "sweep")
    plate = folder / "plate.csv"
    plate.write_text("sinkage [mm],force [N]\n" + "".join(f"{z},{2.1 * z + 0.05 * z * z:.2f}\n" for z in range(5, 45, 5)))
    call("calibrate", "crates/studies/tests/calibration/plate.toml", plate, "--parameter", "soil.friction_angle=28 deg..45 deg", "-o", folder / "calibrate")
    return {
        "run": copy / "report.html",
        "sweep": folder / "sweep" / "report.html",
        "compare": folder / "compare" / "comparison.html",
        "calibrate": folder / "calibrate" / "calibration.html",
    }


# By closed forms alone.
STUDY = f"""
format = 2
case = "{ROOT / 'cases' / 'studies' / 'free_disc.toml'}"
title = "Angles and friction"
closed_forms = "all"
[factor.phi]
key = "soil.friction_angle"
range = ["30 deg", "42 deg"]
levels = 4
label = "friction angle φ"
[factor.mu]
key = "body.disc.friction"
range = [0.1, 0.6]
levels = 3
label = "friction μ"
[chart.drag]
x = "phi"
y = "drag"
family = "mu"
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter")
    parser.add_argument("--run", type=Path)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--pages", type=Path, nargs="+")
    arguments = parser.parse_args()
    began = time.monotonic()
    # Processes of the browser may still write into its profile as it ends.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        folder = Path(scratch)
        if arguments.keep:
            arguments.keep.mkdir(parents=True, exist_ok=True)
        if arguments.pages:
            pages = {page.parent.name + "_" + page.stem: page for page in arguments.pages}
        else:
            pages = make_pages(str(Path(arguments.coulter).resolve()), arguments.keep or folder, arguments.run)
        made = time.monotonic()
        browser = Browser(folder / "profile")
        wrong = []
        for name, page in pages.items():
            wrong += try_page(browser, name, page, arguments.keep)
        browser.close()
    for what in wrong:
        print(what, file=sys.stderr)
    now = time.monotonic()
    print(f"{len(pages)} pages, {len(wrong)} complaints; made in {made - began:.0f} s, tried in {now - made:.0f} s")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
