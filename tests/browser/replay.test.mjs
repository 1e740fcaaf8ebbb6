// Recorded episodes as a person watches them: Debian's Chromium, drawing without a GPU, plays evaluations of a small store.
import assert from "node:assert/strict";
import { readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { launch, openPage, serve, smallShop, take } from "./served.mjs";

const patience = 180_000; // milliseconds for a place to be built and shown, on a busy machine
const runs = ["oracle", "stop", "plain", "aisle"];

let folder, run, server, address, browser;

before(async () => {
  ({ folder, run } = smallShop("replay", ["checkout"]));
  run("episodes", "shop", "--track", "aisle", "--count", "1", "--seed", "5", "-o", "aisle.jsonl");  // that the oracle solves
  run("eval", "--episodes", "checkout.jsonl", "--policy", "oracle", "--record-motion", "-o", "oracle");
  run("eval", "--episodes", "checkout.jsonl", "--policy", "stop", "--record-motion", "-o", "stop");
  run("eval", "--episodes", "checkout.jsonl", "--policy", "stop", "-o", "plain");
  run("eval", "--episodes", "aisle.jsonl", "--policy", "oracle", "--record-motion", "-o", "aisle");
  ({ server, address } = await serve([join(folder, "shop"), ...runs.flatMap((name) => ["--results", join(folder, name)])]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

const list = "?store=0&replay=";
const open = (search, options) => openPage(browser, address + search, options);
const openEpisode = async (name, options) => {
  const opened = await open(`${list}&run=${runs.indexOf(name)}&episode=0`, options);
  await opened.page.waitForFunction(() => window.replay?.times.complete !== undefined, null, { timeout: patience });
  return opened;
};

// What of a market-motion/1 a test compares: a FlatBuffer with its size before it (schemas/market-motion-1.fbs).
function readMotion(name) {
  const { results } = JSON.parse(`{"results":[${readFileSync(join(folder, name, "results.jsonl"), "utf8").trim().replaceAll("\n", ",")}]}`);
  const bytes = gunzipSync(readFileSync(join(folder, name, "motion", `${results[0].episode}.bin.gz`)));
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const pointed = (at) => at + data.getUint32(at, true);
  const field = (table, number) => {
    const rows = table - data.getInt32(table, true);
    const place = 4 + 2 * number;
    const off = place < data.getUint16(rows, true) ? data.getUint16(rows + place, true) : 0;
    return off === 0 ? undefined : table + off;
  };
  const list = (at, size, read) => {
    const start = pointed(at);
    return Array.from({ length: data.getUint32(start, true) }, (_, i) => read(start + 4 + i * size));
  };
  const root = pointed(4);
  const dofs = list(field(root, 9), 4, (at) => at).length;
  const states = list(field(root, 10), 4, (at) => data.getFloat32(at, true));
  const things = list(field(root, 11), 4, (at) => list(field(pointed(at), 4), 4, (pose) => data.getFloat32(pose, true)));
  return { steps: states.length / dofs, things };
}

// Where everything is on the stage: position, and the rotation as a matrix.
const stands = (page) =>
  page.evaluate(() => {
    const [player] = window.replay.app.players;
    return player.replay.things.map((_, i) => player.thingMatrix(i));
  });

function matrixOf([x, y, z, qw, qx, qy, qz]) {
  return [
    [1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + qz * qw), 2 * (qx * qz - qy * qw), 0],
    [2 * (qx * qy - qz * qw), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz + qx * qw), 0],
    [2 * (qx * qz + qy * qw), 2 * (qy * qz - qx * qw), 1 - 2 * (qx * qx + qy * qy), 0],
    [x, y, z, 1],
  ].flat();
}

for (const name of ["oracle", "aisle"]) {
  test(`an episode is played to its end, where everything stands as it was recorded: ${name}`, async () => {
    const { page, faults, close } = await openEpisode(name);
    const motion = readMotion(name);
    await take(page, `replay-${name}-first`);
    const near = (matrices, poses) =>
      matrices.forEach((matrix, i) => matrixOf(poses[i]).forEach((wanted, k) => assert.ok(Math.abs(matrix[k] - wanted) < 2e-4, `thing ${i}: ${matrix} and ${poses[i]}`)));
    const first = await stands(page);
    near(first, motion.things.map((poses) => poses.slice(0, 7)));
    for (let i = 0; i < 3; i++) await page.keyboard.press("]");
    await page.keyboard.press(" ");
    await page.waitForFunction(() => window.replay.app.clock.atEnd && !window.replay.app.waiting, null, { timeout: patience });
    await page.waitForTimeout(1500);
    await take(page, `replay-${name}-last`);
    const last = await stands(page);
    assert.equal(await page.evaluate(() => window.replay.app.clock.steps), motion.steps);
    assert.equal(last.length, motion.things.length);
    let moved = 0;
    near(last, motion.things.map((poses) => poses.slice(-7)));
    last.forEach((matrix, i) => {
      if (Math.hypot(...[12, 13, 14].map((k) => matrix[k] - first[i][k])) > 0.2) moved++;
    });
    assert.ok(moved >= 2, `${moved} things were carried`);
    assert.equal(await page.locator('.goals li[data-state="met"]').count(), await page.locator(".goals li").count());
    assert.deepEqual(faults, []);
    await close();
  });
}

test("the robot moves, and what it carries moves with it", async () => {
  const { page, faults, close } = await openEpisode("oracle");
  const held = await page.evaluate(() => {
    const { app } = window.replay;
    const [player] = app.players;
    const event = player.replay.events.find(({ kind }) => kind === "held");
    const thing = player.replay.things.findIndex(({ kind, number }) => kind === event.target && number === event.number);
    const hand = player.replay.bodies.findIndex((name) => name.includes("finger"));
    const at = (step) => {
      app.seek(step);
      player.show(step);
      return [player.bodyAt(hand), player.thingAt(thing)];
    };
    const apart = ([a, b]) => Math.hypot(...a.map((x, k) => x - b[k]));
    const middle = Math.round((event.step + event.last_step) / 2);
    const [before, after] = [at(event.step + 10), at(middle)];
    return { way: apart([before[0], after[0]]), slip: Math.abs(apart(before) - apart(after)) };
  });
  assert.ok(held.way > 0.05, `the hand went ${held.way} m`);
  assert.ok(held.slip < 0.02, `the item slipped ${held.slip} m`);
  assert.deepEqual(faults, []);
  await close();
});

test("it plays in real time without a GPU", async () => {
  const { page, close } = await openEpisode("aisle");
  const share = await page.evaluate(async () => {
    const { app } = window.replay;
    app.seek(0);
    app.clock.playing = true;
    await new Promise((done) => setTimeout(done, 1000));
    const [from, began] = [app.clock.seconds, performance.now()];
    await new Promise((done) => setTimeout(done, 6000));
    return ((app.clock.seconds - from) * 1000) / (performance.now() - began);
  });
  assert.ok(share > 0.8, `${share} of real time`);
  await close();
});

test("by keyboard alone: from the list into an episode, by steps, to events and back to its beginning", async () => {
  const { page, faults, close } = await open(list);
  await page.locator("table").first().waitFor({ timeout: patience });
  await take(page, "replay-list");
  assert.equal(await page.locator("section").count(), runs.length);
  for (let i = 0; i < 12 && !(await page.evaluate(() => document.activeElement.textContent === "Watch")); i++) await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.replay?.times.complete !== undefined, null, { timeout: patience });
  const step = () => page.evaluate(() => window.replay.app.clock.step);
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  await page.keyboard.press(",");
  assert.equal(Math.round(await step()), 1);
  await page.keyboard.press("n");
  const event = await page.evaluate(() => window.replay.app.players[0].replay.events.find(({ kind, force_n: force }) => kind !== "contact" || force > 10).step);
  assert.equal(Math.round(await step()), event);
  await page.keyboard.press("End");
  assert.equal(Math.round(await step()), await page.evaluate(() => window.replay.app.clock.steps - 1));
  await page.keyboard.press("Home");
  assert.equal(await step(), 0);
  await page.keyboard.press("?");
  assert.equal(await page.locator("dialog[open]").count(), 1);
  await page.keyboard.press("Escape");
  assert.deepEqual(faults, []);
  await close();
});

test("episodes are chosen by how they ended, and failures say their code", async () => {
  const { page, faults, close } = await open(list);
  await page.locator("table").first().waitFor({ timeout: patience });
  await page.locator(".choices select").nth(1).selectOption("failed");
  assert.equal(await page.locator("tbody tr").count(), 2);
  assert.equal(await page.locator("tbody a").count(), 1, "one of them was not recorded");
  await page.locator(".choices select").nth(1).selectOption("solved");
  assert.equal(await page.locator("tbody tr").count(), 2);
  assert.deepEqual(faults, []);
  await close();
});

test("what was not recorded is said, with its remedy", async () => {
  const { page, close } = await open(`${list}&run=${runs.indexOf("plain")}&episode=0`);
  await page.locator(".fault .code").waitFor({ timeout: patience });
  assert.match(await page.locator(".fault p").first().textContent(), /--record-motion/);
  assert.equal(await page.locator(".fault .code").textContent(), "results.no_motion");
  await close();
});

test("a camera's picture stands beside, and follows the time", async () => {
  const { page, faults, close } = await openEpisode("oracle");
  await page.keyboard.press("c");
  const taken = (step) => page.waitForFunction((step) => window.replay.app.camera.picture === `scene_camera ${step}`, step, { timeout: patience });
  const colors = () =>
    page.evaluate(() => {
      const canvas = document.querySelector(".camera canvas");
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      return [...copy.getImageData(0, 0, canvas.width, canvas.height).data];
    });
  await taken(0);
  const first = await colors();
  const end = await page.evaluate(() => window.replay.app.clock.steps - 1);
  await page.locator("canvas").first().focus();
  await page.keyboard.press("End");
  await taken(end);
  await take(page, "replay-camera");
  const last = await colors();
  assert.equal(first.length, 480 * 360 * 4);
  assert.ok(first.filter((value, i) => Math.abs(value - last[i]) > 30).length > 2000, "what was carried is seen elsewhere");
  await page.locator(".camera select").selectOption("wrist_camera");
  await page.waitForFunction((step) => window.replay.app.camera.picture === `wrist_camera ${step}`, end, { timeout: patience });
  assert.deepEqual(faults, []);
  await close();
});

test("two policies at the same episode stand side by side, each with its own goods and goals", async () => {
  const { page, faults, close } = await openEpisode("oracle", { viewport: { width: 1280, height: 720 } });
  await page.locator(".beside select").selectOption({ index: 1 });
  await page.waitForFunction(() => window.replay?.app?.players.length === 2 && window.replay.times.complete !== undefined, null, { timeout: patience });
  const end = await page.evaluate(() => window.replay.app.clock.steps - 1);
  await page.evaluate((end) => window.replay.app.seek(end), end);
  await page.waitForTimeout(2500);
  await take(page, "replay-beside");
  const { goals, apart, lit } = await page.evaluate(() => {
    const { app, stage } = window.replay;
    const [left, right] = app.players;
    const goals = left.replay.things.flatMap(({ goal }, i) => (goal ? [i] : []));
    stage.draw(true);
    const gl = stage.renderer.getContext();
    const at = (x) => {
      const pixel = new Uint8Array(4);
      gl.readPixels(Math.round(gl.drawingBufferWidth * x), gl.drawingBufferHeight / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return pixel[0] + pixel[1] + pixel[2];
    };
    return { goals: goals.length, apart: goals.map((i) => Math.hypot(...left.thingAt(i).map((x, k) => x - right.thingAt(i)[k]))), lit: [0.25, 0.75].map(at) };
  });
  assert.ok(goals > 0 && apart.every((metres) => metres > 0.1), `goals are ${apart} m apart`);
  assert.ok(lit.every((sum) => sum > 0), "both halves are drawn");
  const states = await page.evaluate(() => [...document.querySelectorAll(".replay-info")].map((panel) => [...panel.querySelectorAll(".goals li")].map((li) => li.dataset.state)));
  assert.ok(states[0].every((state) => state === "met") && states[1].every((state) => state === "missed"), JSON.stringify(states));
  assert.deepEqual(faults, []);
  await close();
});

test("failures are a gallery of how they ended, each a link to its episode", async () => {
  const { page, faults, close } = await open(list);
  await page.locator("table").first().waitFor({ timeout: patience });
  await page.locator(".choices select").nth(1).selectOption("failed");
  await page.locator(".choices input").check();
  await page.waitForFunction(() => document.querySelector(".gallery a canvas")?.dataset.taken === "1", null, { timeout: patience });
  await take(page, "replay-gallery");
  assert.equal(await page.locator(".figure").count(), 2);
  const colors = await page.evaluate(() => new Set(document.querySelector(".gallery a canvas").getContext("2d").getImageData(0, 0, 320, 240).data).size);
  assert.ok(colors > 50, `${colors} values in the picture`);
  await page.locator(".gallery a").click();
  await page.waitForFunction(() => window.replay?.times.complete !== undefined, null, { timeout: patience });
  assert.deepEqual(faults, []);
  await close();
});

test("the store's page leads to its episodes", async () => {
  const { page, faults, close } = await open("");
  await page.locator("a.to-episodes").click({ timeout: patience });
  await page.locator("table").first().waitFor({ timeout: patience });
  assert.deepEqual(faults, []);
  await close();
});

test("on a phone, in the dark and in Chinese everything has its place", async () => {
  const { page, faults, close } = await openEpisode("stop", { viewport: { width: 390, height: 760 }, locale: "zh-CN", colorScheme: "dark", hasTouch: true, isMobile: true });
  await take(page, "replay-phone");
  assert.match(await page.locator(".replay-info h2").first().textContent(), /目标/);
  const boxes = await page.evaluate(() => ({
    info: document.querySelector(".replay-info").getBoundingClientRect().bottom,
    player: document.querySelector(".player").getBoundingClientRect().top,
    wide: document.documentElement.scrollWidth,
    background: getComputedStyle(document.querySelector(".player")).backgroundColor,
  }));
  assert.ok(boxes.info <= boxes.player, "panels overlap");
  assert.ok(boxes.wide <= 390, `${boxes.wide} px wide`);
  assert.match(boxes.background, /^rgba?\(29, 32, 36/);
  assert.deepEqual(faults, []);
  await close();
});
