// Editing a store in the page of `marketgen view`: Debian's Chromium drags a border, takes it back, saves the store and makes it again.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, openPage, program, serve, take } from "./served.mjs";

const patience = 120_000; // milliseconds for the store to be built and shown, on a busy machine

const plan = {
  schema: "market-plan/1",
  name: "Edited",
  shell: {
    width_mm: 14000,
    depth_mm: 11000,
    openings: [
      { id: "door", kind: "entrance", wall: "south", center: 0.75, width_mm: 2000 },
      { id: "way_out", kind: "exit", wall: "south", center: 0.3, width_mm: 2000 },
    ],
  },
  nodes: [
    { id: "root", split: "y", ratio: 0.4, gap_mm: 2000, children: ["front", "back"] },
    { id: "front", zone: "tills" },
    { id: "back", split: "x", ratio: 0.5, gap_mm: 2000, children: ["west", "east"] },
    { id: "west", zone: "snacks" },
    { id: "east", zone: "drinks" },
  ],
  zones: [
    { id: "tills", type: "checkout", label: "Tills", fixture: { kind: "checkout_lane", count: 2 } },
    { id: "snacks", type: "snacks", label: "Snacks", fixture: { kind: "gondola", levels: 5 } },
    { id: "drinks", type: "beverages", label: "Drinks", fixture: { kind: "gondola", levels: 5 } },
  ],
};

let folder, store, server, address, browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "marketgen-edit-"));
  store = join(folder, "shop");
  writeFileSync(join(folder, "plan.json"), JSON.stringify(plan));
  execFileSync(program, ["generate", "--plan", join(folder, "plan.json"), "--seed", "3", "--no-previews", "--quiet", "-o", store]);
  ({ server, address } = await serve([store]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

async function open(options = {}, at = address) {
  const opened = await openPage(browser, at, { viewport: { width: 1280, height: 800 }, ...options });
  await opened.page.waitForFunction(() => window.marketgen?.times.complete !== undefined, null, { timeout: patience });
  return opened;
}

async function openEditor(page) {
  await page.locator("canvas").focus();
  await page.keyboard.press("r");
  await page.locator(".edit .plan .border").first().waitFor({ state: "attached", timeout: patience });
}

const steps = (page) => page.locator(".edit .lines li:not(.none)").count();
const undone = (page) => page.locator(".edit .lines .undone").count();
const products = (page) => page.evaluate(() => window.marketgen.stage.goods.table.count);
const idle = (page) => page.waitForFunction(() => document.querySelector(".edit").getAttribute("aria-busy") === "false", null, { timeout: patience });

// Drags the border of a cut by so many pixels.
async function drag(page, node, dx, dy, letGo = true) {
  const box = await page.locator(`.plan .border[data-key="cut ${node}"] .line`).evaluate((line) => line.getBoundingClientRect().toJSON());
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(x + (dx * i) / 5, y + (dy * i) / 5);
  if (letGo) await page.mouse.up();
}

test("a border is dragged, taken back, done again, saved, and the saved plan makes the same store", async () => {
  const { page, faults, close } = await open();
  const opened = await products(page);
  await openEditor(page);
  await idle(page);
  await take(page, "edit-open");
  assert.equal(await steps(page), 0);

  await drag(page, "back", 20, 0);
  await page.waitForFunction(() => document.querySelectorAll(".edit .lines li:not(.none)").length === 1, null, { timeout: patience });
  await idle(page);
  const dragged = await products(page);
  assert.notEqual(dragged, opened, "another floor, other shelves");
  assert.equal(await page.evaluate(() => window.marketgen.stage.goods.skus.length > 0 && window.marketgen.stage.annexe !== undefined), true);
  await take(page, "edit-dragged");

  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => document.querySelector(".edit .lines .undone"), null, { timeout: patience });
  await idle(page);
  assert.equal(await products(page), opened);
  assert.equal(await page.evaluate(() => window.marketgen.stage.annexe), undefined, "nothing is new");
  await page.keyboard.press("Control+Shift+z");
  await page.waitForFunction(() => !document.querySelector(".edit .lines .undone"), null, { timeout: patience });
  await idle(page);
  assert.equal(await products(page), dragged);
  assert.equal(await undone(page), 0);

  await page.getByRole("textbox", { name: "Save as" }).fill("dragged");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText("Saved as dragged.").waitFor({ timeout: patience });
  const manifest = JSON.parse(readFileSync(join(folder, "dragged", "store.json"), "utf8"));
  assert.equal(manifest.counts.products, dragged);
  assert.equal(manifest.edits.length, 1);
  const again = join(folder, "again");
  execFileSync(program, ["generate", "--plan", join(folder, "dragged", "plan.json"), "--seed", "3", "--no-previews", "--quiet", "-o", again]);
  assert.equal(JSON.parse(readFileSync(join(again, "store.json"), "utf8")).scene_hash, manifest.scene_hash);

  await page.getByRole("link", { name: "Open it" }).click();
  await page.waitForFunction(() => window.marketgen?.times.complete !== undefined, null, { timeout: patience });
  assert.equal(await products(page), dragged);
  assert.deepEqual(faults, []);
  await close();
});

const done = async (page, count) => {
  await page.waitForFunction((n) => document.querySelectorAll(".edit .lines li:not(.none):not(.undone)").length === n, count, { timeout: patience });
  await idle(page);
};
const choose = async (page, zone) => {
  await page.locator(`.plan .zone[data-zone="${zone}"]`).focus();
  await page.keyboard.press("Enter");
};
// Where a run's fixtures are, west to east, in millimetres.
const placesOf = (page, run) => page.evaluate((id) => window.marketgen.app.summary.fixtures.filter((fixture) => fixture.run === id).map(({ position_m: [x, y] }) => [Math.round(x * 1000), Math.round(y * 1000)]), run);

test("a run of shelves is dragged: rules are seen as it moves, it is taken back, saved, and the plan alone makes it again", async () => {
  const { page, faults, close } = await open();
  await openEditor(page);
  await idle(page);
  const before = (await steps(page)) - (await undone(page));
  assert.equal(await page.locator(".plan .run").count(), 0, "of the chosen zone alone");
  await choose(page, "drinks");
  const run = await page.evaluate(() => {
    const gondolas = window.marketgen.app.summary.fixtures.filter(({ zone, kind }) => zone === "drinks" && kind === "gondola");
    return gondolas[0].run;
  });
  const handle = page.locator(`.plan .run[data-run="${run}"]`);
  const places = await placesOf(page, run);
  const middle = async () => {
    const box = await handle.boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  let [x, y] = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const far of [10, 30, 50]) await page.mouse.move(x + far, y);
  await page.locator(".edit .fault-text").filter({ hasText: /\S/ }).waitFor({ timeout: patience });
  assert.ok((await page.locator(".plan .fixture").count()) > 0, "where all would stand");
  await take(page, "edit-run-held");
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await idle(page);
  assert.equal((await steps(page)) - (await undone(page)), before, "given up");
  assert.deepEqual(await placesOf(page, run), places);

  [x, y] = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const far of [1, 2, 3]) await page.mouse.move(x - far, y);
  await page.mouse.up();
  await done(page, before + 1);
  const moved = await placesOf(page, run);
  const by = moved[0][0] - places[0][0];
  assert.ok(by < -20 && by > -300, `${by} mm`);
  assert.deepEqual(moved, places.map(([a, b]) => [a + by, b]));
  assert.match(await page.locator(".edit .lines li").last().textContent(), /X mm \d+/);
  await take(page, "edit-run-moved");

  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.deepEqual(await placesOf(page, run), places);
  await page.keyboard.press("Control+Shift+z");
  await done(page, before + 1);

  await page.getByRole("textbox", { name: "Save as" }).fill("run-moved");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText("Saved as run-moved.").waitFor({ timeout: patience });
  const read = (name) => JSON.parse(readFileSync(join(folder, name, "store.json"), "utf8"));
  execFileSync(program, ["generate", "--plan", join(folder, "run-moved", "plan.json"), "--seed", "3", "--no-previews", "--quiet", "-o", join(folder, "run-again")]);
  assert.equal(read("run-again").scene_hash, read("run-moved").scene_hash);

  await page.locator('[data-field="free"]').focus();
  await page.keyboard.press("Enter");
  await done(page, before + 2);
  assert.deepEqual(await placesOf(page, run), places, "it stands as usual");
  await handle.focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  await done(page, before + 3);
  assert.deepEqual(await placesOf(page, run), places.map(([a, b]) => [a - 50, b]));
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.deepEqual(faults, []);
  await close();
});

// What stands on a line of shelves, as the server says it of the edit.
const blocksOf = (page, run) => page.evaluate(async (id) => (await (await fetch(`api/stores/0/edit/blocks?run=${encodeURIComponent(id)}`)).json()).blocks, run);
const stands = (blocks) => blocks.map(({ fixture, side, shelf, position, sku, facings }) => [fixture, side, shelf, position, sku, facings].join(" "));

async function openFrontView(page) {
  const run = await page.evaluate(() => window.marketgen.app.summary.fixtures.find(({ zone, kind }) => zone === "snacks" && kind === "gondola").run);
  if ((await page.locator('[data-field="front"]').count()) === 0) await choose(page, "snacks");
  await page.locator('[data-field="front"]').selectOption(run);
  await page.locator(".elevation .wall button").first().waitFor({ timeout: patience });
  await page.waitForFunction(() => window.marketgen.app.elevation.blocks.length > 0, null, { timeout: patience });
  return run;
}
const centre = async (locator) => {
  await locator.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 2, y + height / 2];
};

test("two blocks of products are swapped by dragging one onto the other: seen as it moves, taken back, saved, and the plan makes it again", async () => {
  const { page, faults, close } = await open();
  await openEditor(page);
  await idle(page);
  const before = (await steps(page)) - (await undone(page));
  const run = await openFrontView(page);
  const blocks = await blocksOf(page, run);
  const shelf = blocks.filter((block) => block.side === "front" && block.fixture === blocks[0].fixture && block.shelf === blocks[0].shelf);
  assert.ok(shelf.length >= 2, "a shelf of two blocks");
  const [a, b] = shelf;
  const block = ({ facing }) => page.locator(`.elevation [data-facing="${facing}"]`);
  const [x, y] = await centre(block(a));
  const [toX, toY] = await centre(block(b));
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) await page.mouse.move(x + ((toX - x) * i) / 4, y + ((toY - y) * i) / 4);
  await page.locator(".swap-bar").getByText("Keeps every hard rule.").waitFor({ timeout: patience });
  assert.match(await block(b).getAttribute("class"), /target/);
  await take(page, "edit-swap-held");
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await idle(page);
  assert.equal((await steps(page)) - (await undone(page)), before, "given up");
  assert.deepEqual(stands(await blocksOf(page, run)), stands(blocks));

  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) await page.mouse.move(x + ((toX - x) * i) / 4, y + ((toY - y) * i) / 4);
  await page.mouse.up();
  await done(page, before + 1);
  const swapped = blocks.map((block) => {
    const other = block.facing === a.facing ? b : block.facing === b.facing ? a : block;
    return { ...block, sku: other.sku, facings: other.facings };
  });
  assert.deepEqual(stands(await blocksOf(page, run)), stands(swapped));
  const shown = await page.evaluate(([first, second]) => [first, second].map((facing) => document.querySelector(`.elevation [data-facing="${facing}"]`).title.split("\n")[1]), [a.facing, b.facing]);
  assert.deepEqual(shown, [b.sku, a.sku], "the front view shows it");
  await take(page, "edit-swapped");

  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.deepEqual(stands(await blocksOf(page, run)), stands(blocks));
  await page.keyboard.press("Control+Shift+z");
  await done(page, before + 1);
  await page.getByRole("textbox", { name: "Save as" }).fill("swapped");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText("Saved as swapped.").waitFor({ timeout: patience });
  const read = (name) => JSON.parse(readFileSync(join(folder, name, "store.json"), "utf8"));
  execFileSync(program, ["generate", "--plan", join(folder, "swapped", "plan.json"), "--seed", "3", "--no-previews", "--quiet", "-o", join(folder, "swapped-again")]);
  assert.equal(read("swapped-again").scene_hash, read("swapped").scene_hash);
  assert.ok(read("swapped").edits.at(-1).patches[0].swap_blocks);
  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.deepEqual(faults, []);
  await close();
});

test("keys alone swap two blocks; what does not fit is said with what helps, in the reader's language", async () => {
  const { page, faults, close } = await open({ locale: "zh-CN", colorScheme: "dark" });
  await openEditor(page);
  await idle(page);
  const before = (await steps(page)) - (await undone(page));
  const run = await openFrontView(page);
  const blocks = (await blocksOf(page, run)).filter(({ side }) => side === "front");
  const a = blocks[0];
  const b = blocks.find((other) => other.fixture === a.fixture && other.shelf === a.shelf && other.sku !== a.sku);
  await page.getByText("将一块商品拖到另一块上即可互换").waitFor({ timeout: patience });
  await page.locator(`.elevation [data-facing="${a.facing}"]`).focus();
  await page.keyboard.press("Enter");
  const facings = page.locator('[data-field="swap-facings"]');
  await facings.fill("90");
  await page.locator('[data-field="swap-with"]').selectOption(String(b.facing));
  await page.locator(".swap-bar .fault-text").filter({ hasText: /take away facings/ }).waitFor({ timeout: patience });
  assert.equal((await steps(page)) - (await undone(page)), before);
  await take(page, "edit-swap-does-not-fit");
  await facings.fill("1");
  await page.keyboard.press("Tab");
  await page.locator(".swap-bar p:not(.fault-text)").filter({ hasText: /\S/ }).waitFor({ timeout: patience });
  await page.locator('[data-field="swap-do"]').focus();
  await page.keyboard.press("Enter");
  await done(page, before + 1);
  const now = (await blocksOf(page, run)).filter(({ side }) => side === "front");
  assert.equal(now.find(({ facing }) => facing === b.facing).sku, a.sku);
  assert.equal(now.find(({ facing }) => facing === b.facing).facings, 1);
  assert.equal(now.find(({ facing }) => facing === a.facing).sku, b.sku);
  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.deepEqual(faults, []);
  await close();
});

test("what would be broken stands in sight of the plan, in a low window, too", async () => {
  const { page, faults, close } = await open({ viewport: { width: 900, height: 420 } });
  await openEditor(page);
  await idle(page);
  const before = (await steps(page)) - (await undone(page));
  await drag(page, "back", -400, 0, false);
  const text = page.locator(".edit .fault-text").filter({ hasText: /\S/ });
  await text.waitFor({ timeout: patience });
  const [seen, plan] = [await text.boundingBox(), await page.locator(".edit .plan").boundingBox()];
  assert.ok(seen.y >= 0 && seen.y + seen.height <= 420, `at ${seen.y} to ${seen.y + seen.height} pixels`);
  assert.ok(seen.y >= plan.y && seen.y - (plan.y + plan.height) < 30, "beside the plan");
  await take(page, "edit-low-window");
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await idle(page);
  assert.equal((await steps(page)) - (await undone(page)), before);
  assert.deepEqual(faults, []);
  await close();
});

test("facings and aisles of a zone are set by its fields, and taken back", async () => {
  const { page, faults, close } = await open({ colorScheme: "dark" });
  await openEditor(page);
  await idle(page);
  const before = (await steps(page)) - (await undone(page));
  const opened = await products(page);
  await choose(page, "snacks");
  const fewest = page.getByRole("spinbutton", { name: "Fewest facings of a product" });
  const most = page.getByRole("spinbutton", { name: "Most facings of a product" });
  assert.equal(await fewest.inputValue(), "2");
  await fewest.fill("6");
  await page.keyboard.press("Enter");
  await done(page, before + 1);
  assert.equal(await most.inputValue(), "6", "no fewer than the fewest");
  assert.notEqual(await products(page), opened);
  await take(page, "edit-facings-dark");
  await page.keyboard.press("Control+z");
  await done(page, before);
  assert.equal(await products(page), opened);
  assert.equal(await fewest.inputValue(), "2");

  const aisle = page.getByRole("spinbutton", { name: "Aisles, mm" });
  assert.equal(await aisle.inputValue(), "");
  await aisle.fill("1300");
  await page.keyboard.press("Enter");
  await done(page, before + 1);
  assert.equal(await aisle.inputValue(), "1300");
  await aisle.fill("");
  await page.keyboard.press("Enter");
  await done(page, before + 2);
  assert.equal(await products(page), opened, "as usual");
  assert.deepEqual(faults, []);
  await close();
});

test("a second visitor is told, sees the store as it was opened, and may edit when the first has gone", async () => {
  const first = await open();
  await openEditor(first.page);
  await idle(first.page);
  const second = await open();
  await second.page.locator("canvas").focus();
  await second.page.keyboard.press("r");
  await second.page.getByText("Somebody else is changing this store").waitFor({ timeout: patience });
  assert.equal(await second.page.locator(".edit .plan").isVisible(), false);
  await take(second.page, "edit-second");
  await first.close();
  await second.page.getByRole("button", { name: "Try again" }).click();
  await second.page.locator(".edit .plan .border").first().waitFor({ state: "attached", timeout: patience });
  assert.deepEqual([...first.faults, ...second.faults], []);
  await second.close();
});

test("keys alone: a border by arrows, levels by a field, words, and what cannot be is said", async () => {
  const { page, faults, close } = await open({ colorScheme: "dark" });
  await openEditor(page);
  await idle(page);
  const before = await steps(page);
  await page.locator('.plan .border[data-key="cut back"]').focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.match(await page.locator('.plan .border[data-key="cut back"]').getAttribute("class"), /held/);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await steps(page), before, "given up");

  await page.locator('.plan .zone[data-zone="drinks"]').focus();
  await page.keyboard.press("Enter");
  await page.getByLabel("Levels").selectOption("6");
  await page.waitForFunction((n) => document.querySelectorAll(".edit .lines li:not(.none)").length === n + 1, before, { timeout: patience });
  await idle(page);
  assert.equal(await page.evaluate(() => window.marketgen.app.summary.fixtures.find(({ zone }) => zone === "drinks").levels), 6);
  await take(page, "edit-dark");

  await page.getByRole("textbox", { name: "Say what shall change" }).fill("swap snacks and drinks");
  await page.keyboard.press("Enter");
  await page.waitForFunction((n) => document.querySelectorAll(".edit .lines li:not(.none)").length === n + 2, before, { timeout: patience });
  await idle(page);

  await page.getByRole("textbox", { name: "Say what shall change" }).fill("quizzical zeppelins yodel");
  await page.keyboard.press("Enter");
  await page.getByText("not one word of it asks for a change").waitFor({ timeout: patience });
  await page.keyboard.press("Escape");
  assert.deepEqual(faults, []);
  await close();
});

test("a phone and Chinese", async () => {
  const { page, faults, close } = await open({ viewport: { width: 390, height: 780 }, locale: "zh-CN" });
  await openEditor(page);
  await idle(page);
  assert.equal(await page.locator(".edit h2").textContent(), "修改此店铺");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} pixels wide`);
  await take(page, "edit-phone");
  assert.deepEqual(faults, []);
  await close();
});
