// The page on a phone, 390 x 844 and under fingers: nothing sticks out, nothing lies over anything else, and whatever is pressed is 44
// pixels wide and high, in every state of the page.
import assert from "node:assert/strict";
import { rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, openPage, serve, smallShop, take } from "./served.mjs";

const patience = 240_000; // milliseconds for a store or a place to be built and shown, on a busy machine

let folder, run, server, address, browser;

before(async () => {
  ({ folder, run } = smallShop("phone", ["checkout", "aisle"]));
  for (const name of ["one", "two"]) run("eval", "--episodes", "checkout.jsonl", "--policy", "stop", "--record-motion", "-o", name);
  const results = ["one", "two"].flatMap((name) => ["--results", join(folder, name)]);
  ({ server, address } = await serve([join(folder, "shop"), ...results, "--episodes", join(folder, "aisle.jsonl"), "--drives", join(folder, "drives"), "--make-in", join(folder, "made")]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

// What is wrong with the page as it stands, in words.
function faultsOfLayout() {
  const [wide, high] = [innerWidth, innerHeight];
  const found = new Set();
  const nameOf = (part) => `${part.tagName.toLowerCase()}.${[...part.classList].join(".")} "${(part.getAttribute("aria-label") ?? part.textContent ?? "").trim().slice(0, 30)}"`;
  const isInScroller = (part) => {
    for (let at = part.parentElement; at && at !== document.body; at = at.parentElement)
      if (/auto|scroll|hidden/.test(getComputedStyle(at).overflowX)) return true;
    return false;
  };
  const box = (part) => part.getBoundingClientRect();
  const isSeen = (part) => box(part).width > 0 && box(part).height > 0 && getComputedStyle(part).visibility !== "hidden";
  if (document.documentElement.scrollWidth > wide) found.add(`the page is ${document.documentElement.scrollWidth} px wide`);
  for (const part of document.body.querySelectorAll("*")) {
    if (!isSeen(part) || part.closest("svg, .marks, option")) continue;
    const { left, right, top, bottom, width, height } = box(part);
    const where = `${Math.round(left)}..${Math.round(right)}, ${Math.round(top)}..${Math.round(bottom)}`;
    const isOut = left < -0.5 || right > wide + 0.5 || (getComputedStyle(part).position === "fixed" && (top < -0.5 || bottom > high + 0.5));
    if (isOut && !isInScroller(part)) found.add(`${nameOf(part)} sticks out: ${where}`);
    if (!part.matches("button, a[href], input:not([type=file]), select, textarea, summary") || part.closest(".wall")) continue;
    const pressed = part.matches("[type=checkbox]") ? box(part.closest("label")) : { width, height };
    if (pressed.width < 43.5 || pressed.height < 43.5) found.add(`${nameOf(part)} is ${Math.round(pressed.width)} x ${Math.round(pressed.height)} px`);
  }
  const panels = [...document.querySelectorAll(".panel, .drive-touch")].filter((part) => isSeen(part) && getComputedStyle(part).position === "fixed" && !part.closest("dialog, .menu"));
  for (const [i, one] of panels.entries())
    for (const other of panels.slice(i + 1)) {
      const across = Math.min(box(one).right, box(other).right) - Math.max(box(one).left, box(other).left);
      const down = Math.min(box(one).bottom, box(other).bottom) - Math.max(box(one).top, box(other).top);
      if (across > 1 && down > 1 && !one.contains(other) && !other.contains(one)) found.add(`${nameOf(one)} and ${nameOf(other)} overlap by ${Math.round(down)} px`);
    }
  return [...found];
}

const shown = (what) => (page) => page.waitForFunction((name) => window[name]?.times.complete !== undefined, what, { timeout: patience });
const ofStore = (then) => async (page) => {
  await shown("marketgen")(page);
  await then?.(page);
};
const ofFixture = (wanted) => async (page) => {
  const row = await page.evaluate(async (wanted) => {
    const { fixtures, joints } = await (await fetch("api/stores/0")).json();
    return wanted === "moving" ? joints[0].fixture : fixtures.find(({ kind, run }) => kind.replaceAll("-", "_").startsWith(wanted) && run).row;
  }, wanted);
  await page.evaluate((row) => void (location.hash = `#fixture=${row}`), row);
  await page.locator(".card").waitFor({ timeout: patience });
};
const search = async (page) => {
  await page.locator("input[type=search]").fill("milk");
  await page.locator(".hits li").first().waitFor({ timeout: patience });
};

// By name: the address, what one waits for and does, and what must be in sight.
const states = {
  store: ["", ofStore(), [".search", ".toolbar"]],
  found: ["", ofStore(search), [".hits"]],
  card: ["", ofStore(async (page) => {
    await search(page);
    await page.locator(".hits li").first().tap();
    await page.locator(".card").waitFor({ timeout: patience });
  }), [".card", ".toolbar", "input[type=search]"]],
  moving: ["", ofStore(ofFixture("moving")), [".card", ".toolbar"]],
  elevation: ["", ofStore(async (page) => {
    await ofFixture("wall_unit")(page);
    await page.locator(".card .buttons button").click({ timeout: patience });
    await page.locator(".wall button").first().waitFor({ timeout: patience });
  }), [".elevation", ".card"]],
  layers: ["", ofStore((page) => page.keyboard.press("l")), [".layers", ".toolbar"]],
  menu: ["", ofStore((page) => page.locator(".toolbar .menu-root button").last().tap()), [".menu"]],
  help: ["", ofStore((page) => page.keyboard.press("?")), [".help"]],
  edit: ["", ofStore(async (page) => {
    await page.keyboard.press("r");
    await page.locator(".edit .zone").first().waitFor({ timeout: patience });
    await page.locator(".edit .zone").nth(1).tap({ force: true });
    await page.locator(".zone-card").waitFor({ timeout: patience });
  }), [".edit", ".toolbar"]],
  list: ["?store=0&replay=", (page) => page.locator(".rows table").first().waitFor({ timeout: patience }), [".rows td a"]],
  replay: ["?store=0&replay=&run=0&episode=0", async (page) => {
    await shown("replay")(page);
    await page.keyboard.press("c");
    await page.locator(".camera").waitFor({ timeout: patience });
  }, [".player", ".replay-info", ".camera"]],
  beside: ["?store=0&replay=&run=0&episode=0&beside=1", shown("replay"), [".player", ".replay-info.right"]],
  choose: ["?store=0&drive=", (page) => page.locator(".drive-choose button.main").waitFor({ timeout: patience }), [".drive-choose button.main"]],
  make: ["?make", async (page) => {
    await page.locator(".ask summary").waitFor({ timeout: patience });
    await page.locator(".ask summary").tap();
  }, [".ask textarea"]],
};

// Opening a page takes longest: each look has half of the states.
const looks = [["light", "en-GB"], ["dark", "zh-CN"]];
for (const [i, [name, [at, prepare, parts]]] of Object.entries(states).entries()) {
  const [colorScheme, locale] = looks[i % looks.length];
  test(`on a phone everything has its place and can be pressed: ${name}, ${colorScheme}, ${locale}`, { timeout: 2 * patience }, async () => {
    const { page, faults, close } = await openPage(browser, address + at, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 1, colorScheme, locale });
    await prepare(page);
    await page.waitForTimeout(300);
    await take(page, `phone-${name}`);
    assert.deepEqual(await page.evaluate(faultsOfLayout), []);
    for (const part of parts) {
      const { x, y, width, height } = await page.locator(part).first().boundingBox();
      assert.ok(x >= 0 && x + width <= 390 && y >= 0 && y < 844 && height > 0, `${part} is in sight: ${x}, ${y}, ${width} x ${height}`);
    }
    assert.deepEqual(faults, []);
    await close();
  });
}
