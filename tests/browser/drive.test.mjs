// A robot is driven by a person's keys in Chromium; what was driven is kept, and leads to the same state.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { launch, openPage, serve, smallShop, take } from "./served.mjs";

const patience = 240_000; // milliseconds for a world to be built and shown, on a busy machine
const python = process.env.MARKETGEN_PYTHON ?? join(import.meta.dirname, "../../.venv/bin/python");
const package_ = process.env.MARKETGEN_PYTHON_PACKAGE ?? join(import.meta.dirname, "../../build/release/python");

let folder, server, address, browser;

before(async () => {
  ({ folder } = smallShop("drive", ["aisle"]));
  ({ server, address } = await serve([join(folder, "shop"), "--episodes", join(folder, "aisle.jsonl"), "--drives", join(folder, "drives")]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

const driving = async (options) => {
  const opened = await openPage(browser, `${address}?store=0&drive=`, options);
  await opened.page.waitForFunction(() => window.drive?.times.complete !== undefined && window.drive.app.last !== undefined, null, { timeout: patience });
  return opened;
};
const step = (page) => page.evaluate(() => window.drive.app.last.step);
const until = (page, holds, value) => page.waitForFunction(holds, value, { timeout: patience });

test("the store's page leads to the choice, and the choice to the robot, by keyboard alone", async () => {
  const { page, faults, close } = await openPage(browser, address);
  await page.locator("a.to-drive").waitFor({ timeout: patience });
  await page.locator("a.to-drive").focus();
  await page.keyboard.press("Enter");
  await page.locator(".drive-choose button.main").waitFor({ timeout: patience });
  await take(page, "drive-choose");
  assert.match(await page.locator(".drive-choose option").first().textContent(), /aisle/i);
  await page.locator(".drive-choose button.main").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.drive?.times.complete !== undefined && window.drive.app.last !== undefined, null, { timeout: patience });
  assert.equal(await step(page), 0, "time waits for the driver");
  await take(page, "drive-first");
  assert.deepEqual(faults, []);
  await close();
});

test("keys drive the base and move the arm, the gripper closes, and the log leads to the same state", async () => {
  const { page, faults, close } = await driving();
  const at = () => page.evaluate(() => window.drive.app.player.robotAt.slice(0, 2));
  const from = await at();
  await page.keyboard.down("w");
  await until(page, () => window.drive.app.last.step >= 25);
  await page.keyboard.up("w");
  await until(page, ([x, y]) => Math.hypot(window.drive.app.player.robotAt[0] - x, window.drive.app.player.robotAt[1] - y) > 0.15, from);
  // What the picture has: frames come when the browser has drawn them.
  const high = await page.evaluate(() => {
    const { player } = window.drive.app;
    const link = player.replay.bodies.indexOf("left_link7");
    window.handHeight = () => player.bodyAt(link)[2];
    return window.handHeight();
  });
  await page.keyboard.down("o");
  await until(page, (high) => window.handHeight() < high - 0.03, high);
  await page.keyboard.up("o");
  await page.keyboard.press(" ");
  await until(page, () => window.drive.app.last.openings[0] === -1);
  await page.keyboard.press("x");
  assert.equal(await page.evaluate(() => window.drive.app.controls.arm), 1);
  await page.keyboard.press("c");
  await until(page, () => window.drive.app.camera.picture !== undefined);
  await take(page, "drive-under-way");
  await page.keyboard.press("p");
  await until(page, () => !window.drive.app.last.runs);
  const paused = await step(page);
  await page.waitForTimeout(300);
  assert.equal(await step(page), paused);
  await page.keyboard.press("p");
  await until(page, () => window.drive.app.last.runs);
  await page.keyboard.press("End");
  await until(page, () => window.drive.app.last.verdict !== undefined);
  assert.equal(await page.locator(".driving .outcome").textContent().then((text) => /of \d goals/.test(text)), true);
  await page.keyboard.press("v");
  await until(page, () => window.drive.app.savedFile !== "");
  await take(page, "drive-done");
  const file = await page.evaluate(() => window.drive.app.savedFile);
  const [log] = gunzipSync(readFileSync(file)).toString().split("\n").map((line) => line && JSON.parse(line));
  assert.equal(log.schema, "market-drive/1");
  assert.equal(log.over, true);
  assert.equal(log.actions.length / log.action_names.length, (await step(page)) + 1, "the stop takes no time");
  assert.deepEqual(faults, []);
  await close();

  // The demonstration that is made of it is read back, and its actions lead to its states.
  const environment = { ...process.env, PYTHONPATH: package_ };
  const record = (...words) => execFileSync(python, ["-m", "marketgen.record", ...words, "--quiet"], { cwd: folder, env: environment, stdio: ["ignore", "pipe", "inherit"] }).toString();
  assert.match(record("--teleop", file, "-o", "driven", "--cameras", "none"), /1 episodes/);
  assert.match(record("driven.episodes.jsonl", "--check", "driven"), /bit for bit/);
});

test("a page that goes leaves a robot that stands, and the next one takes over; meanwhile others look on", async () => {
  const first = await driving();
  await first.page.keyboard.press("Home");
  await until(first.page, () => window.drive.app.last.step === 0);
  const second = await driving();
  assert.equal(await second.page.evaluate(() => window.drive.app.seat.drives), false);
  await first.page.keyboard.down("w");
  await until(second.page, () => window.drive.app.last.step >= 10);
  await first.close();
  await until(second.page, () => !window.drive.app.seat.taken);
  await second.page.waitForTimeout(1500);
  const left = await step(second.page);
  await second.page.waitForTimeout(500);
  assert.equal(await step(second.page), left, "time stands while nobody drives");
  await second.page.locator(".drive-buttons button", { hasText: "Drive" }).click();
  await until(second.page, () => window.drive.app.seat.drives);
  await second.page.keyboard.down("s");
  await until(second.page, (left) => window.drive.app.last.step > left, left);
  assert.deepEqual(second.faults, []);
  await second.close();
});

// With three pixels of glass a pixel of the page, Chromium without a GPU would draw nine times as much; the page is as wide either way.
test("fingers drive at a phone's width, with both hands", async () => {
  const { page, faults, close } = await driving({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true, deviceScaleFactor: 1 });
  await until(page, () => window.drive.app.seat.drives);
  for (const part of [".driving", ".drive-touch"]) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390 && box.y >= 0 && box.y + box.height <= 780, `${part} is at ${JSON.stringify(box)}`);
  }
  for (const button of await page.locator(".touch-buttons button").all()) {
    const box = await button.boundingBox();
    assert.ok(box.width >= 44 && box.height >= 44, `${await button.textContent()} is ${box.width} x ${box.height}`);
  }
  const panel = await page.locator(".driving").boundingBox();
  const pads = await page.locator(".drive-touch").boundingBox();
  assert.ok(panel.y + panel.height < pads.y, "the picture is between the panel and the sticks");
  await page.locator(".drive-buttons button", { hasText: "From the beginning" }).tap();
  await until(page, () => window.drive.app.last.step === 0);
  const middle = async (part) => {
    const { x, y, width, height } = await page.locator(part).boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const [wheel, arm] = [await middle("[data-stick=drive]"), await middle("[data-stick=move]")];
  const hand = await page.context().newCDPSession(page);
  const touch = (type, ...fingers) => hand.send("Input.dispatchTouchEvent", { type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })) });
  const from = await page.evaluate(() => window.drive.app.player.robotAt.slice(0, 2));
  await touch("touchStart", wheel, arm);
  await touch("touchMove", [wheel[0], wheel[1] - 60], [arm[0] + 40, arm[1]]);
  assert.deepEqual(await page.evaluate(() => window.drive.app.touch.axes.map((value) => Math.round(value * 100) / 100)), [0, -1, 0.91, 0]);
  await until(page, ([x, y]) => Math.hypot(window.drive.app.player.robotAt[0] - x, window.drive.app.player.robotAt[1] - y) > 0.04, from); // then its arm leans on a shelf
  await take(page, "drive-phone");
  await touch("touchEnd");
  assert.deepEqual(await page.evaluate(() => [...window.drive.app.touch.axes]), [0, 0, 0, 0]);
  const [x, y] = await middle("[data-pad=grip]");
  await touch("touchStart", [x, y]);
  await until(page, () => window.drive.app.last.openings[0] === -1);
  await touch("touchEnd");
  assert.deepEqual(faults, []);
  await close();
});

test("an environment of Python is looked on as it is stepped, and not driven", async () => {
  const environment = { ...process.env, PYTHONPATH: package_ };
  const script = spawn(python, [join(import.meta.dirname, "watched_env.py"), join(folder, "shop"), join(folder, "aisle.jsonl")], { env: environment, stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: script.stdout })[Symbol.asyncIterator]();
  const said = async () => (await lines.next()).value;
  try {
    const { page, faults, close } = await openPage(browser, await said());
    await page.waitForFunction(() => window.drive?.times.complete !== undefined && window.drive.app.last !== undefined, null, { timeout: patience });
    assert.equal(await step(page), 0);
    assert.equal(await page.locator(".drive-buttons").isHidden(), true);
    assert.match(await page.locator(".driving").textContent(), /A program acts/);
    const at = () => page.evaluate(() => [...window.drive.app.player.robotAt.slice(0, 3)]);
    const from = await at();
    script.stdin.write("30\n");
    const seconds = JSON.parse(await said());
    await until(page, () => window.drive.app.last.step === 30);
    assert.ok(Math.abs((await page.evaluate(() => window.drive.app.last.time_s)) - seconds) < 1e-6);
    await page.waitForFunction((from) => Math.hypot(...window.drive.app.player.robotAt.slice(0, 2).map((x, k) => x - from[k])) > 0.05, from, { timeout: patience });
    await take(page, "watched");
    assert.deepEqual(faults, []);
    await close();
  } finally {
    script.stdin.end();
  }
});
