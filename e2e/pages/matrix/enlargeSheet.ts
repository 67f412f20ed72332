import type { FrameBudget } from '@farol/renderer';
import type { TechniqueName } from '@farol/renderer';
import { TAA } from '@farol/renderer/antialiasing';
import { compareImages } from '../../support/images';
import { Bench, type PageImage } from '../Bench';
import type { Cases } from './Case';
import { sheets } from './runSheet';
import { CLEAR, Sheet, sheetSize } from './Sheet';

/** Linear values of bytes that are encoded for the display. */
const decoded = Float32Array.from({ length: 256 }, (_, byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

function bytesOf(bench: Bench, draw: () => void): Uint8Array {
  draw();
  const gl = bench.webgl.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const data = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return data;
}

const imageOf = (width: number, height: number, data: ArrayLike<number>): PageImage => ({
  width,
  height,
  data: Float32Array.from(data, (value) => decoded[Math.round(value)]),
});

/** Bytes of a picture, enlarged by bilinear filtering of the encoded values, as a browser enlarges a canvas. */
function bilinear(from: Uint8Array, [w, h]: readonly number[], width: number, height: number): Float32Array {
  const to = new Float32Array(width * height * 4);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const u = Math.min(Math.max(((x + 0.5) * w) / width - 0.5, 0), w - 1);
      const v = Math.min(Math.max(((y + 0.5) * h) / height - 0.5, 0), h - 1);
      const [x0, y0] = [Math.floor(u), Math.floor(v)];
      const [x1, y1] = [Math.min(x0 + 1, w - 1), Math.min(y0 + 1, h - 1)];
      for (let c = 0; c < 4; c++) {
        const at = (x: number, y: number) => from[(y * w + x) * 4 + c];
        const low = at(x0, y0) * (1 - u + x0) + at(x1, y0) * (u - x0);
        const high = at(x0, y1) * (1 - u + x0) + at(x1, y1) * (u - x0);
        to[(y * width + x) * 4 + c] = low * (1 - v + y0) + high * (v - y0);
      }
    }
  return to;
}

/**
 * How near a sheet of the matrix comes to its picture at full size (PSNR, dB) when it is drawn on a smaller canvas, enlarged
 * bilinearly and by a frame budget.
 *
 * @param sharpnesses - of the budgets
 */
export async function enlargeSheet(
  name: keyof typeof sheets,
  technique: TechniqueName,
  scale: number,
  sharpnesses: readonly number[],
  { antialias = false, temporal = false } = {},
): Promise<{ bilinear: number; enlarged: number[] }> {
  const listed: Cases | (() => Promise<Cases>) = sheets[name];
  const cases = typeof listed === 'function' ? await listed() : listed;
  const { width, height } = sheetSize(cases);
  const small = [Math.round(width * scale), Math.round(height * scale)];
  const bench = new Bench(width, height, { renderer: { stencil: true, antialias } });
  const { webgl, farol } = bench;
  webgl.localClippingEnabled = true;
  webgl.setClearColor(CLEAR.color, CLEAR.alpha);
  farol.technique = technique;
  const { scene, camera } = new Sheet(cases, { environment: bench.environment() });
  farol.effects = temporal ? [new TAA()] : [];
  // TAA's picture of a still scene averages 32 places in each pixel; some frames pass before TAA finds the scene still
  const frames = temporal ? 40 : 1;
  const draw = () => {
    for (let i = 0; i < frames; i++) farol.render(scene, camera);
  };
  const native = imageOf(width, height, bytesOf(bench, draw));
  const enlarged = sharpnesses.map((sharpness) => {
    farol.budget = { frame: 1e6, min: scale, max: scale, sharpness } satisfies FrameBudget;
    return compareImages(native, imageOf(width, height, bytesOf(bench, draw))).psnr;
  });
  farol.budget = null;
  bench.setSize(small[0], small[1]);
  const plain = bilinear(bytesOf(bench, draw), small, width, height);
  return { bilinear: compareImages(native, imageOf(width, height, plain)).psnr, enlarged };
}
