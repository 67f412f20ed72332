import type { WebGLRenderTarget } from 'three';

/**
 * Largest size of the picture over its size in this frame, while a frame budget varies that: targets are made for the largest,
 * and only grow. 0 where targets are as large as the picture. Set for each frame.
 */
export const targetSizes = { room: 0 };

/** Texels to make along a side for a size that is needed in this frame: as many, or as many as a larger picture would need. */
export function withRoom(made: number, needed: number): number {
  const { room } = targetSizes;
  if (room === 0) return needed;
  return made >= needed ? made : Math.ceil(needed * room);
}

/**
 * Sizes what a target is drawn to (texels): its `viewport`, from the first texel on. The textures have that size, or are larger
 * while a frame budget varies the picture's size, which then allocates nothing.
 */
export function fitTarget(target: WebGLRenderTarget, width: number, height: number): void {
  const w = withRoom(target.width, width);
  const h = withRoom(target.height, height);
  if (target.width !== w || target.height !== h) target.setSize(w, h);
  target.viewport.set(0, 0, width, height);
}

/** Sizes a target as another one is, whose depth texture it may share. */
export function fitTargetTo(target: WebGLRenderTarget, other: WebGLRenderTarget): void {
  if (target.width !== other.width || target.height !== other.height) target.setSize(other.width, other.height);
  target.viewport.copy(other.viewport);
}
