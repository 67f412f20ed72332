import { Vector2, type Texture, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { depthBehindTwin, depthTwin, hasDepthTwin } from '../../materials/depthTwin';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { PassTarget } from '../../gpu/PassTarget';
import type { Pass } from '../../frame/Pass';
import { setDepthMode } from '../../gpu/unprojectUniforms';
import { setViewport } from '../../three/state';

/**
 * Draws the depth of opaque lit items first: into a texture for the light lists, and from there into the host's target, so that
 * hidden surfaces are not shaded. For a multisampled target, whose samples have separate depths, the items are drawn again.
 * @see Harada, McKee and Yang 2012, Forward+: Bringing Deferred Lighting to the Next Level
 */
export class DepthPrepass implements Pass {
  readonly name = 'depth';
  readonly reads = [] as const;
  readonly writes = ['scene-depth', 'target'] as const;
  /** Depth of the opaque items, as a texture of the picture's size. */
  private readonly target = new PassTarget({ depthTexture: true });
  /** Intermediate target for a viewport that does not begin at the corner, so that vertices are rounded as in the host's target. */
  private readonly shifted = new PassTarget({ depthTexture: true });
  private readonly toTarget = new FullscreenPass({
    program: 'depth',
    fragment: 'depthOnly',
    uniforms: {
      farol_sceneDepth: { value: null as Texture | null },
      farol_offset: { value: new Vector2() },
      farol_depthMode: { value: new Vector2() },
    },
    asThree: true,
    colorWrite: false,
    depthTest: true,
    depthWrite: true,
  });

  get bytes(): number {
    return this.target.bytes + this.shifted.bytes;
  }

  render(frame: Frame): void {
    const { width, height, viewport } = frame;
    const target = this.target.of(width, height);
    frame.bind(target);
    const isShifted = viewport.x !== 0 || viewport.y !== 0;
    const drawn = isShifted ? this.bindShifted(frame) : target;
    frame.clear(1, true);
    for (const item of frame.queue.opaque) {
      if (item.route === 'split' && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
    }
    if (isShifted) frame.copyDepth(drawn, target, viewport.x, viewport.y);
    if (frame.samples === 0) this.show(frame, target);
    else this.drawSamples(frame);
    frame.resources.put('scene-depth', target.depthTexture!);
  }

  dispose(): void {
    for (const held of [this.target, this.shifted, this.toTarget]) held.dispose();
  }

  /** Binds a target with the host's viewport. @returns the target */
  private bindShifted(frame: Frame): WebGLRenderTarget {
    const { viewport } = frame;
    const { width = 1, height = 1 } = this.shifted.current ?? {};
    const target = this.shifted.of(
      Math.max(width, viewport.x + frame.width),
      Math.max(height, viewport.y + frame.height),
    );
    frame.bind(target);
    setViewport(frame.webgl, viewport);
    return target;
  }

  private drawSamples(frame: Frame): void {
    // logarithmic depth is written by fragment shaders, so a pre-pass saves no shading
    if (frame.webgl.capabilities.logarithmicDepthBuffer) return;
    frame.bindTarget();
    for (const item of frame.queue.opaque) {
      const { material } = item;
      if (item.route !== 'split' || !hasDepthTwin(material) || material.polygonOffset || material.alphaToCoverage)
        continue;
      frame.drawTwin(item, depthBehindTwin);
    }
  }

  private show(frame: Frame, { depthTexture }: WebGLRenderTarget): void {
    const { uniforms } = this.toTarget;
    uniforms.farol_sceneDepth.value = depthTexture;
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    setDepthMode(uniforms.farol_depthMode, frame.camera, frame.webgl);
    frame.bindTarget();
    this.toTarget.draw(frame);
  }
}
