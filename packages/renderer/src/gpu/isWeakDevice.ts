import type { WebGLRenderer } from 'three';
import { drawBuffersOf } from './checkDevice';

/** Values of `FarolOptions.quality`. */
export const qualities = ['auto', 'full', 'lite'] as const;
export type Quality = (typeof qualities)[number];

/** Whether the quality 'auto' is 'lite' on a device; see `FarolOptions.quality` for the rule. */
export function isWeakDevice(webgl: WebGLRenderer): boolean {
  const { maxTextureSize, getMaxPrecision } = webgl.capabilities;
  const { deviceMemory = 8, maxTouchPoints } = navigator as Navigator & { readonly deviceMemory?: number };
  return (
    !webgl.extensions.has('EXT_color_buffer_float') ||
    drawBuffersOf(webgl.getContext() as WebGL2RenderingContext) < 8 ||
    maxTextureSize < 8192 ||
    getMaxPrecision('highp') !== 'highp' ||
    deviceMemory <= 2 ||
    (maxTouchPoints > 0 && !matchMedia('(any-pointer: fine)').matches)
  );
}
