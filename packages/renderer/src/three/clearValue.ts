import {
  Color,
  ColorManagement,
  type Object3D,
  type Scene,
  type Vector4,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';

const colour = new Color();
const encoded = { r: 0, g: 0, b: 0 };

/**
 * Computes the colour that three clears the current target to for a scene, without reading GL state, which would wait.
 * @param premultiplied - whether the context's colours are multiplied by alpha
 * @param value - receives red, green, blue and alpha, in the encoding of the target
 * @see three.js r187, WebGLBackground and getUnlitUniformColorSpace
 */
export function clearValue(webgl: WebGLRenderer, source: Object3D, premultiplied: boolean, value: Vector4): void {
  const { background = null } = source as Partial<Scene>;
  const isColor = background !== null && 'isColor' in background;
  if (isColor) colour.copy(background as Color);
  else webgl.getClearColor(colour);
  const alpha = isColor ? 1 : webgl.getClearAlpha();
  const target = webgl.getRenderTarget() as (WebGLRenderTarget & { isXRRenderTarget?: boolean }) | null;
  // targets marked by setDrawnAsCanvas are drawn like the canvas
  const space =
    target === null
      ? webgl.outputColorSpace
      : target.isXRRenderTarget === true
        ? target.texture.colorSpace
        : ColorManagement.workingColorSpace;
  const { r, g, b } = colour.getRGB(encoded, space);
  const scale = premultiplied ? alpha : 1;
  value.set(r * scale, g * scale, b * scale, alpha);
}
