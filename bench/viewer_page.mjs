// What a person waits for in the viewer: Debian's Chromium, drawing without a GPU, opens a store at 1280 x 720 and walks an aisle.
// One JSON line a figure, as `marketgen bench` has them.
//
//     node bench/viewer_page.mjs STORE [--rounds 3] [--first] [--pictures FOLDER]
//
// Opens with the light and labels that are kept under $MARKETGEN_CACHE (a first opening that is not measured makes them). With --first
// the first opening is measured as well, in an empty cache of its own.
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { launch, openPage, serve } from "../tests/browser/served.mjs";

const patience = 180_000;
const walkSeconds = 3.5;
const walks = 3; // a round, back and forth

const { values: given, positionals } = parseArgs({
  allowPositionals: true,
  options: { rounds: { type: "string", default: "3" }, first: { type: "boolean" }, pictures: { type: "string" } },
});
const store = positionals[0];
if (!store) throw new Error("name a store folder: node bench/viewer_page.mjs STORE");

const say = (benchmark, value, unit, more = {}) =>
  console.log(JSON.stringify({ benchmark, value: Math.round(value * 100) / 100, unit, load: Math.round(loadavg()[0] * 10) / 10, ...more }));
const peakMegabytes = ({ pid }) => Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1000;
const nowMegabytes = ({ pid }) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1000;
const processorSeconds = ({ pid }) => {
  const words = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ")[1].split(" ");
  return (Number(words[11]) + Number(words[12])) / 100;
};

// Processor seconds of the browser: all, its pages, and what draws.
function browserSeconds() {
  const [parents, parts] = [new Map(), { all: 0, page: 0, drawing: 0 }];
  for (const name of readdirSync("/proc")) {
    if (!/^\d+$/.test(name)) continue;
    try {
      parents.set(Number(name), Number(readFileSync(`/proc/${name}/stat`, "utf8").split(") ")[1].split(" ")[1]));
    } catch {
      continue; // it has ended
    }
  }
  const isOurs = (pid) => pid !== undefined && (pid === process.pid || isOurs(parents.get(pid)));
  for (const pid of parents.keys()) {
    if (pid === process.pid || pid === server.pid || !isOurs(pid)) continue;
    try {
      const words = readFileSync(`/proc/${pid}/cmdline`, "utf8");
      const spent = processorSeconds({ pid });
      parts.all += spent;
      if (words.includes("--type=renderer")) parts.page += spent;
      if (words.includes("--type=gpu-process")) parts.drawing += spent;
    } catch {
      continue; // it has ended
    }
  }
  return parts;
}
// Since `from`, of each of so many.
const spentSince = (from, count = 1, unit = 1) =>
  Object.fromEntries(Object.entries(browserSeconds()).map(([part, seconds]) => [part, Math.round(((seconds - from[part]) * unit * 100) / count) / 100]));

async function built(address) {
  for (;;) {
    const { state } = await (await fetch(`${address}api/stores/0/state`)).json();
    if (state !== "building") return state;
    await new Promise((done) => setTimeout(done, 200));
  }
}

async function end(server) {
  const ended = new Promise((done) => server.once("exit", done));
  server.kill("SIGINT");
  await ended;
}

async function firstOpening() {
  const cache = mkdtempSync(join(tmpdir(), "marketgen-cache-"));
  const kept = process.env.MARKETGEN_CACHE;
  process.env.MARKETGEN_CACHE = cache;
  const began = performance.now();
  const { server, address } = await serve([store]);
  say("viewer_first_opening_address", (performance.now() - began) / 1000, "s");
  await built(address);
  say("viewer_first_opening_built", (performance.now() - began) / 1000, "s", { processor_s: processorSeconds(server) });
  say("viewer_first_opening_memory_peak", peakMegabytes(server), "MB", { afterwards_mb: Math.round(nowMegabytes(server)) });
  await end(server);
  if (kept === undefined) delete process.env.MARKETGEN_CACHE;
  else process.env.MARKETGEN_CACHE = kept;
  rmSync(cache, { recursive: true });
}

// The longest aisle, from one end: where one stands and looks.
const aisleOf = (page) =>
  page.evaluate(async () => {
    const { aisles } = await (await fetch("api/stores/0")).json();
    const spans = aisles.map(({ polygon_mm: corners }) => {
      const [xs, ys] = [0, 1].map((k) => corners.map((corner) => corner[k] / 1000));
      const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
      return x1 - x0 > y1 - y0
        ? { long: x1 - x0, eye: [x0 + 0.3, (y0 + y1) / 2], yaw: 0 }
        : { long: y1 - y0, eye: [(x0 + x1) / 2, y0 + 0.3], yaw: Math.PI / 2 };
    });
    return spans.sort((a, b) => b.long - a.long)[0];
  });

async function walk(page, round) {
  const { eye, yaw } = await aisleOf(page);
  await page.evaluate((hash) => void (location.hash = hash), `#mode=walk&eye=${eye[0]},${eye[1]},1.62&look=${yaw},0`);
  await page.waitForTimeout(1500);
  await page.locator("canvas").focus();
  const rates = [];
  let [seen, pictures, spent] = [undefined, 0, browserSeconds()];
  for (let i = 0; i < walks; i++) {
    const key = i % 2 === 0 ? "w" : "s";
    const from = await page.evaluate(() => ({ frames: window.marketgen.stage.figures.frames, at: performance.now() }));
    await page.keyboard.down(key);
    await page.waitForTimeout(walkSeconds * 1000);
    seen = await page.evaluate(() => {
      const { figures, pace, renderer, goods } = window.marketgen.stage;
      const { drawingBufferWidth, drawingBufferHeight } = renderer.getContext();
      return { ...figures, at: performance.now(), size: [drawingBufferWidth, drawingBufferHeight], pace: Math.round(pace.milliseconds), stand_ins: goods.standIns.triangles };
    });
    pictures += seen.frames - from.frames;
    rates.push(((seen.frames - from.frames) * 1000) / (seen.at - from.at));
    if (given.pictures && round === 0 && i < 2) await picture(page, `walking-${i}`);
    await page.keyboard.up(key);
  }
  const each = spentSince(spent, pictures, 1000);
  if (given.pictures && round === 0) {
    await page.waitForTimeout(3000);
    await picture(page, "standing");
  }
  say("viewer_walking", rates.reduce((a, b) => a + b) / rates.length, "pictures/s", {
    processor_ms: each, least: Math.round(Math.min(...rates) * 10) / 10, triangles: seen.triangles, stand_ins: seen.stand_ins, calls: seen.calls, pixels: seen.size.join(" x "),
  });
}

// What is on the screen, not drawn anew: a picture of the page would let it stand still.
async function picture(page, name) {
  mkdirSync(given.pictures, { recursive: true });
  const data = await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
      const { stage } = window.marketgen;
      stage.draw(stage.still);
      done(stage.canvas.toDataURL("image/png"));
    }))),
  );
  writeFileSync(join(given.pictures, `${name}.png`), Buffer.from(data.split(",")[1], "base64"));
}

async function opening(browser, address, server, round) {
  const spent = browserSeconds();
  const { page, faults, close } = await openPage(browser, address);
  await page.waitForFunction(() => window.marketgen?.times.picture !== undefined, null, { timeout: patience, polling: 50 });
  const first = spentSince(spent);
  await page.waitForFunction(() => window.marketgen?.times.complete !== undefined, null, { timeout: patience });
  const all = spentSince(spent);
  const seen = await page.evaluate(() => {
    const answers = performance.getEntriesByType("resource").concat(performance.getEntriesByType("navigation"));
    return { ...window.marketgen.times, bytes: answers.reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0) };
  });
  if (faults.length > 0) throw new Error(faults.join("; "));
  say("viewer_first_picture", seen.picture / 1000, "s", { processor_s: first });
  say("viewer_room", seen.room / 1000, "s");
  say("viewer_complete", seen.complete / 1000, "s", { processor_s: all });
  say("viewer_bytes", seen.bytes / 1e6, "MB");
  await walk(page, round);
  say("viewer_server_memory_peak", peakMegabytes(server), "MB");
  await close();
}

if (given.first) await firstOpening();
const maker = await serve([store]);
await built(maker.address);
await end(maker.server);
const { server, address } = await serve([store]);
await built(address);
const browser = await launch();
try {
  for (let round = 0; round < Number(given.rounds); round++) await opening(browser, address, server, round);
} finally {
  await browser.close();
  await end(server);
}
