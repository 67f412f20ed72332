import { CustomBlending, OneFactor, type Texture, type WebGLRenderer } from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';
import copy from './copy.glsl?raw';
import denoise from './denoise.glsl?raw';
import dilate from './dilate.glsl?raw';
import type { Grid } from './grid';
import type { LightmapTargets } from './LightmapTargets';
import preview from './preview.glsl?raw';
import resolve from './resolve.glsl?raw';
import type { Gather, Stage } from './stages';
import upsample from './upsample.glsl?raw';

/** Number of passes of the denoising filter. */
const FILTERS = 4;

const additive = { transparent: true, blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor } as const;

export interface LightmapFiltersOptions {
  readonly size: number;
  /** Texels per metre, one number per lightmap. */
  readonly texelsPerMetre: readonly number[];
  readonly padding: number;
  readonly denoise: boolean;
}

/** Turns the sample sums of a stage into denoised means, which are shown, and which the next stage reflects. */
export class LightmapFilters {
  private readonly passes: Record<string, FullscreenPass> = {};

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly targets: LightmapTargets,
    /** @param shared - uniforms of all passes */
    private readonly shared: Record<string, { value: unknown }>,
    private readonly options: LightmapFiltersOptions,
  ) {}

  /** Sets the grid of texels whose positions and normals all passes read. */
  useGrid(grid: Grid, lightmap: number): void {
    const { shared } = this;
    shared.farol_positions.value = (grid.settled ?? grid.places).texture;
    shared.farol_texelNormals.value = grid.places.textures[1];
    shared.farol_faces.value = grid.places.textures[2];
    shared.farol_sums.value = grid.sums.textures[0];
    shared.farol_sourceSums.value = grid.sums.textures[1];
    shared.farol_texelSize.value = this.options.size / grid.size / this.options.texelsPerMetre[lightmap];
  }

  /**
   * Ends a stage of direct light: averages and denoises its samples, fills texels without light from their neighbours,
   * then adds the result to the lightmap, and to the radiance that the first gather reads.
   */
  finishDirect(lightmap: number, stage: Stage, isReflected: boolean): void {
    const { renderer } = this;
    this.resolveFine(lightmap, stage);
    if (isReflected) {
      const pass = this.pass('reflectDirect', copy, { REFLECT: '' }, additive);
      pass.draw(renderer, this.targets.nextRadiance, lightmap);
      if (this.targets.reflected) pass.draw(renderer, this.targets.reflected, lightmap);
    }
    if (!stage.isIndirect) this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.targets.totals[lightmap]);
  }

  /** Writes the mean of a stage's samples to the first of the fine grid's light targets. */
  private resolveFine(lightmap: number, stage: Stage): void {
    const { shared, renderer } = this;
    const { fine } = this.targets;
    this.useGrid(fine, lightmap);
    shared.farol_samples.value = stage.samples;
    shared.farol_scale.value = stage.scale;
    this.pass('resolve', resolve).draw(renderer, fine.light[0]);
    if (stage.isNoisy && this.options.denoise) this.denoise(fine);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
  }

  /**
   * Ends a gather: adds its light to the lightmap, and, without denoising, to the radiance that the next gather reads.
   */
  finishGather(lightmap: number, stage: Stage, isReflected: boolean, probes: Gather['probes']): void {
    const { shared, renderer } = this;
    const { fine } = this.targets;
    const { grid } = stage;
    if (!stage.isIndirect && grid === fine) {
      this.resolveFine(lightmap, stage);
      this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.targets.totals[lightmap]);
    }
    this.useGrid(grid, lightmap);
    shared.farol_samples.value = stage.samples;
    shared.farol_scale.value = stage.scale;
    if (!stage.isIndirect && grid !== fine) {
      this.pass('resolve', resolve).draw(renderer, grid.light[0]);
      shared.farol_light.value = grid.light[0].texture;
      this.pass('addIndirect', copy, { ADD_VARIANCE: '' }, additive).draw(renderer, this.targets.indirect[lightmap]);
    }
    if (!isReflected) return;
    this.pass('resolveSources', resolve, { SOURCES: '' }).draw(renderer, grid.light[0]);
    if (grid !== fine) this.upsample(lightmap, grid.light[0].texture);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    const pass = this.pass('reflect', copy, { REFLECT: '', SOURCES: '' }, additive);
    pass.draw(renderer, this.targets.nextRadiance, lightmap);
    if (!this.targets.reflected || probes === 'none') return;
    const alone = this.pass('reflectSources', copy, { REFLECT: '', SOURCES: '', SOURCES_ALONE: '' }, additive);
    (probes === 'all' ? pass : alone).draw(renderer, this.targets.reflected, lightmap);
  }

  /** Denoises the coarse grid's light, and adds it to the lightmap. */
  addIndirect(lightmap: number): void {
    const { shared, renderer } = this;
    const { fine, coarse } = this.targets;
    this.useGrid(coarse, lightmap);
    shared.farol_light.value = this.targets.indirect[lightmap].texture;
    this.pass('limit', copy, { LIMIT: '' }).draw(renderer, coarse.light[0]);
    if (this.options.denoise) this.denoise(coarse);
    this.upsample(lightmap, coarse.light[0].texture);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.targets.totals[lightmap]);
  }

  private denoise(grid: Grid): void {
    for (let i = 0; i < FILTERS; i++) {
      this.shared.farol_step.value = 2 ** i;
      this.filter(grid, 'denoise', denoise);
    }
  }

  /** Upsamples light from the coarse grid to the fine grid's first light target. */
  private upsample(lightmap: number, light: Texture): void {
    this.useGrid(this.targets.coarse, lightmap);
    this.shared.farol_light.value = light;
    this.pass('upsample', upsample).draw(this.renderer, this.targets.fine.light[0]);
    this.useGrid(this.targets.fine, lightmap);
  }

  /** Filters the grid's first light target into the second, and swaps the two. */
  private filter(grid: Grid, name: string, fragment: string): void {
    const [a, b] = grid.light;
    this.shared.farol_light.value = a.texture;
    this.pass(name, fragment).draw(this.renderer, b);
    grid.light.reverse();
  }

  /**
   * Shows the lightmap with the samples so far.
   * @param samples - number of samples of the stage so far
   */
  showSoFar(lightmap: number, stage: Stage, samples: number): void {
    const { shared, renderer } = this;
    const { fine, coarse } = this.targets;
    shared.farol_samples.value = Math.max(1, samples);
    shared.farol_scale.value = stage.scale;
    shared.farol_light.value = this.targets.totals[lightmap].texture;
    if (stage.grid !== fine) {
      shared.farol_light.value = this.targets.indirect[lightmap].texture;
      this.pass('preview', preview).draw(renderer, coarse.light[0]);
      this.upsample(lightmap, coarse.light[0].texture);
      shared.farol_light.value = this.targets.totals[lightmap].texture;
      shared.farol_sums.value = fine.light[0].texture;
      shared.farol_samples.value = shared.farol_scale.value = 1;
    }
    this.pass('preview', preview).draw(renderer, fine.light[1]);
    fine.light.reverse();
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.targets.pictures[lightmap]);
    this.useGrid(stage.grid, lightmap);
  }

  /** Fills texels between charts, and writes the finished lightmap to its picture. */
  finish(lightmap: number): void {
    const { shared, renderer } = this;
    const { fine } = this.targets;
    shared.farol_light.value = this.targets.totals[lightmap].texture;
    this.pass('rest', copy, { REST: '' }).draw(renderer, fine.light[0]);
    for (let i = 0; i <= this.options.padding; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.targets.pictures[lightmap]);
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.targets.totals[lightmap]);
  }

  dispose(): void {
    Object.values(this.passes).forEach((pass) => pass.dispose());
  }

  private pass(name: string, fragment: string, defines: Record<string, unknown> = {}, more = {}): FullscreenPass {
    return (this.passes[name] ??= new FullscreenPass(name, fragment, this.shared, { defines, ...more }));
  }
}
