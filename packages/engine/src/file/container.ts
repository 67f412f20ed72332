import type { Scene } from '../core/Scene';
import type { FarolFile } from './FarolFile';
import { FileError } from './FileError';
import { readZip } from './readZip';
import { serialize } from './serialize';
import type { MayUnpack } from './unpack';

/** Name of the scene in a container. */
export const SCENE_ENTRY = 'scene.json';

/** A scene file that was read: the scene as text, and the files that came with it. */
export interface SceneFile {
  readonly text: string;
  /** The bytes of a file of the container; null when it has none. */
  fileOf(path: string): Blob | null;
}

/** What is in a container: the scene, and each asset's bytes. */
export interface ContainerContent {
  readonly file: FarolFile;
  /** By path in the container. */
  readonly files: ReadonlyMap<string, Blob>;
}

/** The scene as a file, and the assets that belong into its container. */
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
  // a fixed date: the same scene is the same file
  const mtime = new Date(2000, 0, 1);
  return zipSync({ [SCENE_ENTRY]: [scene, { level: 1 }], ...Object.fromEntries(entries) } as never, {
    mtime,
  }) as Uint8Array<ArrayBuffer>;
}

const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

const fail = (problem: string, cause?: unknown): never => {
  throw new FileError([{ path: '', problem }], { cause });
};

/**
 * Reads a scene file: a `.farol` container, or plain JSON. The scene is not checked here: give it to `deserialize`, with
 * `fileOf`.
 * @param mayUnpack - asked before the container becomes large; such a one is refused when absent. See `unpackLimits`
 * @throws FileError (as a rejection) when the bytes are neither, are cut short, or become too large; AbortError when
 * `mayUnpack` answers no
 */
export async function readSceneFile(bytes: Uint8Array, mayUnpack?: MayUnpack): Promise<SceneFile> {
  if (bytes.length === 0) fail('The file is empty: open another copy of it.');
  if (bytes[0] === 0x50 && bytes[1] === 0x4b) {
    const entries = await readZip(bytes as Uint8Array<ArrayBuffer>, mayUnpack);
    const scene = entries.get(SCENE_ENTRY);
    if (!scene) fail(`The ZIP holds no ${SCENE_ENTRY}: choose a .farol file, or drop models and textures on Assets.`);
    return {
      text: textOf(scene!),
      fileOf: (path) => (entries.has(path) ? new Blob([entries.get(path)!]) : null),
    };
  }
  if (textOf(bytes.subarray(0, 4)) === 'glTF') fail('The file is a GLB, no scene of Farol: drop it on Assets.');
  return { text: textOf(bytes), fileOf: () => null };
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
