// What is drawn over the store: found and selected products, a selected fixture, zones on the floor, the measure tape.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  EdgesGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Quaternion as Turn,
  ShapeUtils,
  SphereGeometry,
  Vector2,
  Vector3,
  type Object3D,
} from "three";
import type { Vec3 } from "../camera/vector";
import type { Aisle, Fixture, Sku, Violation, Zone } from "../store/contract";
import { rotationOf, type GoodsTable } from "./goods_table";

export const accent = 0xff6a13;
const aisleColor = new Color(0x2f6fde);
const violationColor = new Color(0xd3122f);
const stem = { width: 0.06, height: 2.2 }; // metres, of what points at a broken rule
const swell = 0.004; // metres by which marks stand off from what they mark

// One colour a type of zone, of equal lightness, by the order in which the types appear.
export function zoneColor(index: number): Color {
  return new Color().setHSL((index * 0.381966) % 1, 0.62, 0.52);
}

function boxOfProduct(table: GoodsTable, skus: readonly Sku[], row: number): Matrix4 {
  const size = skus[table.sku[row]!]!.size_m;
  const turn = new Turn(...rotationOf(table, row));
  const at = new Vector3(table.position[row * 3]!, table.position[row * 3 + 1]!, table.position[row * 3 + 2]!);
  at.add(new Vector3(0, 0, size[2] / 2).applyQuaternion(turn));
  return new Matrix4().compose(at, turn, new Vector3(size[0] + swell, size[1] + swell, size[2] + swell));
}

function freed(object: Object3D): void {
  object.traverse((child) => {
    if (child instanceof Mesh || child instanceof LineSegments) {
      child.geometry.dispose();
      (child.material as { dispose(): void }).dispose();
    }
  });
  object.removeFromParent();
}

export class Overlays {
  readonly group = new Group();
  private readonly slots = new Map<string, Object3D>();

  constructor(
    private readonly table: GoodsTable,
    private readonly skus: readonly Sku[],
  ) {}

  highlight(rows: readonly number[]): void {
    const marks = new Group();
    for (const [through, opacity] of [
      [false, 0.4],
      [true, 0.07],
    ] as const) {
      const material = new MeshBasicMaterial({ color: accent, transparent: true, opacity, depthTest: !through, depthWrite: false });
      const mesh = new InstancedMesh(new BoxGeometry(1, 1, 1), material, rows.length);
      rows.forEach((row, i) => mesh.setMatrixAt(i, boxOfProduct(this.table, this.skus, row)));
      mesh.frustumCulled = false;
      mesh.renderOrder = 2000;
      marks.add(mesh);
    }
    this.put("highlight", rows.length > 0 ? marks : undefined);
  }

  selectProduct(row: number | undefined): void {
    this.put("selected", row === undefined ? undefined : this.outline(boxOfProduct(this.table, this.skus, row)));
  }

  selectFixture(fixture: Fixture): void {
    const [w, d, h] = fixture.size_m;
    const [x, y, z] = fixture.position_m;
    const turn = new Turn().setFromAxisAngle(new Vector3(0, 0, 1), (fixture.yaw_deg * Math.PI) / 180);
    const box = new Matrix4().compose(new Vector3(x, y, z + h / 2), turn, new Vector3(w + 0.02, d + 0.02, h + 0.02));
    this.put("selected", this.outline(box));
  }

  showZones(zones: readonly Zone[]): void {
    const floor = new Group();
    const types = [...new Set(zones.map((zone) => zone.type))];
    for (const zone of zones) {
      const corners = zone.polygon_mm.map(([x, y]) => new Vector2(x / 1000, y / 1000));
      if (corners.length < 3) continue;
      const color = zoneColor(types.indexOf(zone.type));
      floor.add(this.area(corners, color), this.border(corners, color));
    }
    this.put("zones", zones.length > 0 ? floor : undefined);
  }

  showAisles(aisles: readonly Aisle[]): void {
    const floor = new Group();
    for (const { polygon_mm } of aisles) {
      const corners = polygon_mm.map(([x, y]) => new Vector2(x / 1000, y / 1000));
      if (corners.length >= 3) floor.add(this.area(corners, aisleColor), this.border(corners, aisleColor));
    }
    this.put("aisles", aisles.length > 0 ? floor : undefined);
  }

  showViolations(violations: readonly Violation[]): void {
    const stems = new Group();
    for (const { at_mm } of violations) {
      if (!at_mm) continue;
      const material = new MeshBasicMaterial({ color: violationColor, transparent: true, opacity: 0.85 });
      const mesh = new Mesh(new BoxGeometry(stem.width, stem.width, stem.height), material);
      mesh.position.set(at_mm[0] / 1000, at_mm[1] / 1000, stem.height / 2);
      mesh.renderOrder = 1502;
      stems.add(mesh);
    }
    this.put("violations", stems.children.length > 0 ? stems : undefined);
  }

  showTape(points: readonly Vec3[]): void {
    const tape = new Group();
    for (const point of points) {
      const ball = new Mesh(new SphereGeometry(0.012, 12, 8), new MeshBasicMaterial({ color: accent, depthTest: false, transparent: true }));
      ball.position.set(...point);
      ball.renderOrder = 2002;
      tape.add(ball);
    }
    if (points.length === 2) {
      const geometry = new BufferGeometry().setFromPoints(points.map((point) => new Vector3(...point)));
      const line = new LineSegments(geometry, new LineBasicMaterial({ color: accent, depthTest: false, transparent: true }));
      line.renderOrder = 2002;
      tape.add(line);
    }
    this.put("tape", points.length > 0 ? tape : undefined);
  }

  private put(slot: string, object: Object3D | undefined): void {
    const old = this.slots.get(slot);
    if (old) freed(old);
    this.slots.delete(slot);
    if (!object) return;
    this.slots.set(slot, object);
    this.group.add(object);
  }

  private outline(box: Matrix4): Object3D {
    const marks = new Group();
    const cube = new BoxGeometry(1, 1, 1);
    for (const [through, opacity] of [
      [false, 1],
      [true, 0.35],
    ] as const) {
      const material = new LineBasicMaterial({ color: accent, transparent: true, opacity, depthTest: !through, depthWrite: false });
      const lines = new LineSegments(new EdgesGeometry(cube), material);
      lines.renderOrder = 2001;
      marks.add(lines);
    }
    const fill = new MeshBasicMaterial({ color: accent, transparent: true, opacity: 0.14, depthWrite: false });
    const body = new Mesh(cube, fill);
    body.renderOrder = 2000;
    marks.add(body);
    marks.applyMatrix4(box);
    return marks;
  }

  private area(corners: Vector2[], color: Color): Mesh {
    const faces = ShapeUtils.triangulateShape(corners, []);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flatMap((c) => [c.x, c.y, 0.012])), 3));
    geometry.setIndex(faces.flat());
    const material = new MeshBasicMaterial({ color, transparent: true, opacity: 0.4, depthWrite: false, side: DoubleSide });
    const mesh = new Mesh(geometry, material);
    mesh.renderOrder = 1500;
    return mesh;
  }

  private border(corners: Vector2[], color: Color): LineSegments {
    const points = corners.flatMap((corner, i) => [corner, corners[(i + 1) % corners.length]!]);
    const geometry = new BufferGeometry().setFromPoints(points.map((p) => new Vector3(p.x, p.y, 0.02)));
    const lines = new LineSegments(geometry, new LineBasicMaterial({ color, transparent: true }));
    lines.renderOrder = 1501;
    return lines;
  }
}
