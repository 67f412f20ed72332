import { RepeatWrapping, SRGBColorSpace, Texture } from 'three';
import type { AssetType } from '../fields/Field';
import { fitGeometry } from '../geometry/fitGeometry';
import { parsePly } from '../geometry/parsePly';
import type { Asset } from './Asset';

/** Reads the bytes of an address. */
export type FetchBytes = (url: string) => Promise<ArrayBuffer>;

/** Reads an address with `fetch`. @throws Error with the HTTP status when it is not there */
export async function fetchBytes(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} answered ${response.status} ${response.statusText}`.trim());
  return response.arrayBuffer();
}

/** The type of asset that an address holds, by its ending; null when it is none that can be read. */
export function typeOfUrl(url: string): AssetType | null {
  const path = url.split(/[?#]/)[0].toLowerCase();
  if (/\.ply(\.gz)?$/.test(path)) return 'mesh';
  return /\.(png|jpe?g|webp)$/.test(path) ? 'texture' : null;
}

async function readTexture(bytes: ArrayBuffer): Promise<Texture> {
  const image = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY' });
  const texture = new Texture(image);
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.needsUpdate = true;
  return texture;
}

/**
 * Reads a mesh (PLY, gzip or not) or a texture (an image the browser can decode).
 * @param options - `normalise`: scale the mesh to a longest side of 1 m and stand it on y = 0, centred in x and z
 */
export async function loadAsset(
  url: string,
  type: 'mesh' | 'texture',
  read: FetchBytes,
  options: { normalise: boolean },
): Promise<Asset> {
  const bytes = await read(url);
  if (type === 'texture') return readTexture(bytes);
  const geometry = await parsePly(bytes);
  return options.normalise ? fitGeometry(geometry) : geometry;
}
