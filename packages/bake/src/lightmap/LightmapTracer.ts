import {
  CustomBlending,
  FloatType,
  HalfFloatType,
  OneFactor,
  type Texture,
  type WebGLArrayRenderTarget,
  type WebGLRenderer,
} from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';
import type { Slices } from '../gpu/Slices';
import { keepState } from '../gpu/keepState';
import { measurePhase } from '../measurePhase';
import type { LightTable } from '../trace/lightTable';
import type { BakedProbes } from '../probes/BakedProbes';
import { traceProbes } from '../probes/traceProbes';
import type { SkySource } from '../trace/SkySource';
import type { TracedScene } from '../trace/TracedScene';
import agree from './agree.glsl?raw';
import coarsen from './coarsen.glsl?raw';
import copy from './copy.glsl?raw';
import denoise from './denoise.glsl?raw';
import dilate from './dilate.glsl?raw';
import { type Grid, gridTargets } from './grid';
import move from './move.glsl?raw';
import preview from './preview.glsl?raw';
import resolve from './resolve.glsl?raw';
import settle from './settle.glsl?raw';
import { directStages, type Gather, gathersOf, type Stage, type StageSource } from './stages';
import type { Surfaces } from './Surfaces';
import { layersTarget, maskTarget, pictureTarget, texelTarget } from './targets';
import upsample from './upsample.glsl?raw';

export interface LightmapTracerOptions {
  readonly size: number;
  /** One a lightmap: texels along a metre. */
  readonly texelsPerMetre: readonly number[];
  readonly samples: number;
  /** Texels at which light that was reflected twice or more is gathered, along a side, by all: 1, 0.5 or 0.25. */
  readonly indirectScale: number;
  readonly bounces: number;
  readonly padding: number;
  readonly denoise: boolean;
  readonly seed: number;
  readonly hasProbes: boolean;
  /** Told the share of all work and the samples of the stage that runs. */
  onSlice(share: number, samples: number): void;
}

/** What it costs to settle a texel, in samples: eight rays or more, and four short ones. */
const SETTLE_COST = 10;
/** Steps of the filter. */
const FILTERS = 4;
/** Milliseconds between two pictures of what is there so far. */
const PREVIEW_MILLISECONDS = 250;

const additive = { transparent: true, blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor } as const;

/**
 * Light of lightmaps: what lights give directly, then what is gathered. The first gather sees the sky, what shines by
 * itself, and what surfaces reflect of the lights; each one after it what surfaces reflect of the light that the one before
 * has found. That is smooth, and is gathered at the texels of a coarser grid.
 *
 * One set of targets serves all lightmaps in turn; each keeps its sums, its picture, where its texels were moved to and two
 * layers of radiance.
 */
export class LightmapTracer {
  /** What materials may show while it runs. */
  readonly pictures: readonly Texture[];
  private readonly pictureTargets;
  private readonly totals;
  /** Light of the coarser grid so far, with its variance. */
  private readonly indirect;
  private readonly moves;
  private readonly agreements;
  private readonly fine: Grid;
  /** The fine one itself, where all is gathered there. */
  private readonly coarse: Grid;
  private readonly albedo;
  private readonly emission;
  private radiance;
  private nextRadiance;
  /** Radiance of all that is reflected once less than may be, for probes. */
  private readonly reflected;
  private readonly passes: Record<string, FullscreenPass> = {};
  private readonly shared: Record<string, { value: unknown }>;
  private readonly block: number;
  /** Lightmap whose texels are in the targets. */
  private prepared = -1;
  private lastPreview = -Infinity;
  private done = 0;
  private whole = 1;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly surfaces: Surfaces,
    private readonly scene: TracedScene,
    private readonly options: LightmapTracerOptions,
  ) {
    const { size, texelsPerMetre, indirectScale } = options;
    const layers = texelsPerMetre.length;
    this.block = Math.round(1 / indirectScale);
    this.pictureTargets = texelsPerMetre.map(() => pictureTarget(size));
    this.pictures = this.pictureTargets.map(({ texture }) => texture);
    this.totals = texelsPerMetre.map(() => texelTarget(size, FloatType));
    this.moves = texelsPerMetre.map(() => texelTarget(size, HalfFloatType));
    this.agreements = maskTarget(size);
    this.fine = { ...gridTargets(size), settled: texelTarget(size, FloatType) };
    this.coarse = this.block === 1 ? this.fine : { ...gridTargets(size / this.block), settled: null };
    this.indirect = this.block === 1 ? [] : texelsPerMetre.map(() => texelTarget(size / this.block, FloatType));
    this.albedo = texelTarget(size, HalfFloatType);
    this.emission = layersTarget(scene.shines ? size : 1, layers);
    this.radiance = layersTarget(size, layers);
    this.nextRadiance = layersTarget(size, layers);
    this.reflected = options.hasProbes ? layersTarget(size, layers) : null;
    this.shared = {
      ...scene.uniforms,
      farol_seed: { value: options.seed >>> 0 },
      farol_stride: { value: 1 },
      farol_places: { value: this.fine.places.textures[0] },
      farol_settled: { value: this.fine.settled!.texture },
      farol_placeNormals: { value: this.fine.places.textures[1] },
      farol_placeFaces: { value: this.fine.places.textures[2] },
      farol_moves: { value: null },
      farol_block: { value: this.block },
      farol_positions: { value: null },
      farol_texelNormals: { value: null },
      farol_faces: { value: null },
      farol_texelSize: { value: 1 },
      farol_firstSample: { value: 0 },
      farol_sums: { value: null },
      farol_sourceSums: { value: null },
      farol_light: { value: null },
      farol_albedo: { value: this.albedo.texture },
      farol_agreements: { value: this.agreements.texture },
      farol_agreedSamples: { value: 0 },
      farol_samples: { value: 1 },
      farol_scale: { value: 1 },
      farol_step: { value: 1 },
      farol_emission: { value: this.emission.texture },
      farol_radiance: { value: null },
    };
    keepState(renderer, () => this.clearTotals());
  }

  /**
   * @param tables lights whose light is baked, and lights of which reflections alone are
   * @param skies the same of ambient and hemisphere lights
   */
  async run(
    tables: readonly [LightTable, LightTable],
    skies: readonly [SkySource, SkySource],
    slices: Slices,
  ): Promise<void> {
    const { bounces } = this.options;
    const layers = this.totals.length;
    const source = this.stageSource();
    const direct = directStages(source, tables);
    const gathers = gathersOf(source, skies);
    const all = [...direct, ...gathers.flatMap(({ stages }) => stages)];
    this.whole = layers * (SETTLE_COST + all.reduce((sum, stage) => sum + stage.cost, 0));
    if (this.scene.shines) {
      keepState(this.renderer, () => this.totals.forEach((_, i) => this.surfaces.drawEmission(i, this.emission)));
    }
    for (let lightmap = 0; lightmap < layers; lightmap++) {
      await this.settle(lightmap, slices);
      keepState(this.renderer, () => this.clear(this.nextRadiance, lightmap));
      for (const stage of direct) {
        await this.runStage(stage, lightmap, slices);
        await this.timed(slices, () => this.finishDirect(lightmap, stage, bounces > 0));
      }
    }
    for (const { stages, isReflected, probes } of gathers) {
      [this.radiance, this.nextRadiance] = [this.nextRadiance, this.radiance];
      this.shared.farol_radiance.value = this.radiance.texture;
      for (let lightmap = 0; lightmap < layers; lightmap++) {
        keepState(this.renderer, () => this.clear(this.nextRadiance, lightmap));
        for (const stage of stages) {
          await this.runStage(stage, lightmap, slices);
          await this.timed(slices, () => this.finishGather(lightmap, stage, isReflected, probes));
        }
      }
    }
    for (let lightmap = 0; lightmap < layers; lightmap++) {
      await this.timed(slices, () => {
        this.use(lightmap);
        if (gathers.length > 1 && this.indirect.length > 0) this.addIndirect(lightmap);
        this.finish(lightmap);
      });
    }
  }

  /** Light that arrives at points, once it has run with `hasProbes`. */
  readProbes(points: Float32Array, table: LightTable, sky: SkySource, slices: Slices): Promise<BakedProbes> {
    this.shared.farol_seed.value = (this.options.seed + 0x51ed270b) >>> 0;
    return traceProbes(this.renderer, slices, {
      ...{ points, table, sky, samples: this.options.samples },
      uniforms: { ...this.shared, farol_reflected: { value: this.reflected!.texture } },
      defines: this.scene.defines,
      onSlice: (_, samples) => this.options.onSlice(1, samples),
    });
  }

  /** Light of a lightmap as floats, four a texel, once it has run. */
  async read(lightmap: number): Promise<Float32Array> {
    const { size } = this.options;
    const target = this.totals[lightmap];
    const data = new Float32Array(4 * size * size);
    await this.renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, data);
    return data;
  }

  dispose(): void {
    const { fine, coarse, totals, indirect, moves, pictureTargets } = this;
    for (const grid of new Set([fine, coarse])) {
      for (const target of [grid.places, grid.sums, ...grid.light]) target.dispose();
      grid.settled?.dispose();
    }
    const single = [this.agreements, this.albedo, this.emission, this.radiance, this.nextRadiance];
    for (const target of [...single, ...totals, ...indirect, ...moves, ...pictureTargets]) target.dispose();
    this.reflected?.dispose();
    Object.values(this.passes).forEach((pass) => pass.dispose());
  }

  private stageSource(): StageSource {
    const { fine, coarse, options, scene } = this;
    const { samples, bounces } = options;
    return { samples, bounces, fine, coarse, shines: scene.shines, tracePass: (...given) => this.tracePass(...given) };
  }

  private tracePass(
    name: string,
    fragment: string,
    uniforms: Record<string, { value: unknown }>,
    defines: Record<string, unknown>,
  ): FullscreenPass {
    const all = { ...this.shared, ...uniforms };
    return (this.passes[name] ??= new FullscreenPass(name, fragment, all, {
      ...additive,
      defines: { ...this.scene.defines, ...defines },
    }));
  }

  private pass(name: string, fragment: string, defines: Record<string, unknown> = {}, more = {}): FullscreenPass {
    return (this.passes[name] ??= new FullscreenPass(name, fragment, this.shared, { defines, ...more }));
  }

  private async runStage(stage: Stage, lightmap: number, slices: Slices): Promise<void> {
    const { seed } = this.options;
    const { samples, perDraw, grid, firstSamples } = stage;
    const begin = performance.now();
    keepState(this.renderer, () => {
      this.use(lightmap);
      grid.sums.scissorTest = false;
      this.renderer.setRenderTarget(grid.sums);
      this.renderer.clear();
    });
    this.useGrid(grid, lightmap);
    this.shared.farol_agreedSamples.value = 0;
    // stages use other random numbers
    this.shared.farol_seed.value = (seed + 0x9e3779b9 * (1 + stage.stream + 32 * lightmap)) >>> 0;
    this.shared.farol_stride.value = 2 ** Math.ceil(Math.log2(samples));
    const before = this.done;
    const batches = samples / perDraw;
    const first = firstSamples / perDraw;
    const draw = async (from: number, count: number): Promise<void> => {
      await slices.run({
        height: grid.size,
        batches: count,
        draw: (batch, rows) => {
          this.shared.farol_firstSample.value = (from + batch) * perDraw;
          stage.pass.draw(this.renderer, grid.sums, 0, rows);
        },
        onSlice: (share, batch) => {
          this.done = before + (stage.cost * (from + share * count)) / batches;
          this.tellSlice(stage, lightmap, (from + batch) * perDraw);
        },
      });
    };
    if (first > 0) {
      await draw(0, first);
      this.shared.farol_samples.value = firstSamples;
      keepState(this.renderer, () => this.pass('agree', agree).draw(this.renderer, this.agreements));
      this.shared.farol_agreedSamples.value = firstSamples;
    }
    await draw(first, batches - first);
    measurePhase('trace', begin, { indirectSamples: stage.isGather ? samples * grid.size ** 2 : 0 });
  }

  /** @param samples so far */
  private tellSlice(stage: Stage, lightmap: number, samples: number): void {
    if (performance.now() - this.lastPreview > PREVIEW_MILLISECONDS && !stage.isIndirect) {
      this.lastPreview = performance.now();
      keepState(this.renderer, () => this.showSoFar(lightmap, stage, samples));
    }
    this.options.onSlice(Math.min(1, this.done / this.whole), samples);
  }

  /** Finds the points at which the texels of a lightmap are lit. */
  private async settle(lightmap: number, slices: Slices): Promise<void> {
    const begin = performance.now();
    const { places } = this.fine;
    keepState(this.renderer, () => this.drawPlaces(lightmap));
    this.shared.farol_texelSize.value = 1 / this.options.texelsPerMetre[lightmap];
    this.shared.farol_seed.value = (this.options.seed + 0x9e3779b9 * (32 * lightmap)) >>> 0;
    this.shared.farol_stride.value = 32;
    this.shared.farol_faces.value = places.textures[2];
    const pass = (this.passes.settle ??= new FullscreenPass('settle', settle, this.shared, {
      defines: this.scene.defines,
    }));
    const before = this.done;
    await slices.run({
      height: this.options.size,
      batches: 1,
      draw: (_, rows) => pass.draw(this.renderer, this.moves[lightmap], 0, rows),
      onSlice: (share) => {
        this.done = before + share * SETTLE_COST;
        this.options.onSlice(Math.min(1, this.done / this.whole), 0);
      },
    });
    keepState(this.renderer, () => this.placeTexels(lightmap));
    measurePhase('trace', begin, { indirectSamples: 0 });
  }

  /** Brings the texels of a lightmap into the targets. */
  private use(lightmap: number): void {
    if (this.prepared === lightmap) return;
    this.drawPlaces(lightmap);
    this.placeTexels(lightmap);
  }

  private drawPlaces(lightmap: number): void {
    this.prepared = -1;
    this.surfaces.drawPlaces(lightmap, this.fine.places);
    this.surfaces.drawAlbedo(lightmap, this.albedo);
  }

  private placeTexels(lightmap: number): void {
    this.shared.farol_moves.value = this.moves[lightmap].texture;
    this.pass('move', move).draw(this.renderer, this.fine.settled!);
    if (this.coarse !== this.fine) this.pass('coarsen', coarsen).draw(this.renderer, this.coarse.places);
    this.prepared = lightmap;
  }

  /** Which texels passes read. */
  private useGrid(grid: Grid, lightmap: number): void {
    const { shared } = this;
    shared.farol_positions.value = (grid.settled ?? grid.places).texture;
    shared.farol_texelNormals.value = grid.places.textures[1];
    shared.farol_faces.value = grid.places.textures[2];
    shared.farol_sums.value = grid.sums.textures[0];
    shared.farol_sourceSums.value = grid.sums.textures[1];
    shared.farol_texelSize.value = this.options.size / grid.size / this.options.texelsPerMetre[lightmap];
  }

  /** Does work after a stage, and waits until the GPU has done it. */
  private async timed(slices: Slices, work: () => void): Promise<void> {
    const begin = performance.now();
    keepState(this.renderer, work);
    await slices.wait();
    measurePhase('filter', begin);
  }

  /** Mean, denoise, fill: adds to the sum and to what the first gather sees. */
  private finishDirect(lightmap: number, stage: Stage, isReflected: boolean): void {
    const { renderer } = this;
    this.resolveFine(lightmap, stage);
    if (isReflected) {
      const pass = this.pass('reflectDirect', copy, { REFLECT: '' }, additive);
      pass.draw(renderer, this.nextRadiance, lightmap);
      if (this.reflected) pass.draw(renderer, this.reflected, lightmap);
    }
    if (!stage.isIndirect) this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.totals[lightmap]);
  }

  /** Brings the mean of a stage to the first of the fine grid's light targets. */
  private resolveFine(lightmap: number, stage: Stage): void {
    const { shared, renderer, fine } = this;
    this.useGrid(fine, lightmap);
    shared.farol_samples.value = stage.samples;
    shared.farol_scale.value = stage.scale;
    this.pass('resolve', resolve).draw(renderer, fine.light[0]);
    if (stage.isNoisy && this.options.denoise) this.denoise(fine);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
  }

  /** Adds to the sums, and to what the next gather sees: noise does no harm there. */
  private finishGather(lightmap: number, stage: Stage, isReflected: boolean, probes: Gather['probes']): void {
    const { shared, renderer, fine } = this;
    const { grid } = stage;
    if (!stage.isIndirect && grid === fine) {
      this.resolveFine(lightmap, stage);
      this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.totals[lightmap]);
    }
    this.useGrid(grid, lightmap);
    shared.farol_samples.value = stage.samples;
    shared.farol_scale.value = stage.scale;
    if (!stage.isIndirect && grid !== fine) {
      this.pass('resolve', resolve).draw(renderer, grid.light[0]);
      shared.farol_light.value = grid.light[0].texture;
      this.pass('addIndirect', copy, { ADD_VARIANCE: '' }, additive).draw(renderer, this.indirect[lightmap]);
    }
    if (!isReflected) return;
    this.pass('resolveSources', resolve, { SOURCES: '' }).draw(renderer, grid.light[0]);
    if (grid !== fine) this.upsample(lightmap, grid.light[0].texture);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    const pass = this.pass('reflect', copy, { REFLECT: '', SOURCES: '' }, additive);
    pass.draw(renderer, this.nextRadiance, lightmap);
    if (!this.reflected || probes === 'none') return;
    const alone = this.pass('reflectSources', copy, { REFLECT: '', SOURCES: '', SOURCES_ALONE: '' }, additive);
    (probes === 'all' ? pass : alone).draw(renderer, this.reflected, lightmap);
  }

  /** Takes the noise out of the coarser grid's light, and adds it to the sum. */
  private addIndirect(lightmap: number): void {
    const { shared, renderer, fine, coarse } = this;
    this.useGrid(coarse, lightmap);
    shared.farol_light.value = this.indirect[lightmap].texture;
    this.pass('limit', copy, { LIMIT: '' }).draw(renderer, coarse.light[0]);
    if (this.options.denoise) this.denoise(coarse);
    this.upsample(lightmap, coarse.light[0].texture);
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.totals[lightmap]);
  }

  private denoise(grid: Grid): void {
    for (let i = 0; i < FILTERS; i++) {
      this.shared.farol_step.value = 2 ** i;
      this.filter(grid, 'denoise', denoise);
    }
  }

  /** From the coarse grid to the first of the fine one's light targets. */
  private upsample(lightmap: number, light: Texture): void {
    this.useGrid(this.coarse, lightmap);
    this.shared.farol_light.value = light;
    this.pass('upsample', upsample).draw(this.renderer, this.fine.light[0]);
    this.useGrid(this.fine, lightmap);
  }

  /** From the first of two light targets to the second, which is the first from then on. */
  private filter(grid: Grid, name: string, fragment: string): void {
    const [a, b] = grid.light;
    this.shared.farol_light.value = a.texture;
    this.pass(name, fragment).draw(this.renderer, b);
    grid.light.reverse();
  }

  /** @param samples of the stage so far */
  private showSoFar(lightmap: number, stage: Stage, samples: number): void {
    const { shared, renderer, fine, coarse } = this;
    shared.farol_samples.value = Math.max(1, samples);
    shared.farol_scale.value = stage.scale;
    shared.farol_light.value = this.totals[lightmap].texture;
    if (stage.grid !== fine) {
      shared.farol_light.value = this.indirect[lightmap].texture;
      this.pass('preview', preview).draw(renderer, coarse.light[0]);
      this.upsample(lightmap, coarse.light[0].texture);
      shared.farol_light.value = this.totals[lightmap].texture;
      shared.farol_sums.value = fine.light[0].texture;
      shared.farol_samples.value = shared.farol_scale.value = 1;
    }
    this.pass('preview', preview).draw(renderer, fine.light[1]);
    fine.light.reverse();
    for (let i = 0; i < 2; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.pictureTargets[lightmap]);
    this.useGrid(stage.grid, lightmap);
  }

  /** Fills what is between charts, and shows the whole. */
  private finish(lightmap: number): void {
    const { shared, renderer, fine } = this;
    shared.farol_light.value = this.totals[lightmap].texture;
    this.pass('rest', copy, { REST: '' }).draw(renderer, fine.light[0]);
    for (let i = 0; i <= this.options.padding; i++) this.filter(fine, 'dilate', dilate);
    shared.farol_light.value = fine.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.pictureTargets[lightmap]);
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.totals[lightmap]);
  }

  private clearTotals(): void {
    for (const target of [...this.totals, ...this.indirect, ...this.pictureTargets]) {
      this.renderer.setRenderTarget(target);
      this.renderer.clear();
    }
    for (let lightmap = 0; this.reflected && lightmap < this.totals.length; lightmap++) {
      this.clear(this.reflected, lightmap);
    }
  }

  private clear(target: WebGLArrayRenderTarget, lightmap: number): void {
    target.scissorTest = false;
    this.renderer.setRenderTarget(target, lightmap);
    this.renderer.clear();
  }
}
