// `marketgen view` and a Chromium that draws without a GPU, for tests of its pages. Pictures that were taken lie in
// MARKETGEN_BROWSER_PICTURES, where that names a folder.
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

export const program = process.env.MARKETGEN_BINARY ?? join(import.meta.dirname, "../../build/release/marketgen");
const browserPath = process.env.MARKETGEN_CHROMIUM ?? "/usr/bin/chromium";
export const pictures = process.env.MARKETGEN_BROWSER_PICTURES;

async function addressOf(process) {
  let said = "";
  for await (const text of process.stdout) {
    said += text;
    const found = /http:\/\/\S+/.exec(said);
    if (found) return found[0];
  }
  throw new Error(`marketgen view ended without an address: ${said}`);
}

// The server of these stores and results, and its address.
export async function serve(words) {
  const server = spawn(program, ["view", ...words, "--no-open"], { stdio: ["ignore", "pipe", "inherit"] });
  return { server, address: await addressOf(server) };
}

// A folder with the store "shop" and an episode of each track, checkout.jsonl and so on; `run` calls the program there.
export function smallShop(name, tracks) {
  const folder = mkdtempSync(join(tmpdir(), `marketgen-${name}-`));
  const run = (...words) => execFileSync(program, words, { cwd: folder, stdio: ["ignore", "ignore", "inherit"] });
  run("generate", "a small shop with dairy and two checkouts", "--size", "12x9m", "--seed", "3", "--no-previews", "--quiet", "-o", "shop");
  for (const track of tracks) run("episodes", "shop", "--track", track, "--count", "1", "--seed", "1", "-o", `${track}.jsonl`);
  return { folder, run };
}

export const launch = () =>
  chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
  });

// A page of its own; `faults` gathers what the browser complains of.
export async function openPage(browser, address, options = {}, arrange = async () => {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: "en-GB", reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  const faults = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
  page.on("pageerror", (error) => faults.push(String(error)));
  await arrange(page);
  await page.goto(address);
  return { page, faults, close: () => context.close() };
}

export async function take(page, name) {
  if (!pictures) return;
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
}
