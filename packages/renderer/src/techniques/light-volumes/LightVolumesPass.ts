import { HalfFloatType } from 'three';
import type { Frame } from '../../frame/Frame';
import { gbufferUniforms, setGBufferUniforms } from '../../passes/gbuffer/gbufferUniforms';
import { PassTarget } from '../../gpu/PassTarget';
import { LightVolumeDraws } from './LightVolumeDraws';
import type { Pass } from '../../frame/Pass';

/** Adds up the light at every pixel of the G-buffer, each light over the pixels of its volume. */
export class LightVolumesPass implements Pass {
  readonly name = 'light volumes';
  readonly reads = ['gbuffer'] as const;
  readonly writes = ['lighting'] as const;
  /** Target of the sums, with a copy of the scene's depth, since shaders read the original. */
  private readonly target = new PassTarget({ type: HalfFloatType, depthTexture: true });
  private readonly uniforms = gbufferUniforms();
  private readonly volumes = new LightVolumeDraws('', 'volumeLighting', { ...this.uniforms });

  get bytes(): number {
    return this.target.bytes;
  }

  render(frame: Frame): void {
    const gbuffer = frame.resources.get('gbuffer');
    const target = this.target.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(1, false);
    frame.copyDepth(gbuffer.target, target);
    setGBufferUniforms(this.uniforms, gbuffer, frame);
    this.volumes.draw(frame);
    frame.resources.put('lighting', target.texture);
  }

  dispose(): void {
    this.target.dispose();
    this.volumes.dispose();
  }
}
