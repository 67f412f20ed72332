import { DepthTexture, FloatType, NearestFilter, Vector2, WebGLRenderTarget, type IUniform, type Texture } from 'three';
import type { Frame } from '../frame/Frame';
import { depthBehindTwin, depthTwin, hasDepthTwin } from './depthTwin';
import { FullscreenMesh } from '../gpu/FullscreenMesh';
import type { Pass } from '../frame/Pass';
import { OutputMaterial } from '../gpu/PassMaterial';
import { setDepthMode } from '../gpu/unprojectUniforms';

/**
 * Draws the depth of the opaque lit items first: into a texture for the light lists, and from there into the host's target,
 * so that what is hidden is not shaded. Where that is multisampled the items are drawn into it once more: depths of pixels
 * are not those of samples.
 * @see Harada, McKee and Yang 2012, Forward+: Bringing Deferred Lighting to the Next Level
 */
export class DepthPrepass implements Pass {
  readonly name = 'depth';
  readonly reads = [] as const;
  readonly writes = ['scene-depth', 'target'] as const;
  target: WebGLRenderTarget | null = null;
  /** In its place where the viewport does not begin at the corner: elsewhere, vertices might be rounded to other places. */
  private shifted: WebGLRenderTarget | null = null;
  private readonly depth: IUniform<Texture | null> = { value: null };
  private readonly depthMode = { value: new Vector2() };
  private readonly offset = { value: new Vector2() };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  get bytes(): number {
    return bytesOf(this.target) + bytesOf(this.shifted);
  }

  render(frame: Frame): void {
    const { width, height, viewport } = frame;
    this.target ??= makeTarget();
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    const isShifted = viewport.x !== 0 || viewport.y !== 0;
    if (isShifted) this.bindShifted(frame);
    frame.clear(1, true);
    for (const item of frame.queue.opaque) {
      if (item.splits && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
    }
    if (isShifted) frame.copyDepth(this.shifted!, this.target, viewport.x, viewport.y);
    if (frame.samples === 0) this.show(frame);
    else this.drawSamples(frame);
  }

  dispose(): void {
    for (const target of [this.target, this.shifted]) {
      target?.depthTexture?.dispose();
      target?.dispose();
    }
    this.material?.dispose();
    this.target = this.shifted = this.material = null;
  }

  /** Draws where the host's target is drawn to. */
  private bindShifted(frame: Frame): void {
    const { viewport } = frame;
    const target = (this.shifted ??= makeTarget());
    const width = Math.max(target.width, viewport.x + frame.width);
    const height = Math.max(target.height, viewport.y + frame.height);
    if (target.width < width || target.height < height) target.setSize(width, height);
    frame.bind(target);
    frame.webgl.state.viewport(viewport);
  }

  private drawSamples(frame: Frame): void {
    // depth that the shader writes spares no shading
    if (frame.webgl.capabilities.logarithmicDepthBuffer) return;
    frame.bindTarget();
    for (const item of frame.queue.opaque) {
      const { material } = item;
      if (!item.splits || !hasDepthTwin(material) || material.polygonOffset || material.alphaToCoverage) continue;
      frame.drawTwin(item, depthBehindTwin);
    }
  }

  private show(frame: Frame): void {
    this.depth.value = this.target!.depthTexture;
    this.offset.value.set(frame.viewport.x, frame.viewport.y);
    setDepthMode(this.depthMode, frame.camera, frame.webgl);
    if (this.material === null) {
      this.material = new OutputMaterial(frame.microshaders, {
        name: 'Farol depth',
        vertex: ['fullscreen'],
        fragment: ['depthOnly'],
        uniforms: { farol_sceneDepth: this.depth, farol_offset: this.offset, farol_depthMode: this.depthMode },
        depthTest: true,
        depthWrite: true,
      });
      this.material.colorWrite = false;
    }
    frame.bindTarget();
    frame.drawMesh(this.triangle, this.material);
  }
}

function makeTarget(): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthTexture: new DepthTexture(1, 1, FloatType),
  });
}

function bytesOf(target: WebGLRenderTarget | null): number {
  return target === null ? 0 : target.width * target.height * 8;
}
