import { HalfFloatType } from 'three';
import type { Frame } from '../../frame/Frame';
import { hasAreaLights } from './hasAreaLights';
import { PassTarget } from '../../gpu/PassTarget';
import { lightBufferCountTwin } from './lightBufferCountTwin';
import { lightBufferTwins } from './lightBufferTwins';
import type { LightBuffer } from '../../frame/LightBuffer';
import { lightBufferUniforms, thinGBufferUniforms } from './lightBufferUniforms';
import { setLightBufferUniforms, setThinGBufferUniforms } from './setLightBufferUniforms';
import { LightVolumeDraws } from '../light-volumes/LightVolumeDraws';
import type { Pass } from '../../frame/Pass';
import type { ThinGBuffer } from '../../frame/ThinGBuffer';

/** Number of colour attachments (four half floats a texel) for the sums of lightSums.glsl: without and with area lights. */
const ATTACHMENTS = 3;
const WITH_AREAS = 4;

/**
 * Adds up the light that reaches each texel of the thin G-buffer, each light over the texels of its volume, as separate sums:
 * diffuse and specular, with and without Fresnel's term. Materials multiply them by their own colours later.
 * @see Engel 2009, The Light Pre-Pass Renderer; thesis 2.2.3.3.2
 */
export class LightBufferPass implements Pass, LightBuffer {
  readonly name = 'light buffer';
  readonly reads = ['thin-gbuffer', 'scene-depth'] as const;
  readonly writes = ['light-buffer'] as const;
  readonly uniforms = lightBufferUniforms();
  readonly twins = lightBufferTwins(this.uniforms);
  /** Target of the sums, with a copy of the thin G-buffer's depth, since shaders read the original. */
  private target = sumsTarget(ATTACHMENTS);
  private attachments = ATTACHMENTS;
  private readonly surfaces = thinGBufferUniforms();
  private readonly volumes = new LightVolumeDraws('light buffer ', 'volumeLightBuffer', this.surfaces);

  get bytes(): number {
    return this.target.bytes;
  }

  render(frame: Frame): void {
    const source = frame.resources.get('thin-gbuffer');
    const attachments = hasAreaLights(frame) ? WITH_AREAS : ATTACHMENTS;
    if (attachments !== this.attachments) {
      this.target.dispose();
      this.target = sumsTarget(attachments);
      this.attachments = attachments;
    }
    const target = this.target.of(source.target.viewport.z, source.target.viewport.w);
    frame.bind(target);
    frame.clear(attachments, frame.view === 'overdraw'); // no depth is cleared where the thin G-buffer's is copied in
    if (frame.view === 'overdraw') countSurfaces(frame, source);
    frame.copyDepth(source.target, target);
    setThinGBufferUniforms(this.surfaces, source, frame);
    this.volumes.draw(frame);
    setLightBufferUniforms(this.uniforms, source, target.textures, frame);
    frame.resources.put('light-buffer', this);
  }

  dispose(): void {
    this.target.dispose();
    this.volumes.dispose();
  }
}

function sumsTarget(count: number): PassTarget {
  return new PassTarget({ count, type: HalfFloatType, depthTexture: true });
}

/** Adds one for each draw of a surface to the counts of the view 'overdraw'. */
function countSurfaces(frame: Frame, source: ThinGBuffer): void {
  for (const item of source.items) frame.drawTwin(item, lightBufferCountTwin);
  for (const item of frame.queue.transparent) if (source.isStippled(item)) frame.drawTwin(item, lightBufferCountTwin);
}
