// `marketgen view` as a person has it: Debian's Chromium, drawing without a GPU, opens the page of a small store. Pictures that were
// taken lie in MARKETGEN_BROWSER_PICTURES, where that names a folder.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { gradient, shareWithin, shiftOf, shiftsOfTiles, strongest } from "./edges.mjs";
import { launch, openPage, pictures, program, serve, take } from "./served.mjs";

const patience = 120_000; // milliseconds for the store to be built and shown, on a busy machine

let folder, store, server, address, browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "marketgen-browser-"));
  store = join(folder, "shop");
  execFileSync(program, ["generate", "a small shop with dairy and two checkouts", "--size", "12x9m", "--seed", "3", "--no-previews", "--quiet", "-o", store]);
  ({ server, address } = await serve([store]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

const open = (hash = "", options = {}, arrange = async () => {}, at = address) => openPage(browser, at + hash, options, arrange);

const complete = (page) => page.waitForFunction(() => window.marketgen?.times.complete !== undefined, null, { timeout: patience });
// The picture shows what the navigator means, with its labels.
const settled = (page) =>
  page.waitForFunction(
    () => {
      const { stage, app } = window.marketgen;
      const shown = app.navigator.pose.eye.every((x, k) => Math.abs(stage.camera.position.getComponent(k) - x) < 1e-6);
      return shown && !app.navigator.moving && stage.goods?.labelsSettled;
    },
    null,
    { timeout: patience },
  );

// The address of a place right before a front-row product, with the product in the middle of the picture.
async function beforeAProduct(page, sku) {
  return page.evaluate((sku) => {
    const { goods } = window.marketgen.stage;
    const { table } = goods;
    for (let row = 0; row < table.count; row++) {
      const [x, y, z, w] = table.rotation.subarray(row * 4, row * 4 + 4).map((value) => value);
      if (table.rank[row] !== 0 || x !== 0 || y !== 0) continue;
      const product = goods.skus[table.sku[row]];
      if (sku && product.sku !== sku) continue;
      const yaw = 2 * Math.atan2(z, w);
      const [px, py, pz] = table.position.subarray(row * 3, row * 3 + 3);
      const eye = [px + 0.6 * Math.sin(yaw), py - 0.6 * Math.cos(yaw), pz + product.size_m[2] / 2];
      return { row, sku: product.sku, hash: `#mode=fly&eye=${eye.join(",")}&look=${yaw + Math.PI / 2},0` };
    }
    return undefined;
  }, sku);
}

test("the store is shown, within its limits and without complaints", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  await settled(page);
  await take(page, "first");
  const seen = await page.evaluate(async () => {
    const summary = await (await fetch("api/stores/0")).json();
    const { figures, goods } = window.marketgen.stage;
    return { figures, wanted: summary.counts.products, placed: goods.table.count, name: summary.name, heading: document.querySelector("h1").textContent };
  });
  assert.equal(seen.placed, seen.wanted);
  assert.equal(seen.heading, seen.name);
  assert.ok(seen.figures.calls > 5 && seen.figures.calls < 300, `${seen.figures.calls} draw calls`);
  assert.deepEqual(faults, []);
  await close();
});

test("a click on a known point picks the product that is there", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  const there = await beforeAProduct(page);
  await goTo(page, there.hash);
  await settled(page);
  await page.mouse.click(640, 360);
  await page.locator(".card dd", { hasText: there.sku }).waitFor({ timeout: patience });
  await take(page, "product");
  assert.match(await page.evaluate(() => (window.marketgen.app.writeAddress(), location.hash)), /product=\d+/);
  await page.keyboard.press("Escape");
  await page.locator(".card").waitFor({ state: "hidden" });
  assert.deepEqual(faults, []);
  await close();
});

test("search finds, shows and flies, by keyboard alone", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  await page.keyboard.press("/");
  await page.keyboard.type("milk");
  await page.locator(".hits li").first().waitFor({ timeout: patience });
  const hits = await page.evaluate(async () => (await (await fetch("api/stores/0/search?q=milk&max=50")).json()).hits);
  assert.equal(await page.locator(".hits .name").first().textContent(), hits[0].name);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.locator(".card dd", { hasText: hits[0].sku }).waitFor({ timeout: patience });
  await settled(page);
  await take(page, "found");
  const away = await page.evaluate((row) => {
    const { table } = window.marketgen.stage.goods;
    const { eye } = window.marketgen.app.navigator.pose;
    return Math.hypot(...[0, 1, 2].map((k) => table.position[row * 3 + k] - eye[k]));
  }, hits[0].products[0]);
  assert.ok(away < 2.5, `the eye is ${away} m from the product`);
  assert.deepEqual(faults, []);
  await close();
});

test("keys alone walk, select, show the zones and measure", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  await page.locator("canvas").focus();
  await page.keyboard.press("2");
  const pose = () => page.evaluate(() => ({ eye: window.marketgen.app.navigator.pose.eye, mode: window.marketgen.app.navigator.mode }));
  const start = await pose();
  assert.equal(start.mode, "walk");
  await page.keyboard.down("w");
  await page.waitForFunction((eye) => Math.hypot(...window.marketgen.app.navigator.pose.eye.map((x, k) => x - eye[k])) > 0.2, start.eye, { timeout: patience });
  await page.keyboard.up("w");
  assert.equal((await pose()).eye[2], start.eye[2]);
  await page.keyboard.press("z");
  assert.ok((await page.locator(".marks .zone").count()) > 0);
  await page.keyboard.press("m");
  assert.equal(await page.locator("body.measuring").count(), 1);
  await page.keyboard.press("Escape");
  await page.keyboard.press("4");
  await take(page, "top");
  assert.deepEqual(faults, []);
  await close();
});

test("a door of a fixture opens by its card, within its limits", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  const door = await page.evaluate(async () => {
    const { joints, fixtures } = await (await fetch("api/stores/0")).json();
    const { moving } = window.marketgen.stage.room;
    return joints.find((joint) => /door/.test(fixtures[joint.fixture].kind) && joint.kind === "hinge" && moving.canMove(joint.row));
  });
  assert.ok(door, "the store has a door");
  await page.evaluate((fixture) => void (location.hash = `#fixture=${fixture}`), door.fixture);
  const controls = page.locator(".joint").filter({ has: page.getByRole("slider", { name: door.name.replace(/[_-]+/g, " "), exact: false }) }).first();
  await controls.waitFor({ timeout: patience });
  const leaf = () =>
    page.evaluate((row) => {
      const { position, owner } = window.marketgen.stage.room.arrays;
      let far = 0;
      for (let v = 0; v * 2 < owner.length; v++) if (owner[v * 2 + 1] === row) far += position[v * 3] + 2 * position[v * 3 + 1];
      return far;
    }, door.row);
  const closed = await leaf();
  await controls.locator("[data-state=open]").click();
  const open_ = await leaf();
  assert.ok(Math.abs(open_ - closed) > 0.1, `the leaf's corners are at ${closed} and ${open_}`);
  await take(page, "door");
  await controls.getByRole("slider").focus();
  await page.keyboard.press("Home");
  const position = await page.evaluate((row) => window.marketgen.stage.room.moving.positions[row], door.row);
  assert.equal(position, door.lower);
  assert.deepEqual(faults, []);
  await close();
});

test("a line of shelves is seen from the front, and a facing of it opens its product's card", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  const fixture = await page.evaluate(async () => {
    const { fixtures } = await (await fetch("api/stores/0")).json();
    return fixtures.find(({ kind, run }) => /^wall[-_]unit/.test(kind) && run);  // of any make
  });
  assert.ok(fixture, "the store has a wall unit");
  await page.evaluate((row) => void (location.hash = `#fixture=${row}`), fixture.row);
  await page.getByRole("button", { name: "Front view of the shelves" }).click({ timeout: patience });
  const blocks = page.locator(".wall button");
  await blocks.first().waitFor({ timeout: patience });
  assert.ok((await blocks.count()) > 5);
  const [, sku, facts] = (await blocks.first().getAttribute("title")).split("\n");
  assert.match(facts, /^\d+ × €\d+\.\d\d$/);
  await blocks.first().focus();
  await page.keyboard.press("Enter");
  await page.locator(".card dd", { hasText: sku }).waitFor({ timeout: patience });
  await take(page, "elevation");
  await page.keyboard.press("Escape");
  await page.locator(".elevation").waitFor({ state: "hidden", timeout: patience });
  assert.deepEqual(faults, []);
  await close();
});

test("products are coloured by what they cost, with a legend, and are themselves again", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  const before = await page.evaluate(() => window.marketgen.stage.goods.standIns.color.slice(0, 4000).join());
  await page.locator("canvas").focus();
  await page.keyboard.press("l");
  await page.getByLabel("Colour the products by").selectOption("price");
  assert.match(await page.locator(".legend").textContent(), /^≤ €\d+\.\d\d≥ €\d+\.\d\d$/);
  assert.equal(await page.evaluate(() => (window.marketgen.app.writeAddress(), /heat=price/.test(location.hash))), true);
  await page.waitForTimeout(1500);
  await take(page, "heat");
  assert.notEqual(await page.evaluate(() => window.marketgen.stage.goods.standIns.color.slice(0, 4000).join()), before);
  for (const [name, legend] of [["mass", /^≤ \d+\.\d\d kg≥ \d+\.\d\d kg$/], ["pickRate", /^≤ \d+ %≥ \d+ %$/]]) {
    await page.getByLabel("Colour the products by").selectOption(name);
    assert.match(await page.locator(".legend").textContent(), legend);
    await page.waitForTimeout(500);
    await take(page, `heat-${name}`);
  }
  await page.getByLabel("Colour the products by").selectOption("");
  assert.equal(await page.evaluate(() => window.marketgen.stage.goods.standIns.color.slice(0, 4000).join()), before);
  assert.equal(await page.locator(".legend").isHidden(), true);
  assert.deepEqual(faults, []);
  await close();
});

test("layers show aisles with their widths and broken rules with their words", async () => {
  const broken = { code: "test", severity: "hard", where: "x", value: 1, limit: 2, message: "<b>too narrow</b>", at_mm: [6000, 4000] };
  const { page, faults, close } = await open("", {}, (page) =>
    page.route("**/api/stores/0", async (route) => {
      const answer = await (await route.fetch()).json();
      await route.fulfill({ json: { ...answer, violations: [broken] } });
    }),
  );
  await complete(page);
  await page.locator("canvas").focus();
  await page.keyboard.press("4");
  await page.keyboard.press("l");
  await page.getByRole("checkbox", { name: /Aisles/ }).check();
  await page.getByRole("checkbox", { name: "Broken rules (1)" }).press("Space");
  const aisles = await page.evaluate(async () => (await (await fetch("api/stores/0")).json()).aisles);
  assert.ok(aisles.length > 0);
  const widths = await page.locator(".marks .aisle").allTextContents();
  assert.deepEqual(widths.sort(), aisles.map(({ width_mm }) => `${(width_mm / 1000).toFixed(2)} m`).sort());
  assert.equal(await page.locator(".marks .violation").textContent(), broken.message);
  assert.equal(await page.locator(".messages li").textContent(), broken.message);
  assert.match(await page.evaluate(() => (window.marketgen.app.writeAddress(), location.hash)), /layers=aisles,violations/);
  await take(page, "layers");
  await page.keyboard.press("Escape");
  await page.locator(".layers").waitFor({ state: "hidden", timeout: patience });
  assert.deepEqual(faults, []);
  await close();
});

const goTo = (page, hash) =>
  page.evaluate((hash) => new Promise((done) => (window.addEventListener("hashchange", done, { once: true }), (location.hash = hash))).then(() => 0), hash);

// What the page has drawn, and what a picture's file has: the mean of each channel (0..255), and the picture in grey.
const pictureOfPage = (page) =>
  page.evaluate(() => {
    const { stage } = window.marketgen;
    stage.draw(true);
    const gl = stage.renderer.getContext();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const rows = Array.from({ length: height }, (_, y) => pixels.subarray(4 * width * (height - 1 - y), 4 * width * (height - y))); // from above
    return window.toPicture(rows, width, height);
  });
async function pictureOfFile(file) {
  const { page, close } = await openPage(browser, "about:blank", {}, (page) => page.addInitScript(toPicture));
  const picture = await page.evaluate(async (address) => {
    const picture = Object.assign(new Image(), { src: address });
    await picture.decode();
    const { width, height } = picture;
    const canvas = new OffscreenCanvas(width, height).getContext("2d");
    canvas.drawImage(picture, 0, 0);
    const { data } = canvas.getImageData(0, 0, width, height);
    return window.toPicture(Array.from({ length: height }, (_, y) => data.subarray(4 * width * y, 4 * width * (y + 1))), width, height);
  }, `data:image/png;base64,${readFileSync(file, "base64")}`);
  await close();
  return picture;
}
// Runs in the browser.
function toPicture() {
  window.toPicture = (rows, width, height) => {
    const sums = [0, 0, 0];
    const grey = new Uint8Array(width * height);
    rows.forEach((row, y) => {
      for (let x = 0; x < width; x++) {
        const [r, g, b] = [row[4 * x], row[4 * x + 1], row[4 * x + 2]];
        [r, g, b].forEach((byte, c) => (sums[c] += byte));
        grey[y * width + x] = Math.round(0.2126 * r + 0.7152 * g + 0.0722 * b);
      }
    });
    let text = "";
    for (let i = 0; i < grey.length; i += 8192) text += String.fromCharCode(...grey.subarray(i, i + 8192));
    return { width, height, mean: sums.map((sum) => sum / (width * height)), grey: btoa(text) };
  };
}
const greyOf = ({ grey, width, height }) => ({ grey: Buffer.from(grey, "base64"), width, height });

test("the page has the renderer's tones, and its edges where they are", async () => {
  const { page, faults, close } = await open("", {}, (page) => page.addInitScript(toPicture));
  await complete(page);
  const cameras = await page.evaluate(async () => (await (await fetch("api/stores/0")).json()).cameras);
  for (const { name, from_m: from, at_m: at } of cameras.filter(({ name, ortho_height_m: above }) => above === 0 && !name.startsWith("zone:"))) {
    const [x, y, z] = at.map((value, k) => value - from[k]);
    await goTo(page, `#mode=fly&eye=${from.join(",")}&look=${Math.atan2(y, x)},${Math.atan2(z, Math.hypot(x, y))}`);
    await settled(page);
    await page.waitForFunction(() => window.marketgen.stage.renderer.getContext().drawingBufferHeight === 720, null, { timeout: patience }); // it stands still
    const file = join(pictures ?? folder, `renderer-${name}.png`);
    const { fov } = await page.evaluate(() => window.marketgen.stage.camera);
    execFileSync(program, ["render", store, "--from", from.join(","), "--at", at.join(","), "--fov-deg", String(fov), "--size", "1280x720", "--quiet", "-o", file]);
    await take(page, `tones-${name}`);
    const [shown, drawn] = [await pictureOfPage(page), await pictureOfFile(file)];
    for (const c of [0, 1, 2]) assert.ok(Math.abs(shown.mean[c] - drawn.mean[c]) < 0.06 * 255, `${name}: the page has ${shown.mean}, the renderer ${drawn.mean}`);
    compareEdges(name, greyOf(shown), greyOf(drawn));
  }
  assert.deepEqual(faults, []);
  await close();
});

// The renderer has edges that the page has not (shadows, mirrored lamps): those of the page are looked for.
function compareEdges(name, shown, drawn) {
  const [first, second] = [gradient(shown), gradient(drawn)];
  const [edges, others] = [strongest(first, 0.04), strongest(second, 0.12)];
  const share = shareWithin(edges, others, shown, 2);
  const astray = shareWithin(edges, others, shown, 2, 16);
  const { across, down } = shiftOf(first, second, 6);
  const tiles = shiftsOfTiles(first, second, edges, 6);
  const worst = tiles.reduce((most, tile) => Math.max(most, Math.abs(tile.across), Math.abs(tile.down)), 0);
  if (pictures) console.log(JSON.stringify({ name, size: [shown.width, shown.height], edges: edges.reduce((a, b) => a + b), share, astray, across, down, tiles: tiles.map((t) => [t.column, t.row, t.across, t.down]) }));
  assert.ok(share > 0.9, `${name}: ${share} of the page's edges are within 2 pixels of the renderer's`);
  assert.ok(share > astray + 0.05, `${name}: no more than in a picture that is 16 pixels off (${astray})`);
  assert.ok(Math.abs(across) <= 2 && Math.abs(down) <= 2, `${name}: the pictures are ${across}, ${down} pixels apart`);
  assert.ok(tiles.length > 3 && worst <= 2, `${name}: parts of them are apart: ${JSON.stringify(tiles)}`);
}

test("two clicks measure what lies between them", async () => {
  const { page, faults, close } = await open();
  await complete(page);
  await goTo(page, (await beforeAProduct(page)).hash);
  await settled(page);
  await page.locator("canvas").focus();
  await page.keyboard.press("m");
  const clicks = [
    [600, 360],
    [760, 420],
  ];
  const points = await page.evaluate((clicks) => clicks.map(([x, y]) => window.marketgen.stage.pickAt(x, y).point), clicks);
  for (const [x, y] of clicks) await page.mouse.click(x, y);
  const metres = Math.hypot(...[0, 1, 2].map((k) => points[0][k] - points[1][k]));
  assert.ok(metres > 0.02);
  await page.locator(".marks .tape").waitFor({ state: "attached", timeout: patience });
  assert.equal(await page.locator(".marks .tape").textContent(), `${metres.toFixed(3)} m`);
  assert.equal(await page.locator(".card").isHidden(), true, "a click that measures selects nothing");
  await take(page, "tape");
  assert.deepEqual(faults, []);
  await close();
});

test("fingers look around, come nearer and select", async () => {
  const { page, faults, close } = await open("", { hasTouch: true });
  await complete(page);
  const there = await beforeAProduct(page);
  await goTo(page, there.hash);
  await settled(page);
  await page.touchscreen.tap(640, 360);
  await page.locator(".card dd", { hasText: there.sku }).waitFor({ timeout: patience });
  const hand = await page.context().newCDPSession(page);
  const touch = (type, ...fingers) => hand.send("Input.dispatchTouchEvent", { type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })) });
  const pose = () => page.evaluate(() => window.marketgen.app.navigator.pose);
  const before = await pose();
  await touch("touchStart", [500, 300]);
  await touch("touchMove", [560, 300]);
  await touch("touchEnd");
  const turned = await pose();
  assert.ok(Math.abs(turned.yaw - before.yaw) > 0.1, `one finger turned by ${turned.yaw - before.yaw}`);
  assert.deepEqual(turned.eye, before.eye);
  await touch("touchStart", [500, 300], [600, 300]);
  await touch("touchMove", [450, 300], [650, 300]);
  await touch("touchEnd");
  const nearer = await pose();
  const way = [0, 1].map((k) => nearer.eye[k] - turned.eye[k]);
  assert.ok(way[0] * Math.cos(turned.yaw) + way[1] * Math.sin(turned.yaw) > 0.5, `two fingers moved by ${way}`);
  assert.deepEqual(faults, []);
  await close();
});

test("with a secret the page is shown to who has it, and to nobody else", async () => {
  const secret = "a-secret-of-the-browser-tests";
  const { server: guarded, address: said } = await serve([store, "--host", "127.0.0.2", "--token", secret]);
  try {
    const { origin } = new URL(said);
    const known = await open("", {}, () => {}, `${origin}/?token=${secret}`);
    await complete(known.page);
    await known.page.keyboard.press("/");
    await known.page.keyboard.type("milk");
    await known.page.locator(".hits li").first().waitFor({ timeout: patience });
    await known.page.keyboard.press("ArrowDown");
    await known.page.keyboard.press("Enter");
    await known.page.locator(".card .title h2").waitFor({ timeout: patience });
    await known.page.waitForFunction(() => document.querySelector(".card .label")?.naturalWidth > 0, null, { timeout: patience });
    assert.match(await known.page.evaluate(() => (window.marketgen.app.writeAddress(), location.search)), /token=/);
    assert.deepEqual(known.faults, []);
    await known.close();
    assert.equal((await fetch(`${origin}/api/stores/0`)).status, 403);
  } finally {
    guarded.kill("SIGINT");
  }
});

test("an address shows the same view again", async () => {
  const { page, close } = await open("#mode=fly&eye=3.5,2.25,1.5&look=1.25,-0.125&around=2&zones=1");
  await complete(page);
  const again = await page.evaluate(() => (window.marketgen.app.writeAddress(), location.hash));
  assert.equal(again, "#mode=fly&eye=3.5,2.25,1.5&look=1.25,-0.125&around=2&zones=1");
  await close();
});

test("a phone in the dark reads Chinese, and nothing sticks out", async () => {
  const { page, faults, close } = await open("", { viewport: { width: 390, height: 780 }, colorScheme: "dark", locale: "zh-CN", hasTouch: true });
  await complete(page);
  await take(page, "phone");
  assert.equal(await page.locator("input[type=search]").getAttribute("placeholder"), "搜索商品");
  for (const part of [".search", ".toolbar"]) {
    const box = await page.locator(part).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, `${part} is at ${JSON.stringify(box)}`);
  }
  assert.deepEqual(faults, []);
  await close();
});

// WCAG 2.2, relative luminance and contrast of sRGB colours.
function contrast(a, b) {
  const luminance = (color) => {
    const [r, g, blue] = color.map((byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * blue;
  };
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
}

for (const scheme of ["light", "dark"]) {
  test(`words stand out from what is behind them: ${scheme}`, async () => {
    const { page, close } = await open("", { colorScheme: scheme });
    await complete(page);
    const tones = await page.evaluate(() => {
      const panel = document.querySelector(".search");
      const numbers = (element, name) => getComputedStyle(element)[name].match(/[\d.]+/g).slice(0, 3).map(Number);
      return { paper: numbers(panel, "backgroundColor"), ink: numbers(panel.querySelector("h1"), "color"), muted: numbers(panel.querySelector(".muted"), "color") };
    });
    for (const name of ["ink", "muted"]) {
      const found = contrast(tones[name], tones.paper);
      assert.ok(found >= 4.5, `${name} in ${scheme}: ${found.toFixed(2)}`);
    }
    await close();
  });
}

test("markup in a store's names is text", async () => {
  const evil = "<img src=x onerror=\"document.title='broken in'\">";
  const { page, faults, close } = await open("#zones=1", {}, (page) =>
    page.route("**/api/stores/0", async (route) => {
      const answer = await (await route.fetch()).json();
      for (const zone of answer.zones) zone.label = evil;
      await route.fulfill({ json: { ...answer, name: evil } });
    }),
  );
  await complete(page);
  assert.equal(await page.locator("h1").textContent(), evil);
  assert.equal(await page.locator("h1 img, .marks img").count(), 0);
  assert.notEqual(await page.title(), "broken in");
  assert.deepEqual(faults, []);
  await close();
});

test("what the server says of an error is read, and a store that does not come is told", async () => {
  const refuse = (path, status, message) => (page) =>
    page.route(path, (route) => route.fulfill({ status, json: { error: { code: "server.test", where: "/", message } } }));
  const first = await open("", {}, refuse("**/goods.bin", 500, "the disk is full; free some"));
  await first.page.locator(".fault", { hasText: "the disk is full; free some" }).waitFor({ timeout: patience });
  assert.equal(await first.page.locator(".fault button").evaluate((button) => button === document.activeElement), true);
  await take(first.page, "fault");
  await first.close();

  const second = await open("", {}, refuse("**/search?**", 429, "too many; wait a second"));
  await complete(second.page);
  await second.page.keyboard.press("/");
  await second.page.keyboard.type("milk");
  await second.page.locator(".toast", { hasText: "too many; wait a second" }).waitFor({ timeout: patience });
  await second.close();

  const third = await open("", {}, (page) => page.route("**/room.bin", (route) => route.fulfill({ body: "MGV2" })));
  await third.page.locator(".fault", { hasText: "does not understand" }).waitFor({ timeout: patience });
  await third.close();
});

// As Jupyter shows it: a page of another port of this machine has it in a frame.
async function framed(flags) {
  const { server: shown, address: at } = await serve([store, ...flags]);
  const notebook = createServer((_, answer) => {
    answer.setHeader("Content-Type", "text/html");
    answer.end(`<!doctype html><title>notebook</title><link rel="icon" href="data:,"><iframe src="${at}" style="width:900px;height:480px"></iframe>`);
  });
  await new Promise((ready) => notebook.listen(0, "127.0.0.1", ready));
  const { page, faults, close } = await open("", {}, undefined, `http://127.0.0.1:${notebook.address().port}/`);
  const end = async () => {
    await close();
    notebook.close();
    shown.kill("SIGINT");
  };
  return { page, faults, at, end };
}

test("a notebook's frame has the page, where that was said", async () => {
  const { page, faults, at, end } = await framed(["--embed"]);
  await page.waitForFunction(() => frames.length === 1);
  const frame = page.frames().find((one) => one.url().startsWith(at));
  await frame.waitForFunction(() => window.marketgen?.times.complete !== undefined, null, { timeout: patience });
  await take(page, "notebook");
  assert.equal(await frame.locator("h1").textContent(), await frame.evaluate(async () => (await (await fetch("api/stores/0")).json()).name));
  assert.deepEqual(faults, []);
  await end();
});

test("otherwise no other page has it in a frame", async () => {
  const { page, faults, end } = await framed([]);
  await page.waitForFunction(() => frames.length === 1);
  await page.waitForTimeout(500);
  assert.ok(faults.some((fault) => fault.includes("frame-ancestors")), faults.join("; "));
  await end();
});
