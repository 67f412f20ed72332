import {
  type DepthTexture,
  type Material,
  NearestFilter,
  RedFormat,
  type Texture,
  UnsignedByteType,
  WebGLRenderTarget,
} from 'three';
import type { Frame } from '../../frame/Frame';
import { fitTargetTo } from '../../gpu/fitTarget';
import type { ReactiveMask } from '../../frame/ReactiveMask';
import type { RenderItem } from '../../frame/RenderItem';
import { targetBytes } from '../../gpu/targetBytes';

/** Reactive masks (pixels whose history TAA ignores) of this frame and the last, for one camera and scene. */
export class ReactiveMasks implements ReactiveMask<Frame> {
  private targets: [WebGLRenderTarget | null, WebGLRenderTarget | null] = [null, null];
  private picture: WebGLRenderTarget | null = null;
  private isDrawn = false;
  private wasDrawn = false;

  get bytes(): number {
    let bytes = 0;
    for (const target of this.targets) if (target !== null) bytes += targetBytes(target, false);
    return bytes;
  }

  /** Mask of this frame; null when nothing in the frame is reactive. */
  get now(): Texture | null {
    return this.isDrawn ? this.targets[0]!.texture : null;
  }

  /** Mask of the last frame; null when nothing in that frame was reactive. */
  get previous(): Texture | null {
    return this.wasDrawn ? (this.targets[1]?.texture ?? null) : null;
  }

  /** @param picture - picture whose depth hides reactive draws behind it */
  begin(picture: WebGLRenderTarget): void {
    this.picture = picture;
    this.isDrawn = false;
  }

  draw(frame: Frame, item: RenderItem, material: Material): void {
    if (!this.isDrawn) this.bind(frame);
    this.isDrawn = true;
    frame.drawItem(item, material);
  }

  /** Ends the frame: its mask becomes `previous`. */
  advance(): void {
    this.wasDrawn = this.isDrawn;
    this.isDrawn = false;
    this.targets.reverse();
  }

  reset(): void {
    this.isDrawn = this.wasDrawn = false;
  }

  dispose(): void {
    for (const target of this.targets) free(target);
    this.targets = [null, null];
    this.reset();
  }

  private bind(frame: Frame): void {
    const { width, height, depthTexture, stencilBuffer } = this.picture!;
    let [target] = this.targets;
    if (target !== null && target.depthTexture !== depthTexture) target = free(target);
    target ??= new WebGLRenderTarget(width, height, {
      format: RedFormat,
      type: UnsignedByteType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      stencilBuffer,
      depthTexture: depthTexture as DepthTexture,
    });
    this.targets[0] = target;
    fitTargetTo(target, this.picture!);
    frame.bind(target);
    frame.clear(1, false);
  }
}

/** Frees a mask's target, but not its depth texture, which belongs to the picture. */
function free(target: WebGLRenderTarget | null): null {
  if (target === null) return null;
  target.depthTexture = null;
  target.dispose();
  return null;
}
