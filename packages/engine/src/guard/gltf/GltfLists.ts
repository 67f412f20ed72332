import { describeValue } from '@farol/editing/fields';
import { counted } from '../../base/counted';
import type { GltfJson } from './readGltfJson';

type JsonRecord = Record<string, unknown>;

/** Lists of a glTF whose items are named by index, with the noun for one item. */
const names = {
  accessors: 'accessor',
  animations: 'animation',
  buffers: 'buffer',
  bufferViews: 'buffer view',
  cameras: 'camera',
  images: 'image',
  materials: 'material',
  meshes: 'mesh',
  nodes: 'node',
  samplers: 'sampler',
  scenes: 'scene',
  skins: 'skin',
  textures: 'texture',
} as const;

export type GltfListName = keyof typeof names;

/** Maximum depth of nested lists and objects: `extras` may hold anything, and three copies it. */
const DEEPEST = 128;

/** Reads typed values from the JSON of a glTF. Each method throws an Error of one sentence for another type. */
export class GltfLists {
  private readonly lists = new Map<GltfListName, JsonRecord[]>();

  constructor(readonly json: GltfJson) {
    this.checkDepth();
    for (const name of Object.keys(names) as GltfListName[]) {
      const list = (json as JsonRecord)[name];
      if (list === undefined) continue;
      this.lists.set(
        name,
        this.listOf(list, `'${name}'`).map((each, i) => {
          if (typeof each !== 'object' || each === null) this.fail(`${names[name]} ${i} is no object`);
          const record = each as JsonRecord;
          if (record.name && typeof record.name !== 'string') {
            this.fail(`the name of ${names[name]} ${i} must be a text, not ${describeValue(record.name)}`);
          }
          return record;
        }),
      );
    }
  }

  fail(problem: string): never {
    throw new Error(`${problem}: export it again.`);
  }

  show(value: unknown): string {
    return describeValue(value);
  }

  all(name: GltfListName): readonly JsonRecord[] {
    return this.lists.get(name) ?? [];
  }

  listOf(value: unknown, what: string): unknown[] {
    if (!Array.isArray(value)) this.fail(`${what} must be a list, not ${describeValue(value)}`);
    return value as unknown[];
  }

  /** The value if it is an object; else an empty object. */
  record(value: unknown): JsonRecord {
    return typeof value === 'object' && value !== null ? (value as JsonRecord) : {};
  }

  /** Checks that a value of the file is an integer of at least 0. */
  whole(value: unknown, what: string): number {
    if (!Number.isSafeInteger(value) || (value as number) < 0) {
      this.fail(`${what} must be a whole number of at least 0, not ${describeValue(value)}`);
    }
    return value as number;
  }

  /** Checks that a value is a valid index into a list. @param who - subject of the message */
  index(value: unknown, list: GltfListName, who: string): number {
    const { length } = this.all(list);
    if (!Number.isInteger(value) || (value as number) < 0 || (value as number) >= length) {
      this.fail(`${who} names the ${names[list]} ${describeValue(value)}, and there are ${counted(length)}`);
    }
    return value as number;
  }

  private checkDepth(): void {
    let level: unknown[] = [this.json];
    for (let depth = 0; level.length > 0; depth++) {
      if (depth > DEEPEST) this.fail(`its JSON is more than ${DEEPEST} lists and objects deep`);
      level = level.flatMap((each) =>
        Object.values(each as JsonRecord).filter((inner) => typeof inner === 'object' && inner),
      );
    }
  }
}
