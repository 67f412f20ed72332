import { DepthTexture, FloatType, NearestFilter, Vector2, WebGLRenderTarget, type IUniform, type Texture } from 'three';
import type { Frame } from '../Frame';
import { depthBehindTwin, depthTwin, hasDepthTwin } from '../materials/depthTwin';
import { FullscreenMesh } from './FullscreenMesh';
import type { Pass } from './Pass';
import { OutputMaterial } from './PassMaterial';
import { setDepthMode } from './unprojectUniforms';

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
  private readonly depth: IUniform<Texture | null> = { value: null };
  private readonly depthMode = { value: new Vector2() };
  private readonly offset = { value: new Vector2() };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * 8 : 0;
  }

  render(frame: Frame): void {
    const { width, height } = frame;
    this.target ??= new WebGLRenderTarget(1, 1, {
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, FloatType),
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(1, true);
    for (const item of frame.queue.opaque) {
      if (item.splits && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
    }
    if (frame.samples === 0) this.show(frame);
    else this.drawSamples(frame);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.material?.dispose();
    this.target = this.material = null;
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
