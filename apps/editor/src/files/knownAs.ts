import type { AssetLibrary } from '@farol/engine';
import type { AssetType } from '@farol/engine/fields';

async function sameBytes(a: Blob, b: Blob): Promise<boolean> {
  if (a === b) return true;
  if (a.size !== b.size) return false;
  const [one, two] = await Promise.all([a.arrayBuffer(), b.arrayBuffer()]);
  const [left, right] = [new Uint8Array(one), new Uint8Array(two)];
  return left.every((byte, i) => byte === right[i]);
}

/** The asset that has these very bytes already, of one type when given; null when there is none. */
export async function knownAs(assets: AssetLibrary, blob: Blob, type?: AssetType): Promise<string | null> {
  for (const file of assets.files) {
    if ((type === undefined || file.type === type) && (await sameBytes(file.blob, blob))) return file.name;
  }
  return null;
}
