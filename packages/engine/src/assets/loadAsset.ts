import { shortText } from '@farol/renderer';
import { RepeatWrapping, SRGBColorSpace, Texture, type WebGLRenderer } from 'three';
import type { AssetType } from '../fields/Field';
import { fitGeometry } from '../geometry/fitGeometry';
import { parsePly } from '../geometry/parsePly';
import type { Asset } from './Asset';
import { checkImageSize } from './imageSize';
import { readEnvironment } from './readEnvironment';
import { readModel } from './readModel';

export interface FetchOptions {
  /**
   * The address leads away from the page, by leave: no cookies, no referrer, and no going on to a third place, which nobody
   * was asked about.
   */
  readonly isLimited?: boolean;
}

/** Reads the bytes of an address. */
export type FetchBytes = (url: string, options?: FetchOptions) => Promise<ArrayBuffer>;

/** Types of assets that are read from files. */
export type FileAssetType = Extract<AssetType, 'mesh' | 'texture' | 'model'>;

/** Endings of the files that can be read, for messages. */
export const readableEndings = '.glb, .gltf, .ply, .ply.gz, .png, .jpg, .webp, .hdr and .exr';

const limited: RequestInit = { credentials: 'omit', referrerPolicy: 'no-referrer', redirect: 'error' };

/** Reads an address with `fetch`. @throws Error with the HTTP status when it is not there */
export async function fetchBytes(url: string, { isLimited = false }: FetchOptions = {}): Promise<ArrayBuffer> {
  const address = shortText(url, 120);
  let response: Response;
  try {
    response = await fetch(url, isLimited ? limited : {});
  } catch (cause) {
    const reason = isLimited ? ', refuses other pages, or sends on to another address' : '';
    throw new Error(`${address} cannot be reached${reason}.`, { cause });
  }
  if (!response.ok) throw new Error(`${address} answered ${response.status} ${shortText(response.statusText)}`.trim());
  return response.arrayBuffer();
}

const pathOf = (url: string): string => url.split(/[?#]/)[0].toLowerCase();

/** The type of asset that an address or a file name stands for, by its ending; null when it is none that can be read. */
export function typeOfUrl(url: string): FileAssetType | null {
  const path = pathOf(url);
  if (/\.(glb|gltf)$/.test(path)) return 'model';
  if (/\.ply(\.gz)?$/.test(path)) return 'mesh';
  return /\.(png|jpe?g|webp|hdr|exr)$/.test(path) ? 'texture' : null;
}

/** What the first bytes of a file say it is; null when they say nothing. */
function signatureOf(bytes: ArrayBuffer): string | null {
  const head = [...new Uint8Array(bytes, 0, Math.min(16, bytes.byteLength))];
  const text = String.fromCharCode(...head);
  if (text.startsWith('\x89PNG')) return 'PNG';
  if (text.startsWith('\xff\xd8\xff')) return 'JPEG';
  if (text.startsWith('RIFF') && text.slice(8, 12) === 'WEBP') return 'WebP';
  if (text.startsWith('#?')) return 'HDR';
  if (text.startsWith('v/1\x01')) return 'EXR';
  return null;
}

async function readTexture(bytes: ArrayBuffer): Promise<Texture> {
  checkImageSize(new Uint8Array(bytes));
  let image: ImageBitmap;
  try {
    image = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY' });
  } catch (cause) {
    const said = signatureOf(bytes);
    const reason = said
      ? `it begins as ${said}, and is damaged or cut short`
      : 'its bytes are no PNG, JPEG or WebP: was another file renamed?';
    throw new Error(`${reason}. Export it again from where it was made.`, { cause });
  }
  const texture = new Texture(image);
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.needsUpdate = true;
  return texture;
}

export interface ReadOptions {
  /** Scale a mesh to a longest side of 1 m and stand it on y = 0, centred in x and z. */
  readonly normalise?: boolean;
  /** What will draw the asset: needed for models with KTX2 textures only. */
  readonly renderer?: WebGLRenderer | null;
}

/**
 * Reads an asset from the bytes of its file.
 * @param path - address or name: what follows its last dot says which format it is
 * @throws Error that says what is wrong with the bytes
 */
export async function readAsset(
  bytes: ArrayBuffer,
  path: string,
  type: FileAssetType,
  options: ReadOptions = {},
): Promise<Asset> {
  if (bytes.byteLength === 0) throw new Error('the file is empty: choose it again.');
  if (type === 'model') return readModel(bytes, options.renderer);
  if (type === 'texture') {
    const said = signatureOf(bytes);
    if (said === 'HDR' || said === 'EXR') return readEnvironment(bytes, said);
    if (/\.(hdr|exr)$/.test(pathOf(path))) {
      const wanted = pathOf(path).endsWith('.hdr') ? 'Radiance HDR' : 'OpenEXR';
      throw new Error(`its bytes are ${said ?? 'something other'}, not ${wanted}: was another file renamed?`);
    }
    return readTexture(bytes);
  }
  const geometry = await parsePly(bytes);
  return options.normalise ? fitGeometry(geometry) : geometry;
}
