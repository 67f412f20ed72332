import { RepeatWrapping, type Texture } from 'three';
import { checkKtx2 } from '../guard/pictures/checkKtx2';
import type { ReadOptions } from './loadAsset';
import { makeKTX2Loader } from './makeKTX2Loader';

/**
 * Reads a KTX2 (Basis Universal, or a format of the device) as a texture. Its blocks stay compressed and cannot be
 * flipped: top-down rows, which most tools write, are flipped by the texture's UV transform.
 * @throws Error that says what is wrong with the bytes, or that there is no renderer to tell the device's formats
 */
export async function readKtx2(bytes: ArrayBuffer, { renderer, signal }: ReadOptions): Promise<Texture> {
  const view = new DataView(bytes);
  checkKtx2(view);
  if (!renderer) throw new Error('it is KTX2: give the AssetLibrary your WebGLRenderer.');
  const isBottomUp = orientationOf(bytes, view).startsWith('ru');
  const loader = await makeKTX2Loader(renderer);
  try {
    signal?.throwIfAborted();
    const texture = await new Promise<Texture>((resolve, reject) => {
      // parse() transfers its bytes to a worker, so it gets a copy
      loader.parse(bytes.slice(0), resolve, reject);
    });
    texture.wrapS = texture.wrapT = RepeatWrapping;
    if (!isBottomUp) {
      texture.userData.isTopDown = true;
      texture.repeat.y = -1;
      texture.offset.y = 1;
    }
    texture.needsUpdate = true;
    return texture;
  } catch (cause) {
    signal?.throwIfAborted();
    const said = cause instanceof Error ? cause.message.replace(/^THREE\.\w+:\s*/, '') : String(cause);
    throw new Error(`its KTX2 data are damaged or cut short (${said}): export it again.`, { cause });
  } finally {
    loader.dispose();
  }
}

/** Value of the file's `KTXorientation`, such as 'rd' (right, down) or 'ru'; 'rd' when absent. @see KTX 2.0, 5.3 */
function orientationOf(bytes: ArrayBuffer, view: DataView): string {
  const start = view.getUint32(56, true);
  const end = Math.min(bytes.byteLength, start + view.getUint32(60, true));
  for (let at = start; at + 4 <= end;) {
    const length = view.getUint32(at, true);
    const text = new TextDecoder().decode(new Uint8Array(bytes, at + 4, Math.min(length, end - at - 4)));
    const [key, value = ''] = text.split('\0');
    if (key === 'KTXorientation') return value;
    at += 4 + Math.ceil(length / 4) * 4;
    if (length === 0) break;
  }
  return 'rd';
}
