// The container of the server's binary answers, "MGV1": a JSON head that names flat arrays, and the arrays.
export type Numbers = Float32Array | Uint32Array | Uint16Array | Int16Array | Uint8Array | Int8Array;

const kinds = {
  f32: Float32Array,
  u32: Uint32Array,
  u16: Uint16Array,
  i16: Int16Array,
  u8: Uint8Array,
  i8: Int8Array,
} as const;
type Kind = keyof typeof kinds;

interface Section {
  type: Kind;
  components: number;
  count: number;
  offset: number;
}

export class PackedError extends Error {}

// Named arrays, wherever they come from.
export interface Sections {
  f32(name: string, components: number): Float32Array;
  u32(name: string, components: number): Uint32Array;
  u16(name: string, components: number): Uint16Array;
  i16(name: string, components: number): Int16Array;
  u8(name: string, components: number): Uint8Array;
  i8(name: string, components: number): Int8Array;
}

export class MemorySections implements Sections {
  constructor(private readonly arrays: Readonly<Record<string, Numbers>>) {}
  f32(name: string): Float32Array {
    return this.array(name) as Float32Array;
  }
  u32(name: string): Uint32Array {
    return this.array(name) as Uint32Array;
  }
  u16(name: string): Uint16Array {
    return this.array(name) as Uint16Array;
  }
  i16(name: string): Int16Array {
    return this.array(name) as Int16Array;
  }
  u8(name: string): Uint8Array {
    return this.array(name) as Uint8Array;
  }
  i8(name: string): Int8Array {
    return this.array(name) as Int8Array;
  }

  private array(name: string): Numbers {
    const found = this.arrays[name];
    if (!found) throw new PackedError(`there is no section ${name}`);
    return found;
  }
}

export class Packed<Head> implements Sections {
  readonly head: Head;
  private readonly sections: Record<string, Section>;
  private readonly data: number;

  constructor(
    private readonly buffer: ArrayBuffer,
    private readonly name: string,
  ) {
    const view = new DataView(buffer);
    if (buffer.byteLength < 8 || view.getUint32(0) !== 0x4d475631) throw new PackedError(`${name} is not MGV1`);
    const length = view.getUint32(4, true);
    if (8 + length > buffer.byteLength) throw new PackedError(`${name} is cut off`);
    this.data = 8 + length;
    let head: unknown;
    try {
      head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
    } catch {
      throw new PackedError(`the head of ${name} is not JSON`);
    }
    if (typeof head !== "object" || head === null || !("sections" in head)) throw new PackedError(`${name} has no sections`);
    this.sections = head.sections as Record<string, Section>;
    this.head = head as Head;
  }

  f32(name: string, components: number): Float32Array {
    return this.array(name, "f32", components) as Float32Array;
  }
  u32(name: string, components: number): Uint32Array {
    return this.array(name, "u32", components) as Uint32Array;
  }
  u16(name: string, components: number): Uint16Array {
    return this.array(name, "u16", components) as Uint16Array;
  }
  i16(name: string, components: number): Int16Array {
    return this.array(name, "i16", components) as Int16Array;
  }
  u8(name: string, components: number): Uint8Array {
    return this.array(name, "u8", components) as Uint8Array;
  }
  i8(name: string, components: number): Int8Array {
    return this.array(name, "i8", components) as Int8Array;
  }

  private array(name: string, kind: Kind, components: number): Numbers {
    const section = this.sections[name];
    if (!section || section.type !== kind || section.components !== components) {
      throw new PackedError(`${this.name}: no section ${name} of ${kind} x ${components}`);
    }
    const start = this.data + section.offset;
    const count = section.count * components;
    if (start + count * kinds[kind].BYTES_PER_ELEMENT > this.buffer.byteLength) {
      throw new PackedError(`${this.name}: ${name} is cut off`);
    }
    return new kinds[kind](this.buffer, start, count);
  }
}
