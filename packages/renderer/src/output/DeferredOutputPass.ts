import { AlwaysDepth, LessEqualDepth, type IUniform, type Texture } from 'three';
import { isCountView } from '../frame/views';
import type { Frame } from '../frame/Frame';
import { FullscreenMesh } from '../gpu/FullscreenMesh';
import type { GBufferPass } from '../gbuffer/GBufferPass';
import { gbufferUniforms, setGBufferUniforms } from '../gbuffer/gbufferUniforms';
import type { LightVolumesPass } from '../lighting/volumes/LightVolumesPass';
import { fogUniforms, OUTPUT_COUNTS, OUTPUT_FINAL, OUTPUT_LIGHTING } from './outputUniforms';
import type { Pass } from '../frame/Pass';
import { OutputMaterial } from '../gpu/PassMaterial';

/**
 * Joins accumulation and lighting and writes them to the host's target, with depth, as three would have drawn them there:
 * what is drawn after it, by Farol or by the host, finds what stock three would leave.
 */
export class DeferredOutputPass implements Pass {
  readonly name = 'output';
  readonly reads = ['gbuffer', 'lighting'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly uniforms = gbufferUniforms();
  private readonly view = { value: OUTPUT_FINAL };
  private readonly lighting: IUniform<Texture | null> = { value: null };
  private readonly overdraw: IUniform<Texture | null> = { value: null };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  constructor(
    private readonly gbuffer: GBufferPass,
    private readonly lights: LightVolumesPass,
  ) {}

  render(frame: Frame): void {
    const { view } = frame;
    setGBufferUniforms(this.uniforms, this.gbuffer.gbuffer!, frame);
    this.view.value = isCountView(view) ? OUTPUT_COUNTS : view === 'lighting' ? OUTPUT_LIGHTING : OUTPUT_FINAL;
    this.lighting.value = this.lights.target!.texture;
    this.overdraw.value = frame.overdraw;
    this.material ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol deferred output',
      vertex: ['fullscreen'],
      fragment: ['deferredOutput'],
      uniforms: {
        ...frame.uniforms,
        ...this.uniforms,
        ...fogUniforms(),
        farol_view: this.view,
        farol_lightingMap: this.lighting,
        farol_overdrawMap: this.overdraw,
      },
      fog: true,
      toneMapped: true,
      depthTest: true,
      depthWrite: true,
    });
    const samples = frame.wantsSampleDepths;
    const covers = samples || isCountView(view) || frame.fills === 'every-pixel';
    this.material.depthFunc = covers ? AlwaysDepth : LessEqualDepth;
    this.material.depthWrite = !samples;
    frame.bindTarget();
    frame.drawMesh(this.triangle, this.material);
    if (samples) frame.drawSampleDepths();
  }

  dispose(): void {
    this.material?.dispose();
    this.material = null;
  }
}
