import { readFileSync } from "node:fs";
import { defineConfig } from "vitest/config";

// Whoever copies the page copies three.js, and with it this.
const licences = {
  name: "licences",
  generateBundle() {
    const source = readFileSync(new URL("node_modules/three/LICENSE", import.meta.url), "utf8");
    this.emitFile({ type: "asset", fileName: "licences/three.txt", source });
  },
};

// No inline scripts, no data: URLs, no module preload polyfill (which is inline): the server's content security policy allows
// files of its own origin alone. File names carry the hash of what they hold, so that a browser may keep them.
export default defineConfig({
  base: "./",
  plugins: [licences],
  build: {
    outDir: "dist",
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1500,
    reportCompressedSize: false,
  },
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
});
