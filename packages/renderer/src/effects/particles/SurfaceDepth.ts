import { DepthTexture, NearestFilter, type Texture, Vector2, WebGLRenderTarget } from 'three';
import { fitTarget } from '../../gpu/fitTarget';
import { depthTwin, hasDepthTwin } from '../../materials/depthTwin';
import type { Frame } from '../../frame/Frame';
import { isPlain } from '../../frame/RenderItem';
import { PassTarget } from '../../gpu/PassTarget';
import { targetBytes } from '../../gpu/targetBytes';
import { DistancePass } from '../../passes/forward/DistancePass';

/**
 * Depth of a frame's opaque surfaces as a texture that can be read while drawing to the frame's target: from the technique's
 * resources, else a copy of the target's depth texture, else drawn again; with distances where depth does not give them.
 */
export class SurfaceDepth {
  /** Depth texture of this frame's opaque surfaces; null until `of` is called. */
  texture: Texture | null = null;
  /** Distances of the surfaces, packed by storedDistance.glsl, where depth does not give them; else null. */
  distances: Texture | null = null;
  /** Number of texels of `texture` for each pixel of the picture, along x and y. */
  readonly scale = new Vector2(1, 1);
  private copied: WebGLRenderTarget | null = null;
  private readonly drawn = new PassTarget({ depthTexture: true });
  private readonly distancePass = new DistancePass();

  get bytes(): number {
    return this.drawn.bytes + this.distancePass.bytes + (this.copied === null ? 0 : targetBytes(this.copied));
  }

  /** Begins a frame: the depth of the last one is no longer valid. */
  begin(): void {
    this.texture = this.distances = null;
    this.scale.set(1, 1);
  }

  /** Returns the depth texture, and binds the frame's target. Call when all opaque surfaces are drawn. */
  of(frame: Frame): Texture {
    if (frame.storesDistance) {
      if (this.distances === null) this.drawDistances(frame);
      return this.texture!;
    }
    if (this.texture !== null) return this.texture;
    const { target } = frame;
    const own = target?.depthTexture ?? null;
    this.texture = own !== null && frame.samples === 0 ? this.copy(frame, own) : this.draw(frame);
    frame.bindTarget();
    return this.texture;
  }

  dispose(): void {
    this.drawn.dispose();
    this.distancePass.dispose();
    this.copied?.depthTexture?.dispose();
    this.copied?.dispose();
    this.copied = this.texture = this.distances = null;
  }

  private drawDistances(frame: Frame): void {
    const { texture, depthTexture } = this.distancePass.render(frame);
    this.distances = texture;
    this.texture = depthTexture;
    this.scale.set(1, 1);
    frame.bindTarget();
  }

  private copy(frame: Frame, { type, format }: DepthTexture): Texture {
    const { width, height, viewport } = frame;
    const known = this.copied?.depthTexture;
    if (known?.type !== type || known.format !== format) {
      known?.dispose();
      this.copied?.dispose();
      const depthTexture = new DepthTexture(width, height, type);
      depthTexture.format = format;
      this.copied = new WebGLRenderTarget(width, height, {
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        depthTexture,
      });
    }
    const copied = this.copied!;
    fitTarget(copied, width, height);
    frame.bind(copied); // binding allocates the target, before depth is copied to it
    frame.copyDepth(frame.target!, copied, viewport.x, viewport.y);
    return copied.depthTexture!;
  }

  private draw(frame: Frame): Texture {
    const target = this.drawn.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(0, true);
    for (const item of frame.queue.opaque)
      if (isPlain(item) && !item.ownShader && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
    return target.depthTexture!;
  }
}
