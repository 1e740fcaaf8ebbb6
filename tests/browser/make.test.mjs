// Making stores in the page of `marketgen view`: Debian's Chromium describes one, compares two seeds, drops a floor plan, keeps a store and opens it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, openPage, program, serve, take } from "./served.mjs";

const patience = 120_000; // milliseconds for stores to be made and shown, on a busy machine
const words = "a 9 x 7 m corner shop with drinks and snacks, one checkout";

let folder, server, address, browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "marketgen-make-"));
  ({ server, address } = await serve(["--make-in", folder]));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  if (folder) rmSync(folder, { recursive: true, force: true });
});

const ready = (page, count) => page.waitForFunction((n) => document.querySelectorAll(".try[data-state=ready]").length === n, count, { timeout: patience });
const describe = (page) => page.getByLabel("What should the store be?");

test("a server without stores opens the page in which they are made; words and seeds make some, and the one that is kept opens", { timeout: 4 * patience }, async () => {
  const { page, faults, close } = await openPage(browser, address, { viewport: { width: 1280, height: 900 } });
  await describe(page).waitFor({ timeout: patience });
  assert.match(page.url(), /\?make=/);
  assert.equal(await page.title(), "A new store · MarketGen");
  await take(page, "make-empty");

  await page.getByRole("button", { name: "Make stores" }).click();
  assert.equal(await page.getByRole("alert").first().textContent(), "Say what the store should be, or drop a drawing or a photo.");

  await describe(page).fill(`${words}, a helicopter pad`);
  await page.getByLabel("Stores to compare").fill("2");
  await page.getByLabel("First seed").fill("5");
  await page.getByRole("button", { name: "Make stores" }).click();
  await ready(page, 2);
  const cards = page.locator(".try");
  assert.deepEqual(await cards.locator("h2").allTextContents(), ["Seed 5", "Seed 6"]);
  assert.ok((await cards.first().locator(".wishes .mark.solved").count()) >= 3, "wishes are ticked off");
  assert.match(await cards.first().textContent(), /not understood:.*helicopter/);
  assert.ok((await cards.first().locator("svg .fixture").count()) > 5);
  await page.waitForFunction(() => [...document.querySelectorAll(".try img")].every((img) => img.complete && img.naturalWidth === 480), null, { timeout: patience });
  await take(page, "make-two-seeds");

  await page.reload();
  await ready(page, 2); // what was made is still there
  const second = page.locator(".try").nth(1);
  await second.getByLabel("Folder").fill("a/b");
  await second.getByRole("button", { name: "Keep and open" }).click();
  await second.getByRole("alert").filter({ hasText: "name of a new folder" }).waitFor({ timeout: patience });
  faults.splice(0); // the browser complains of an answer 400
  await second.getByLabel("Folder").fill("my-shop");
  await second.getByRole("button", { name: "Keep and open" }).click();
  await page.waitForFunction(() => window.marketgen?.times.goods !== undefined, null, { timeout: patience });
  assert.match(page.url(), /\?store=0/);

  const kept = join(folder, "my-shop");
  execFileSync(program, ["generate", `${words}, a helicopter pad`, "--seed", "6", "--no-previews", "--quiet", "-o", join(folder, "again")]);
  const hash = (at) => JSON.parse(readFileSync(join(at, "store.json"), "utf8")).scene_hash;
  assert.equal(hash(kept), hash(join(folder, "again")));
  assert.deepEqual(faults, []);

  await page.getByRole("button", { name: "More" }).click();
  await page.getByRole("menuitem", { name: "New store…" }).click();
  await page.getByRole("link", { name: "Start from its words" }).click();
  await page.waitForFunction((said) => document.querySelector("textarea")?.value === said, `${words}, a helicopter pad`, { timeout: patience });
  assert.equal(await page.getByLabel("First seed").inputValue(), "6");
  await close();
});

test("time, single axes, skin and products of one's own are as generate has them; what is none is said in the core's words", { timeout: 4 * patience }, async () => {
  const { page, faults, close } = await openPage(browser, `${address}?make`);
  const own = "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg\nown-cola,2999999999991,Lemonade,beverages,soft drinks,can,66x66x115,0.35\n";
  await describe(page).fill("a kiosk with cold drinks", { timeout: patience });
  await page.locator(".ask summary").click();
  assert.equal(await page.getByLabel("Who plans").count(), 0, "the server was started without a model");
  await page.getByLabel("Size of the room").fill("8x7m");
  await page.getByLabel("Time that the shelves show").fill("Blursday 9:00");
  await page.getByLabel("What was taken").fill("9");
  await page.getByLabel("Look over the whole store").selectOption("industrial");
  await page.locator('input[type="file"]').setInputFiles({ name: "mine.csv", mimeType: "text/csv", buffer: Buffer.from(own) });
  await page.getByLabel("Stores to compare").fill("1");
  await page.getByLabel("First seed").fill("3");
  await page.getByRole("button", { name: "Make stores" }).click();
  const refused = page.locator(".news [role=alert]");
  await refused.waitFor({ timeout: patience });
  assert.match(await refused.textContent(), /Mon, Tue, Wed/);
  await take(page, "make-refused-time");
  await page.getByLabel("Time that the shelves show").fill("Sat 17:30");
  await page.getByRole("button", { name: "Make stores" }).click();
  await ready(page, 1);
  await take(page, "make-all-fields");
  await page.locator(".try").getByLabel("Folder").fill("kiosk");
  await page.locator(".try").getByRole("button", { name: "Keep and open" }).click();
  await page.waitForFunction(() => window.marketgen?.times.goods !== undefined, null, { timeout: patience });
  const table = join(folder, "mine.csv");
  writeFileSync(table, own);
  execFileSync(program, ["generate", "a kiosk with cold drinks", "--size", "8x7m", "--time", "Sat 17:30", "--vary", "fill=9", "--skin", "industrial", "--catalog", table, "--seed", "3", "--no-previews", "--quiet", "-o", join(folder, "kiosk-again")]);
  const manifest = (name) => JSON.parse(readFileSync(join(folder, name, "store.json"), "utf8"));
  assert.equal(manifest("kiosk").scene_hash, manifest("kiosk-again").scene_hash);
  assert.equal(manifest("kiosk").look_hash, manifest("kiosk-again").look_hash);
  assert.equal(manifest("kiosk").own[0].sku, "own-cola");
  assert.deepEqual(faults, []);
  await close();
});

test("a dropped floor plan is the room; what cannot be read is said; a phone and the keyboard will do", { timeout: 3 * patience }, async () => {
  const { page, faults, close } = await openPage(browser, `${address}?make`, { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await describe(page).waitFor({ timeout: patience });
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="160mm" height="100mm" viewBox="0 0 160 100"><rect x="0" y="0" width="160" height="100" fill="none" stroke="black"/></svg>`;
  const files = page.locator('input[type="file"]');
  await files.setInputFiles({ name: "notes.txt", mimeType: "text/plain", buffer: Buffer.from("x") });
  assert.match(await page.locator(".ask > .failed").textContent(), /notes\.txt is no SVG/);
  await files.setInputFiles({ name: "room.svg", mimeType: "image/svg+xml", buffer: Buffer.from(svg) });
  await page.getByLabel("Scale of room.svg").fill("1:100");
  await describe(page).fill("a shop with drinks and snacks, one checkout");
  await page.getByLabel("Stores to compare").fill("1");
  await page.getByRole("button", { name: "Make stores" }).focus();
  await page.keyboard.press("Enter");
  // Inside of the wall that the line is drawn as. What the test before has made is shown until then.
  await page.locator('.made-plan .outline[points*="15900,0"]').waitFor({ timeout: patience });
  await ready(page, 1);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `nothing hangs over the edge of a phone: ${wide}`);
  await take(page, "make-phone-dark");

  await page.getByRole("button", { name: "Remove room.svg" }).click();
  await files.setInputFiles({ name: "broken.svg", mimeType: "image/svg+xml", buffer: Buffer.from("no drawing") });
  await page.getByRole("button", { name: "Make stores" }).click();
  await page.locator(".news [role=alert]").waitFor({ timeout: patience });
  assert.doesNotMatch(await page.locator(".news").textContent(), /tmp/);
  await page.getByRole("button", { name: "中文" }).click();
  assert.equal(await page.locator("h1").textContent(), "新店铺");
  assert.deepEqual(faults, []);
  await close();
});

test("a server that only shows makes nothing", { timeout: patience }, async () => {
  const store = join(folder, "again");
  assert.ok(existsSync(store));
  const reading = await serve([store, "--read-only"]);
  try {
    const answer = await fetch(new URL("api/make", reading.address));
    assert.equal(answer.status, 400);
    assert.equal((await answer.json()).error.code, "server.refused");
    const posted = await fetch(new URL("api/make/try", reading.address), { method: "POST", headers: { "Content-Type": "application/json" }, body: "{}" });
    assert.equal(posted.status, 405);
  } finally {
    reading.server.kill("SIGINT");
  }
});
