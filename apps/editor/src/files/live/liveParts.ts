import type { FarolFile, FileAsset } from '@farol/engine/files';
import { assembleParts, type FileHead, HEAD, type PartChange, type PartKey } from '../autosave/parts';

/**
 * Messages to viewing pages. The parts of a scene are those of the autosave, with the head in pieces: 'h/KEY' (a member
 * of the head), 'a/NAME' (an asset), and 'scripts' (whether they run). A whole scene is sent as one 'whole', any number
 * of 'parts', and an 'end'; parts after that are edits.
 */
export type LiveMessage =
  | { readonly kind: 'whole' | 'end'; readonly to?: number }
  // the editor begins to play: viewing pages restart the scene
  | { readonly kind: 'play'; readonly to?: undefined }
  | { readonly kind: 'parts'; readonly to?: number; readonly parts: readonly PartChange[] };

/** Messages from the dev server; `number` is that of the viewing page that waits for the whole scene. */
export type RelayMessage =
  | { readonly kind: 'hello'; readonly id: string; readonly looks: number }
  | { readonly kind: 'looks'; readonly looks: number }
  | { readonly kind: 'join'; readonly number: number }
  | { readonly kind: 'away' }
  | { readonly kind: 'problem'; readonly problem: string };

/** An asset of a file, with the SHA-256 (hex) of its bytes. */
export type LiveAsset = FileAsset & { readonly hash?: string };

export const SCRIPTS: PartKey = 'scripts';
export const headKey = (name: string): PartKey => `h/${name}`;
export const assetKey = (name: string): PartKey => `a/${name}`;

/** Address of the dev server's socket. @param query - 'edit=KEY' or 'look=ID' */
export function liveSocket(query: string): WebSocket {
  const { protocol, host } = location;
  return new WebSocket(`${protocol === 'https:' ? 'wss' : 'ws'}://${host}/farol-live?${query}`);
}

/** Address of an asset's bytes on the dev server. */
export const liveAsset = (id: string, hash: string): string => `/farol-live/${id}/${hash}`;

/** Splits a scene file's head into parts. @param hashOf - SHA-256 of an asset's bytes; undefined for one without */
export function splitHead(json: string, hashOf: (asset: FileAsset) => string | undefined): Map<PartKey, string> {
  const { assets, ...rest } = JSON.parse(json) as FileHead;
  const parts = new Map(Object.entries(rest).map(([name, value]) => [headKey(name), JSON.stringify(value)]));
  for (const asset of assets) parts.set(assetKey(asset.name), JSON.stringify({ ...asset, hash: hashOf(asset) }));
  return parts;
}

/** Values of all parts whose key begins with `prefix`, by the rest of the key. */
export function partsBelow(parts: ReadonlyMap<PartKey, string>, prefix: string): Map<string, unknown> {
  const found = [...parts].filter(([key]) => key.startsWith(prefix));
  return new Map(found.map(([key, json]) => [key.slice(prefix.length), JSON.parse(json) as unknown]));
}

/** The scene file that parts make, without hashes. @throws Error when parts are missing */
export function fileOfParts(parts: ReadonlyMap<PartKey, string>): FarolFile {
  const assets = [...partsBelow(parts, 'a/').values()].map((asset) => {
    const { hash: _hash, ...inFile } = asset as LiveAsset;
    return inFile;
  });
  const head = { ...Object.fromEntries(partsBelow(parts, 'h/')), assets };
  return assembleParts(new Map([...parts, [HEAD, JSON.stringify(head)]]));
}

/** Changes that lead from one set of parts to another. */
export const changesBetween = (
  before: ReadonlyMap<PartKey, string>,
  after: ReadonlyMap<PartKey, string>,
): PartChange[] => [
  ...[...after].filter(([key, json]) => before.get(key) !== json),
  ...[...before.keys()].filter((key) => !after.has(key)).map((key): PartChange => [key, null]),
];
