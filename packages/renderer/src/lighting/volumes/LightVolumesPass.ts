import { DepthTexture, FloatType, HalfFloatType, NearestFilter, WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import type { GBufferPass } from '../../gbuffer/GBufferPass';
import { gbufferUniforms, setGBufferUniforms } from '../../gbuffer/gbufferUniforms';
import { LightVolumeDraws } from './LightVolumeDraws';
import type { Pass } from '../../frame/Pass';

/** Adds up the light of every pixel of the G-buffer, each light over the pixels of its volume. */
export class LightVolumesPass implements Pass {
  readonly name = 'light volumes';
  readonly reads = ['gbuffer'] as const;
  readonly writes = ['lighting'] as const;
  /** Sum of the light, and a copy of the scene's depth, since the depth texture itself is read meanwhile. */
  target: WebGLRenderTarget | null = null;
  private readonly uniforms = gbufferUniforms();
  private readonly volumes = new LightVolumeDraws('Farol', 'volumeLighting', { ...this.uniforms });

  constructor(private readonly source: GBufferPass) {}

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * 12 : 0;
  }

  render(frame: Frame): void {
    const gbuffer = this.source.gbuffer!;
    this.prepareTarget(frame, gbuffer);
    setGBufferUniforms(this.uniforms, gbuffer, frame);
    this.volumes.draw(frame);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
    this.volumes.dispose();
  }

  private prepareTarget(frame: Frame, gbuffer: GBuffer): void {
    const { width, height } = frame;
    this.target ??= new WebGLRenderTarget(1, 1, {
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(1, 1, FloatType),
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(1, false);
    frame.copyDepth(gbuffer.target, this.target);
  }
}
