import { formatCount, t } from '@farol/editing';

/** Pixel limit of a picture: 7,680 × 4,320. A technique needs about 40 bytes per pixel. */
const MOST_PIXELS = 7680 * 4320;

/**
 * Largest pixel ratio at which a picture can be drawn.
 * @param width - CSS pixels
 * @param height - CSS pixels
 * @param dpr - requested device pixels per CSS pixel
 * @param side - greatest number of pixels per side on the device
 * @returns the ratio, `dpr` at most, and a message if it is less, otherwise ''
 */
export function fitSize(width: number, height: number, dpr: number, side: number): { dpr: number; problem: string } {
  const fits = Math.min(dpr, side / width, side / height, Math.sqrt(MOST_PIXELS / (width * height)));
  if (fits >= dpr) return { dpr, problem: '' };
  const size = (ratio: number): string => `${formatCount(width * ratio)} × ${formatCount(height * ratio)}`;
  const problem = t(
    'The picture would have {size} pixels. It is drawn with {fitted}: this device draws {side} a side, and the viewer {most} million in all.',
    { size: size(dpr), fitted: size(fits), side: formatCount(side), most: formatCount(MOST_PIXELS / 1e6) },
  );
  return { dpr: fits, problem };
}

/** Greatest number of pixels per side on a device; infinite on a lost context, whose parameters are all null. */
export function largestSide(gl: WebGLRenderingContext | WebGL2RenderingContext): number {
  const [width, height] = (gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array | null) ?? [];
  const limits = [gl.MAX_TEXTURE_SIZE, gl.MAX_RENDERBUFFER_SIZE].map((name) => gl.getParameter(name) as number);
  return Math.min(...[width, height, ...limits].map((side) => side || Infinity));
}
