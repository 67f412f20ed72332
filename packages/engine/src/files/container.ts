import type { Scene } from '../core/Scene';
import type { FarolFile } from './FarolFile';
import { serialize } from './serialize';

export const SCENE_ENTRY = 'scene.json';

/** Content of a container: the scene, and each asset's bytes. */
export interface ContainerContent {
  readonly file: FarolFile;
  /** Bytes of assets by path in the container. */
  readonly files: ReadonlyMap<string, Blob>;
}

/** Splits a scene into its JSON file and the asset files of its container. */
export function containerContent(scene: Scene): ContainerContent {
  const file = serialize(scene);
  const files = new Map<string, Blob>();
  for (const { name, file: path } of file.assets) {
    const blob = path === undefined ? null : scene.assets.fileOf(name);
    if (path !== undefined && blob) files.set(path, blob);
  }
  return { file, files };
}

/**
 * Packs a scene and its assets into one `.farol` file: a ZIP of `scene.json` (a FarolFile, deflated) and `assets/…`
 * (stored as they are, so that they load without unpacking). Any ZIP tool opens it.
 * @see PKWARE APPNOTE.TXT
 */
export async function writeContainer({ file, files }: ContainerContent): Promise<Uint8Array<ArrayBuffer>> {
  const entries = await Promise.all(
    [...files].map(async ([path, blob]) => [path, [new Uint8Array(await blob.arrayBuffer()), { level: 0 }]] as const),
  );
  const { zipSync } = await import('three/addons/libs/fflate.module.js');
  const scene = new TextEncoder().encode(`${JSON.stringify(file, null, 1)}\n`);
  // a fixed date, so that equal scenes give equal bytes
  const mtime = new Date(2000, 0, 1);
  return zipSync({ [SCENE_ENTRY]: [scene, { level: 1 }], ...Object.fromEntries(entries) } as never, {
    mtime,
  }) as Uint8Array<ArrayBuffer>;
}

const BLOCK = 0x8000;

async function dataUrl(blob: Blob): Promise<string> {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += BLOCK) text += String.fromCharCode(...bytes.subarray(i, i + BLOCK));
  return `data:application/octet-stream;base64,${btoa(text)}`;
}

/** A scene with the bytes of its assets as `data:` addresses: plain JSON that needs no container. */
export async function inlineAssets({ file, files }: ContainerContent): Promise<FarolFile> {
  const assets = await Promise.all(
    file.assets.map(async (asset) => {
      const blob = asset.file === undefined ? undefined : files.get(asset.file);
      return blob ? { name: asset.name, type: asset.type, url: await dataUrl(blob) } : asset;
    }),
  );
  return { ...file, assets };
}
