import {
  AlwaysDepth,
  CustomBlending,
  LessEqualDepth,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector2,
  type IUniform,
  type Texture,
} from 'three';
import { isCountView } from '../frame/views';
import type { Frame } from '../frame/Frame';
import { FullscreenMesh } from '../gpu/FullscreenMesh';
import type { MultipassLightsPass } from '../lighting/MultipassLightsPass';
import { fogUniforms, OUTPUT_COUNTS, OUTPUT_FINAL, OUTPUT_LIGHTING } from './outputUniforms';
import type { Pass } from '../frame/Pass';
import { OutputMaterial } from '../gpu/PassMaterial';
import { setUnprojectUniforms, unprojectUniforms } from '../gpu/unprojectUniforms';

/** Writes the sum of multipass lighting to the host's target, with depth. */
export class AccumulatedOutputPass implements Pass {
  readonly name = 'output';
  readonly reads = ['lighting'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly view = { value: OUTPUT_FINAL };
  private readonly sum: IUniform<Texture | null> = { value: null };
  private readonly depth: IUniform<Texture | null> = { value: null };
  private readonly overdraw: IUniform<Texture | null> = { value: null };
  private readonly offset = { value: new Vector2() };
  private readonly size = { value: new Vector2() };
  private readonly unproject = unprojectUniforms();
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  constructor(private readonly source: MultipassLightsPass) {}

  render(frame: Frame): void {
    const { view } = frame;
    const target = this.source.target!;
    this.view.value = isCountView(view) ? OUTPUT_COUNTS : view === 'lighting' ? OUTPUT_LIGHTING : OUTPUT_FINAL;
    this.sum.value = target.texture;
    this.depth.value = target.depthTexture;
    this.overdraw.value = frame.overdraw;
    this.size.value.set(frame.width, frame.height);
    setUnprojectUniforms(this.unproject, frame.camera, frame.webgl);
    this.offset.value.set(frame.viewport.x, frame.viewport.y);
    this.material ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol multipass output',
      vertex: ['fullscreen'],
      fragment: ['accumulatedOutput'],
      uniforms: {
        ...frame.uniforms,
        farol_view: this.view,
        farol_accumulated: this.sum,
        farol_accumulatedDepth: this.depth,
        farol_overdrawMap: this.overdraw,
        farol_offset: this.offset,
        farol_size: this.size,
        ...this.unproject,
        ...fogUniforms(),
      },
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
      toneMapped: true,
      depthTest: true,
      depthWrite: true,
    });
    if (this.material.fog === this.source.fogged) {
      this.material.fog = !this.source.fogged;
      this.material.needsUpdate = true;
    }
    const samples = frame.wantsSampleDepths;
    const covers = samples || isCountView(view) || frame.fills === 'every-pixel';
    this.material.depthFunc = covers ? AlwaysDepth : LessEqualDepth;
    this.material.depthWrite = !samples;
    // at an edge, samples of what was there before show through
    this.material.blending = frame.samples > 0 ? CustomBlending : NoBlending;
    frame.bindTarget();
    frame.drawMesh(this.triangle, this.material);
    if (samples) frame.drawSampleDepths();
  }

  dispose(): void {
    this.material?.dispose();
    this.material = null;
  }
}
