// Runs the Khronos glTF validator over files: `node tools/node/validate_glb.mjs FILE.glb...`
//
// Prints one line a file with its counts, and each error and warning; exits 1 when a file has an error.
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

const MOST_SHOWN = 20;
let failed = false;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`);
  const serious = messages.filter((message) => message.severity <= 1);
  for (const { code, message, pointer } of serious.slice(0, MOST_SHOWN)) console.log(`  ${code} ${pointer}: ${message}`);
  failed ||= numErrors > 0;
}
process.exitCode = failed ? 1 : 0;
