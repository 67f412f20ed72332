import { checkPixels } from './imageSize';

/**
 * Checks a KTX2 before the transcoder allocates memory for it.
 * @throws Error when the file is cut short, of absurd size, or holds more than one picture @see KTX 2.0, 3
 */
export function checkKtx2(view: DataView): void {
  if (view.byteLength < 80) throw new Error('it is cut short: export it again.');
  const [width, height, depth, layers, faces] = [20, 24, 28, 32, 36].map((at) => view.getUint32(at, true));
  checkPixels(width, Math.max(1, height));
  if (faces > 1 || layers > 1 || depth > 1)
    throw new Error('it holds a cube, an array or a volume: export one picture of it.');
}
