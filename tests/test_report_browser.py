"""The pages in a browser: no error, no sideways scrolling, readable colours, and a slider that moves the arm.

Left out where Chromium and its driver are not installed (Debian: chromium, chromium-driver).
"""

import re
import shutil

import pytest

from chainrule import papers
from chainrule.papers import page

pytestmark = pytest.mark.xdist_group("report")

ARMS = ["planar_3r", "panda", "orthogonal_3r_fig2a"]
PAGES = [*ARMS, "papers"]


@pytest.fixture(scope="module")
def browser():
    webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed (it is in the test extra)")
    binary = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    driver = shutil.which("chromedriver")
    if not (binary and driver):
        pytest.skip("Chromium and chromedriver are not installed (Debian: chromium, chromium-driver)")
    options = webdriver.ChromeOptions()
    options.binary_location = binary
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    found = webdriver.Chrome(options=options, service=webdriver.ChromeService(driver))
    yield found
    found.quit()


@pytest.fixture(scope="module")
def pages(report_of, tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    for name in ARMS:
        (folder / f"{name}.html").write_text(report_of(name)[1].html, "utf-8")
    shown = papers.figures("baili")
    few = {name: shown[name] for name in ("figure-2a", "figure-7")}
    (folder / "papers.html").write_text(page.html({"baili": papers.reproduce("baili")}, {"baili": few}), "utf-8")
    return folder


@pytest.fixture
def opened(browser, pages):
    """Open a page at a width, in a colour scheme; returns the browser."""

    def show(name, width=1280, scheme="light", **media):
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        features += [{"name": key.replace("_", "-"), "value": value} for key, value in media.items() if key != "media"]
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": media.get("media", ""), "features": features})
        size = {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 600}
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        browser.get((pages / f"{name}.html").as_uri())
        return browser

    yield show
    browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


#: What reaches beyond the right edge, apart from what scrolls by itself.
TOO_WIDE = """
const own = '.scroll, .drawing, .skip, svg, math', edge = document.documentElement.clientWidth + 1;
return [...document.querySelectorAll('body *')]
  .filter(e => !e.closest(own) && e.getBoundingClientRect().right > edge).map(e => e.outerHTML.slice(0, 80));
"""


@pytest.mark.parametrize("name", PAGES)
def test_no_error_and_no_sideways_scrolling(opened, name):
    for width in (360, 1280):
        browser = opened(name, width)
        widths = "const e = document.documentElement; return [e.scrollWidth, e.clientWidth, innerWidth]"
        content, inside, window = browser.execute_script(widths)
        assert content <= inside <= window == width
        assert browser.execute_script(TOO_WIDE) == []
    assert browser.get_log("browser") == []


@pytest.mark.parametrize("name", ARMS)
def test_every_section_is_there(opened, report_of, name):
    browser = opened(name)
    ids = browser.execute_script("return [...document.querySelectorAll('main > section')].map(e => e.id)")
    assert ids == list(report_of(name)[1].parts)


#: Text with too little contrast: each text node's colour against the nearest ground below it, by WCAG 2.
CONTRAST = """
const light = c => c.slice(0, 3).map(v => v / 255).map(v => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4)
  .reduce((sum, v, k) => sum + v * [.2126, .7152, .0722][k], 0);
const colour = text => { const n = text.match(/[0-9.]+/g).map(Number); return n.length < 4 ? [...n, 1] : n; };
const ratio = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + .05) / (y + .05); };
const bad = []; let count = 0;
const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walk.nextNode()) {
  const node = walk.currentNode, at = node.parentElement;
  if (!node.data.trim() || at.closest('script, style, title, desc, option, .skip')) continue;
  if (!at.getClientRects().length) continue;
  const style = getComputedStyle(at), inSvg = at.closest('svg') !== null;
  let ground = at;
  while (ground && colour(getComputedStyle(ground).backgroundColor)[3] === 0) ground = ground.parentElement;
  const below = colour(getComputedStyle(ground || document.body).backgroundColor);
  const ink = colour(inSvg ? style.fill : style.color), size = parseFloat(style.fontSize);
  const large = !inSvg && (size >= 24 || (size >= 18.66 && style.fontWeight >= 700));
  count += 1;
  if (ratio(ink, below) < (large ? 3 : 4.5)) bad.push([node.data.trim().slice(0, 40), ratio(ink, below).toFixed(2)]);
}
return [count, bad];
"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", PAGES)
def test_text_stands_out_from_its_ground(opened, name, scheme):
    browser = opened(name, scheme=scheme)
    browser.execute_script("document.querySelectorAll('details').forEach(e => { e.open = true; })")
    ground = browser.execute_script("return getComputedStyle(document.body).backgroundColor")
    assert (sum(map(int, re.findall("[0-9]+", ground))) > 380) == (scheme == "light")
    count, bad = browser.execute_script(CONTRAST)
    assert count > 100
    assert bad == []


PLACES = """
const f = document.querySelector('[data-motion]'), one = s => f.querySelector(s), at = (e, k) => e.getAttribute(k);
return {
  arm: at(one('.arm'), 'points'), tip: at(one('.tip'), 'cx') + ',' + at(one('.tip'), 'cy'),
  joints: [...f.querySelectorAll('.joint')].map(e => at(e, 'cx')), said: one('.said').textContent,
  text: at(one('input'), 'aria-valuetext'), k: Number(one('input').value),
  tracks: JSON.parse(one('script').textContent),
};
"""


def places(browser):
    """Where the arm, its joints and its tip are drawn, what is said of it, and all that could be."""
    return browser.execute_script(PLACES)


@pytest.mark.parametrize("name", ARMS)
def test_the_slider_moves_the_arm_by_keyboard(opened, name):
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    browser = opened(name)
    before = places(browser)
    slider = browser.find_element(By.CSS_SELECTOR, "[data-motion] input[type=range]")
    assert slider.accessible_name in ("Along the curve", "From one posture to the other")
    slider.send_keys(Keys.ARROW_RIGHT)
    after = places(browser)
    track = after["tracks"][0]
    assert after["k"] == before["k"] + 1
    assert after["arm"] == track["frames"][after["k"]] != before["arm"] == track["frames"][before["k"]]
    assert after["said"] == after["text"] == track["texts"][after["k"]]
    assert after["joints"] == [place.split(",")[0] for place in after["arm"].split()[1:-1]]
    assert after["tip"] == after["arm"].split()[-1]
    slider.send_keys(Keys.HOME)
    assert places(browser)["arm"] == track["frames"][0]
    slider.send_keys(Keys.END)
    assert places(browser)["arm"] == track["frames"][-1]
    assert browser.get_log("browser") == []


def test_pointing_at_the_chart_and_choosing_a_curve_move_the_arm(opened):
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.select import Select

    browser = opened("panda")
    chart = browser.find_element(By.CSS_SELECTOR, "[data-motion] .chart svg")
    browser.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", chart)
    ActionChains(browser).move_to_element_with_offset(chart, 0, 0).perform()
    here = places(browser)
    middle = (0.5 * 400 - 64) / (392 - 64) * (len(here["tracks"][0]["frames"]) - 1)  # the chart's frame, of 400 units
    assert abs(here["k"] - middle) <= 1.0
    assert here["arm"] == here["tracks"][0]["frames"][here["k"]]
    Select(browser.find_element(By.CSS_SELECTOR, "[data-motion] select")).select_by_index(2)
    there = places(browser)
    assert there["arm"] == there["tracks"][2]["frames"][there["k"]]
    ghosts = browser.execute_script(
        "return [...document.querySelectorAll('[data-motion] .ghost')].map(e => e.getAttribute('points'))"
    )
    assert set(ghosts) <= set(there["tracks"][2]["frames"])


def test_without_scripts_the_picture_remains_and_no_control_is_shown(opened, browser):
    browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    opened("panda")
    shown = browser.execute_script(
        "return [document.querySelector('.controls').getClientRects().length, "
        "document.querySelector('[data-motion] .arm').getBoundingClientRect().width > 50]"
    )
    assert shown == [0, True]


def test_nothing_moves_by_itself_and_printing_leaves_out_what_paper_cannot_do(opened):
    browser = opened("planar_3r", prefers_reduced_motion="reduce")
    assert browser.execute_script("return document.getAnimations().length") == 0
    assert browser.execute_script("return getComputedStyle(document.documentElement).scrollBehavior") == "auto"
    browser = opened("planar_3r", scheme="dark", media="print")
    gone = "return ['nav', '.controls'].map(s => getComputedStyle(document.querySelector(s)).display)"
    assert browser.execute_script(gone) == ["none", "none"]
    ground = browser.execute_script("return getComputedStyle(document.body).backgroundColor")
    assert min(map(int, re.findall("[0-9]+", ground))) > 240  # paper is white whatever the screen is
