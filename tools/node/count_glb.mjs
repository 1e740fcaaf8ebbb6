// What three.js makes of a GLB file: `node tools/node/count_glb.mjs FILE.glb` prints one line of JSON with the products that it
// shows and the box around everything, Y up.
//
// Pictures are left out: Node has no canvas to decode them on. That they decode is what validate_glb.mjs sees to.
import { readFileSync } from 'node:fs';
import * as THREE from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

globalThis.self ??= globalThis;
const bytes = readFileSync(process.argv[2]);
const started = performance.now();
const loader = new GLTFLoader();
loader.register((parser) => {
  parser.textureLoader = { isImageBitmapLoader: false, load: (_url, done) => done(new THREE.Texture()) };
  return { name: 'no_pictures' };
});
const gltf = await loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
gltf.scene.updateMatrixWorld(true);

// A product is a node with the extra "sku" (a group when its mesh has several materials); instanced meshes have many.
let products = 0;
gltf.scene.traverse((object) => {
  if (object.userData.sku === undefined || object.parent?.userData.sku !== undefined) return;
  let copies = 1;
  object.traverse((part) => { if (part.isInstancedMesh) copies = part.count; });
  products += copies;
});
const box = new THREE.Box3().setFromObject(gltf.scene, true);
console.log(JSON.stringify({
  products, low: box.min.toArray(), high: box.max.toArray(), seconds: (performance.now() - started) / 1000,
}));
