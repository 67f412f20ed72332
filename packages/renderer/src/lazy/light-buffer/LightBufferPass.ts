import { DepthTexture, FloatType, HalfFloatType, NearestFilter } from 'three';
import type { Frame } from '../../frame/Frame';
import { WebGLMultipleRenderTargets } from '../../three/WebGLMultipleRenderTargets';
import { lightBufferCountTwin } from './lightBufferCountTwin';
import { setThinGBufferUniforms, thinGBufferUniforms } from './lightBufferUniforms';
import { LightVolumeDraws } from '../../lighting/volumes/LightVolumeDraws';
import type { Pass } from '../../frame/Pass';
import type { ThinGBufferPass } from './ThinGBufferPass';

/** Three texels of four half floats hold the four sums of lightSums.glsl. */
const ATTACHMENTS = 3;
const BYTES = ATTACHMENTS * 8 + 4;

/**
 * Adds up the light that reaches each texel of the thin G-buffer, each light over the texels of its volume, diffuse and
 * specular apart, and both apart by Fresnel's term, so that the materials' own colours can be put in afterwards.
 * @see Engel 2009, The Light Pre-Pass Renderer; thesis 2.2.3.3.2
 */
export class LightBufferPass implements Pass {
  readonly name = 'light buffer';
  readonly reads = ['thin-gbuffer', 'scene-depth'] as const;
  readonly writes = ['light-buffer'] as const;
  /** The sums, and a copy of the thin G-buffer's depth, since that is read meanwhile. */
  target: WebGLMultipleRenderTargets | null = null;
  private readonly uniforms = thinGBufferUniforms();
  private readonly volumes = new LightVolumeDraws('Farol light buffer', 'volumeLightBuffer', this.uniforms);

  constructor(private readonly source: ThinGBufferPass) {}

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * BYTES : 0;
  }

  render(frame: Frame): void {
    this.prepareTarget(frame);
    setThinGBufferUniforms(this.uniforms, this.source, frame);
    this.volumes.draw(frame);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
    this.volumes.dispose();
  }

  private prepareTarget(frame: Frame): void {
    const { width, height } = this.source.target!;
    this.target ??= new WebGLMultipleRenderTargets(1, 1, ATTACHMENTS, {
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, FloatType),
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(ATTACHMENTS, frame.view === 'overdraw'); // else its depth is the copy
    if (frame.view === 'overdraw') this.countSurfaces(frame);
    frame.copyDepth(this.source.target!, this.target);
  }

  /** The draws of the surfaces themselves count too. */
  private countSurfaces(frame: Frame): void {
    for (const item of this.source.items) frame.drawTwin(item, lightBufferCountTwin);
    for (const item of frame.queue.transparent)
      if (this.source.isStippled(item)) frame.drawTwin(item, lightBufferCountTwin);
  }
}
