import { AlwaysDepth, LessEqualDepth, type IUniform, type Texture } from 'three';
import { isCountView } from '../frame/views';
import type { Frame } from '../frame/Frame';
import { FullscreenMesh } from '../gpu/FullscreenMesh';
import type { GBufferPass } from '../gbuffer/GBufferPass';
import { gbufferUniforms, setGBufferUniforms } from '../gbuffer/gbufferUniforms';
import { fogUniforms, OUTPUT_COUNTS, OUTPUT_FINAL, OUTPUT_LIGHTING } from './outputUniforms';
import type { Pass } from '../frame/Pass';
import { OutputMaterial } from '../gpu/PassMaterial';
import type { LightLoop } from '../lighting/loops/LightLoop';

/** Lights the G-buffer by the light lists, every pixel once, straight into the host's target, with depth. */
export class TiledOutputPass implements Pass {
  readonly name = 'output';
  readonly reads = ['gbuffer', 'light-lists'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly uniforms = gbufferUniforms();
  private readonly view = { value: OUTPUT_FINAL };
  private readonly overdraw: IUniform<Texture | null> = { value: null };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  /**
   * @param lists uniforms of the lists
   * @param loop microshader that walks them
   * @param defines of its program
   */
  constructor(
    private readonly gbuffer: GBufferPass,
    private readonly lists: Record<string, IUniform>,
    private readonly loop: LightLoop,
    private readonly defines: Record<string, string> = {},
  ) {}

  render(frame: Frame): void {
    const { view } = frame;
    setGBufferUniforms(this.uniforms, this.gbuffer.gbuffer!, frame);
    this.view.value = isCountView(view) ? OUTPUT_COUNTS : view === 'lighting' ? OUTPUT_LIGHTING : OUTPUT_FINAL;
    this.overdraw.value = frame.overdraw;
    this.material ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol tiled output',
      vertex: ['fullscreen'],
      fragment: [this.loop, 'tiledOutput'],
      uniforms: {
        ...frame.uniforms,
        ...this.uniforms,
        ...this.lists,
        ...fogUniforms(),
        dfgLUT: { value: null },
        farol_view: this.view,
        farol_overdrawMap: this.overdraw,
      },
      defines: { ...this.defines, FAROL_ONE_TURN: '' },
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
