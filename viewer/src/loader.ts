// Brings the store in, in the order in which it is seen: boxes of goods, then the room, light, meshes and labels.
import { LinearFilter, LinearMipmapLinearFilter, LinearMipmapNearestFilter, RepeatWrapping, ClampToEdgeWrapping, Texture } from "three";
import { Client, ServerError } from "./store/client";
import type { MeshesHead, RoomHead, Summary } from "./store/contract";
import { Goods } from "./stage/goods";
import { readGoods } from "./stage/goods_table";
import { Overlays } from "./stage/overlays";
import { Room } from "./stage/room";
import { setFilm } from "./stage/shading";
import type { Stage } from "./stage/stage";

export interface Watch {
  step(share: number | undefined): void;
  shown(what: "goods" | "room" | "labels"): void;
}

const pollMilliseconds = 400;

async function watchServer(client: Client, watch: Watch, until: () => boolean): Promise<void> {
  while (!until()) {
    const progress = await client.progress();
    if (progress.state === "failed") return; // the answers that wait for it say why
    if (progress.state === "building") watch.step(0.1 + 0.4 * progress.share);
    if (progress.state === "ready") return;
    await new Promise((done) => setTimeout(done, pollMilliseconds));
  }
}

export function loadGoods(client: Client, stage: Stage, summary: Summary, watch: Watch, without: ReadonlySet<number> = new Set()): Promise<Goods> {
  return client.packed<unknown>("/goods.bin").then((packed) => {
    setFilm(stage.shared, packed.f32("film", 1));
    const table = readGoods(packed, summary.skus, without);
    const goods = new Goods(table, summary.skus, stage.shared, () => stage.redraw(), stage.redrawSoon);
    stage.goods = goods;
    stage.overlays = new Overlays(table, summary.skus);
    stage.scene.add(goods.group, stage.overlays.group);
    stage.redraw();
    watch.shown("goods");
    return goods;
  });
}

async function loadRoom(client: Client, stage: Stage, summary: Summary, watch: Watch): Promise<void> {
  const packed = await client.packed<RoomHead>("/room.bin");
  const room = await Room.create(packed, summary.joints, stage.shared);
  stage.room = room;
  stage.scene.add(room.group);
  stage.roomChanged();
  watch.shown("room");
  await Promise.all(room.textures().map((row) => loadTexture(client, stage, room, packed.head, row)));
}

async function loadTexture(client: Client, stage: Stage, room: Room, head: RoomHead, row: number): Promise<void> {
  const entry = head.textures[row];
  if (!entry) throw new ServerError("view.bad_answer", `room.bin names no texture ${row}`);
  const texture = new Texture(await client.picture(`/${entry.path}`));
  texture.flipY = false;
  texture.wrapS = texture.wrapT = entry.repeat ? RepeatWrapping : ClampToEdgeWrapping;
  texture.minFilter = stage.limits.quick ? LinearMipmapNearestFilter : LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.anisotropy = stage.limits.sharpness;
  texture.needsUpdate = true;
  room.setTexture(row, texture);
  stage.redraw();
}

// Resolves when the store is as it is meant, but for the labels of what is near.
export async function loadRest(client: Client, stage: Stage, goods: Goods, summary: Summary, watch: Watch): Promise<void> {
  let done = false;
  const watched = watchServer(client, watch, () => done).catch(() => undefined);
  const light = client.packed<unknown>("/goods-light.bin").then((packed) => goods.setLight({ cube: packed.u8("light", 18) }));
  const room = loadRoom(client, stage, summary, watch);
  const meshes = client.packed<MeshesHead>("/meshes.bin").then((packed) => goods.setMeshes(packed, client, stage.renderer, stage.limits));
  try {
    await Promise.all([room, light, meshes]);
    watch.shown("labels");
  } finally {
    done = true;
  }
  await watched;
  watch.step(undefined);
}
