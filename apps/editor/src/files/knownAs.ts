import type { AssetFile, AssetLibrary } from '@farol/engine';
import type { AssetType } from '@farol/engine/fields';

/** Number of bytes at the beginning and at the end of a file that are compared first. */
const END = 1024;

const fingerprints = new WeakMap<Blob, Promise<string>>();

async function makeFingerprint(blob: Blob): Promise<string> {
  const ends = await new Blob([blob.slice(0, END), blob.slice(-END)]).arrayBuffer();
  return String.fromCharCode(...new Uint8Array(ends));
}

/** The first and the last bytes of a file as a string; cached. */
function fingerprintOf(blob: Blob): Promise<string> {
  const known = fingerprints.get(blob) ?? makeFingerprint(blob);
  fingerprints.set(blob, known);
  return known;
}

async function sameBytes(a: Blob, b: Blob): Promise<boolean> {
  if (a === b) return true;
  if ((await fingerprintOf(a)) !== (await fingerprintOf(b))) return false;
  if (a.size <= END) return true;
  const [one, two] = await Promise.all([a.arrayBuffer(), b.arrayBuffer()]);
  const [left, right] = [new Uint8Array(one), new Uint8Array(two)];
  return left.every((byte, i) => byte === right[i]);
}

/** The files of a library by size, for fast comparison with many other files. */
export class KnownFiles {
  private readonly bySize = new Map<number, AssetFile[]>();

  constructor(assets: AssetLibrary) {
    for (const file of assets.files) this.add(file);
  }

  add(file: AssetFile): void {
    const { size } = file.blob;
    const list = this.bySize.get(size);
    if (list) list.push(file);
    else this.bySize.set(size, [file]);
  }

  /** Name of the asset with identical bytes, optionally of one type; null when there is none. */
  async find(blob: Blob, type?: AssetType): Promise<string | null> {
    for (const file of this.bySize.get(blob.size) ?? []) {
      if ((type === undefined || file.type === type) && (await sameBytes(file.blob, blob))) return file.name;
    }
    return null;
  }
}
