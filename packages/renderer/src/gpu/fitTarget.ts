import type { WebGLRenderTarget } from 'three';

/**
 * Largest size of the picture over its size in this frame, while a frame budget varies the size: targets are then made for the
 * largest, and only grow. 0: targets are as large as the picture. Set for each frame.
 */
export const targetSizes = { room: 0 };

/** Side (texels) of a target for the size needed in this frame: that size, or with a frame budget the largest picture's. */
export function withRoom(made: number, needed: number): number {
  const { room } = targetSizes;
  if (room === 0) return needed;
  return made >= needed ? made : Math.ceil(needed * room);
}

/**
 * Sets the used size of a target (texels), its `viewport` from the first texel on. Textures have that size, or are larger while
 * a frame budget varies the picture's size, so that nothing is reallocated.
 */
export function fitTarget(target: WebGLRenderTarget, width: number, height: number): void {
  const w = withRoom(target.width, width);
  const h = withRoom(target.height, height);
  if (target.width !== w || target.height !== h) target.setSize(w, h);
  target.viewport.set(0, 0, width, height);
}

/** Sizes a target like another one, whose depth texture it may share. */
export function fitTargetTo(target: WebGLRenderTarget, other: WebGLRenderTarget): void {
  if (target.width !== other.width || target.height !== other.height) target.setSize(other.width, other.height);
  target.viewport.copy(other.viewport);
}
