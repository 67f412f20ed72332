import { shortText } from '@farol/editing';
import type { AssetType } from '@farol/editing/fields';
import type { WebGLRenderer } from 'three';
import type { AssetMemory } from './Asset';

/** Options of a fetch of bytes. */
export interface FetchOptions {
  /**
   * Whether the address is of another origin, which the user has allowed: fetched without cookies and referrer, and
   * redirects to a third origin are refused.
   */
  readonly isLimited?: boolean;
  /** Whether redirects to another origin are refused, as for addresses of the page's origin in a scene. */
  readonly staysHere?: boolean;
}

/** Fetches the bytes of an address. */
export type FetchBytes = (url: string, options?: FetchOptions) => Promise<ArrayBuffer>;

/** Types of assets that are read from files. */
export type FileAssetType = Extract<AssetType, 'mesh' | 'texture' | 'model' | 'sound' | 'profile' | 'bake'>;

/** Endings of the files that can be read, for messages. */
export const readableEndings =
  '.glb, .gltf, .ply, .ply.gz, .png, .jpg, .webp, .ktx2, .hdr, .exr, .cube, .ies, .mp3, .ogg, .wav, .m4a and .flac';

const limited: RequestInit = { credentials: 'omit', referrerPolicy: 'no-referrer', redirect: 'error' };

/** Reads an address with `fetch`. @throws Error with the HTTP status when it is not there */
export async function fetchBytes(
  url: string,
  { isLimited = false, staysHere = false }: FetchOptions = {},
): Promise<ArrayBuffer> {
  const address = shortText(url, 120);
  let response: Response;
  try {
    response = await fetch(url, isLimited ? limited : staysHere ? { redirect: 'error' } : {});
  } catch (cause) {
    const refuses = isLimited ? ', refuses other pages,' : staysHere ? ',' : '';
    const reason = refuses && `${refuses} or sends on to another address`;
    throw new Error(`${address} cannot be reached${reason}: check the address.`, { cause });
  }
  if (!response.ok) throw new Error(`${address} answered ${response.status} ${shortText(response.statusText)}`.trim());
  return response.arrayBuffer();
}

/** Path of a URL without query and fragment, in lower case. */
export const pathOf = (url: string): string => url.split(/[?#]/)[0].toLowerCase();

/** Asset type of an address or file name, by its extension; null for an unknown extension. */
export function typeOfUrl(url: string): FileAssetType | null {
  const path = pathOf(url);
  if (/\.(glb|gltf)$/.test(path)) return 'model';
  if (/\.ply(\.gz)?$/.test(path)) return 'mesh';
  if (/\.(mp3|ogg|oga|opus|wav|m4a|flac)$/.test(path)) return 'sound';
  if (path.endsWith('.ies')) return 'profile';
  if (path.endsWith('.bake')) return 'bake';
  return /\.(png|jpe?g|webp|ktx2|hdr|exr|cube)$/.test(path) ? 'texture' : null;
}

export interface ReadOptions {
  /** Renderer of the asset; needed only for KTX2 textures. */
  readonly renderer?: WebGLRenderer | null;
  /** Memory of the asset, and of all assets of its library, for the limit on their sum. */
  readonly memory?: { readonly own: AssetMemory; all(): readonly AssetMemory[] };
  /** Cancels the fetching when aborted. */
  readonly signal?: AbortSignal;
}

/** Whether assets of a type are read from files. */
export const isFileAssetType = (type: AssetType | null): type is FileAssetType =>
  type === 'mesh' ||
  type === 'texture' ||
  type === 'model' ||
  type === 'sound' ||
  type === 'profile' ||
  type === 'bake';
