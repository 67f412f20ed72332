import { CustomBlending, FloatType, HalfFloatType, OneFactor, type Texture, type WebGLRenderer } from 'three';
import { FullscreenPass } from '../gpu/FullscreenPass';
import type { Slices } from '../gpu/Slices';
import { keepState } from '../gpu/keepState';
import { measurePhase } from '../measurePhase';
import { lightUniforms, type LightTable } from '../trace/lightTable';
import type { BakedProbes } from '../probes/BakedProbes';
import { traceProbes } from '../probes/traceProbes';
import type { SkySource } from '../trace/SkySource';
import type { TracedScene } from '../trace/TracedScene';
import copy from './copy.glsl?raw';
import denoise from './denoise.glsl?raw';
import dilate from './dilate.glsl?raw';
import direct from './direct.glsl?raw';
import gather from './gather.glsl?raw';
import preview from './preview.glsl?raw';
import resolve from './resolve.glsl?raw';
import settle from './settle.glsl?raw';
import type { Surfaces } from './Surfaces';
import { layersTarget, pictureTarget, placeTarget, texelTarget } from './targets';

export interface LightmapTracerOptions {
  readonly size: number;
  /** One a lightmap: texels along a metre. */
  readonly texelsPerMetre: readonly number[];
  readonly samples: number;
  readonly bounces: number;
  readonly padding: number;
  readonly denoise: boolean;
  readonly seed: number;
  readonly hasProbes: boolean;
  /** Told the share of all work and the samples of the stage that runs. */
  onSlice(share: number, samples: number): void;
}

/** Samples that a draw takes at each texel: always as many, so that sums are rounded alike however fast the GPU is. */
const SAMPLES_OF_A_DRAW = 4;
/** Samples of lights with soft shadows. */
const softSamples = (samples: number): number =>
  SAMPLES_OF_A_DRAW * Math.ceil(Math.min(samples, Math.max(16, samples / 4)) / 4);
/**
 * Samples of a bounce: each reflects a part of the light of the one before, so that its noise counts less.
 * @param bounce from 0
 */
const bounceSamples = (samples: number, bounce: number): number =>
  Math.min(samples, Math.max(16, Math.ceil(samples / 2 ** bounce)));
/** Milliseconds between two pictures of what is there so far. */
const PREVIEW_MILLISECONDS = 250;

const additive = { transparent: true, blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor } as const;

/**
 * Light of lightmaps: what lights give directly, then what each texel sees of the light that the bounce before has left in
 * the lightmaps. One set of targets serves all lightmaps in turn; each keeps its sum, its picture and two layers of radiance.
 */
export class LightmapTracer {
  /** What materials may show while it runs. */
  readonly pictures: readonly Texture[];
  private readonly pictureTargets;
  private readonly totals;
  private readonly places;
  private readonly settled;
  private readonly sums;
  private readonly light;
  private readonly albedo;
  private readonly emission;
  private radiance;
  private nextRadiance;
  /** Radiance of all bounces but the last, for probes. */
  private readonly reflected;
  private readonly passes: Record<string, FullscreenPass> = {};
  private readonly shared: Record<string, { value: unknown }>;
  private lastPreview = -Infinity;
  private done = 0;
  private whole = 1;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly surfaces: Surfaces,
    private readonly scene: TracedScene,
    private readonly options: LightmapTracerOptions,
  ) {
    const { size, texelsPerMetre } = options;
    const layers = texelsPerMetre.length;
    this.pictureTargets = texelsPerMetre.map(() => pictureTarget(size));
    this.pictures = this.pictureTargets.map(({ texture }) => texture);
    this.totals = texelsPerMetre.map(() => texelTarget(size, FloatType));
    this.places = placeTarget(size);
    this.settled = texelTarget(size, FloatType);
    this.sums = texelTarget(size, FloatType);
    this.light = [texelTarget(size, FloatType), texelTarget(size, FloatType)];
    this.albedo = texelTarget(size, HalfFloatType);
    this.emission = layersTarget(scene.shines ? size : 1, layers);
    this.radiance = layersTarget(size, layers);
    this.nextRadiance = layersTarget(size, layers);
    this.reflected = options.hasProbes ? layersTarget(size, layers) : null;
    this.shared = {
      ...scene.uniforms,
      farol_seed: { value: options.seed >>> 0 },
      farol_positions: { value: this.settled.texture },
      farol_texelNormals: { value: this.places.textures[1] },
      farol_faces: { value: this.places.textures[2] },
      farol_texelSize: { value: 1 },
      farol_firstSample: { value: 0 },
      farol_sums: { value: this.sums.texture },
      farol_light: { value: null },
      farol_albedo: { value: this.albedo.texture },
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
    const { samples, bounces } = this.options;
    const stages = this.makeStages(tables, skies);
    const layers = this.totals.length;
    let cost = stages.reduce((sum, stage) => sum + stage.cost, 0);
    for (let bounce = 0; bounce < bounces; bounce++) cost += bounceSamples(samples, bounce);
    this.whole = layers * cost;
    if (this.scene.shines) {
      keepState(this.renderer, () => this.totals.forEach((_, i) => this.surfaces.drawEmission(i, this.emission)));
    }
    // direct light of all kinds is what the first bounce reflects
    for (let lightmap = 0; lightmap < layers; lightmap++) {
      let isFirst = true;
      for (const stage of stages) {
        await this.runStage(stage, lightmap, slices);
        await this.finishStage(lightmap, stage, !isFirst, this.options.bounces > 0, slices);
        isFirst = false;
      }
      if (isFirst) keepState(this.renderer, () => this.clearLayer(lightmap));
    }
    for (let bounce = 0; bounce < bounces; bounce++) {
      [this.radiance, this.nextRadiance] = [this.nextRadiance, this.radiance];
      this.shared.farol_radiance.value = this.radiance.texture;
      for (let lightmap = 0; lightmap < layers; lightmap++) {
        const stage = this.gatherStage(`bounce`, bounceSamples(samples, bounce), false, {}, {}, 16 + bounce);
        await this.runStage(stage, lightmap, slices);
        await this.finishStage(lightmap, stage, false, bounce < bounces - 1, slices);
      }
    }
    const begin = performance.now();
    keepState(this.renderer, () => this.totals.forEach((_, lightmap) => this.finish(lightmap)));
    await slices.wait();
    measurePhase('filter', begin);
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
    const all = [this.places, this.settled, this.sums, this.albedo, this.emission, this.radiance, this.nextRadiance];
    for (const target of [...all, ...this.light, ...this.totals, ...this.pictureTargets]) target.dispose();
    this.reflected?.dispose();
    Object.values(this.passes).forEach((pass) => pass.dispose());
  }

  private makeStages(tables: readonly [LightTable, LightTable], skies: readonly [SkySource, SkySource]): Stage[] {
    const { samples, bounces } = this.options;
    const stages: Stage[] = [];
    tables.forEach((table, i) => {
      if (table.count === 0 || (i === 1 && bounces === 0)) return;
      stages.push(this.directStage(`direct${i}`, table, i === 1));
    });
    skies.forEach((sky, i) => {
      const shines = i === 0 && this.scene.shines;
      if ((sky.isBlack && !shines) || (i === 1 && bounces === 0)) return;
      const defines = { ...sky.defines, FROM_SOURCES: '' };
      const stage = this.gatherStage(`sources${i}`, samples, i === 1, sky.uniforms, defines, 8 + i);
      stages.push(stage);
    });
    return stages;
  }

  private directStage(name: string, table: LightTable, isIndirect: boolean): Stage {
    const samples = table.isSoft ? softSamples(this.options.samples) : 1;
    const perDraw = table.isSoft ? SAMPLES_OF_A_DRAW : 1;
    const pass = this.tracePass(name, direct, lightUniforms(table), { SAMPLES: perDraw });
    return { pass, samples, perDraw, cost: samples, scale: 1, stream: 0, isIndirect, isNoisy: table.isSoft };
  }

  private gatherStage(
    name: string,
    asked: number,
    isIndirect: boolean,
    uniforms: Record<string, { value: unknown }>,
    defines: Record<string, unknown>,
    stream: number,
  ): Stage {
    const samples = SAMPLES_OF_A_DRAW * Math.ceil(asked / SAMPLES_OF_A_DRAW);
    const noSky = { SKY_LIGHTS: 1, SAMPLES: SAMPLES_OF_A_DRAW };
    const pass = this.tracePass(name, gather, uniforms, { ...noSky, ...defines });
    const base = { perDraw: SAMPLES_OF_A_DRAW, cost: samples, scale: Math.PI, stream, isIndirect, isNoisy: true };
    return { pass, samples, ...base };
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
    const { size, seed } = this.options;
    keepState(this.renderer, () => this.prepare(lightmap));
    // bounces use other random numbers
    this.shared.farol_seed.value = (seed + 0x9e3779b9 * (1 + stage.stream + 32 * lightmap)) >>> 0;
    const before = this.done;
    const begin = performance.now();
    await slices.run({
      height: size,
      batches: stage.samples / stage.perDraw,
      draw: (batch, rows) => {
        this.shared.farol_firstSample.value = batch * stage.perDraw;
        stage.pass.draw(this.renderer, this.sums, 0, rows);
      },
      onSlice: (share, batch) => {
        this.done = before + share * stage.cost;
        if (performance.now() - this.lastPreview > PREVIEW_MILLISECONDS) {
          this.lastPreview = performance.now();
          if (!stage.isIndirect) keepState(this.renderer, () => this.showSoFar(lightmap, stage, batch));
        }
        this.options.onSlice(Math.min(1, this.done / this.whole), batch * stage.perDraw);
      },
    });
    measurePhase('trace', begin);
  }

  /** Where the texels of a lightmap are, and no light at them. */
  private prepare(lightmap: number): void {
    this.shared.farol_texelSize.value = 1 / this.options.texelsPerMetre[lightmap];
    this.surfaces.drawPlaces(lightmap, this.places);
    this.surfaces.drawAlbedo(lightmap, this.albedo);
    const { shared } = this;
    const settlePass = this.tracedSettle();
    shared.farol_positions.value = this.places.textures[0];
    settlePass.draw(this.renderer, this.settled);
    shared.farol_positions.value = this.settled.texture;
    this.sums.scissorTest = false;
    this.renderer.setRenderTarget(this.sums);
    this.renderer.clear();
  }

  private tracedSettle(): FullscreenPass {
    return (this.passes.settle ??= new FullscreenPass('settle', settle, this.shared, { defines: this.scene.defines }));
  }

  /** Ends a stage, and waits until the GPU has done so. */
  private async finishStage(
    lightmap: number,
    stage: Stage,
    isAdded: boolean,
    isReflected: boolean,
    slices: Slices,
  ): Promise<void> {
    const begin = performance.now();
    keepState(this.renderer, () => this.filterStage(lightmap, stage, isAdded, isReflected));
    await slices.wait();
    measurePhase('filter', begin);
  }

  /** Mean, denoise, fill: adds to the sum and to what the next bounce reflects. */
  private filterStage(lightmap: number, stage: Stage, isAdded: boolean, isReflected: boolean): void {
    const { shared, renderer } = this;
    shared.farol_samples.value = stage.samples;
    shared.farol_scale.value = stage.scale;
    this.pass('resolve', resolve).draw(renderer, this.light[0]);
    const filters = stage.isNoisy && this.options.denoise ? 4 : 0;
    for (let i = 0; i < filters; i++) {
      shared.farol_step.value = 2 ** i;
      this.filter('denoise', denoise);
    }
    for (let i = 0; i < 2; i++) this.filter('dilate', dilate);
    shared.farol_light.value = this.light[0].texture;
    const more = isAdded ? additive : {};
    const reflect = this.pass(isAdded ? 'reflectMore' : 'reflect', copy, { REFLECT: '' }, more);
    reflect.draw(renderer, this.nextRadiance, lightmap);
    if (this.reflected && isReflected) {
      this.pass('reflectMore', copy, { REFLECT: '' }, additive).draw(renderer, this.reflected, lightmap);
    }
    if (!stage.isIndirect) this.pass('add', copy, { ADD: '' }, additive).draw(renderer, this.totals[lightmap]);
  }

  /** From the first of the two light targets to the second, which is the first from then on. */
  private filter(name: string, fragment: string): void {
    const [a, b] = this.light;
    this.shared.farol_light.value = a.texture;
    this.pass(name, fragment).draw(this.renderer, b);
    this.light.reverse();
  }

  private showSoFar(lightmap: number, stage: Stage, batch: number): void {
    const { shared, renderer } = this;
    const samples = Math.max(1, batch * stage.perDraw);
    shared.farol_light.value = this.totals[lightmap].texture;
    shared.farol_scale.value = stage.scale / samples;
    this.pass('preview', preview).draw(renderer, this.light[0]);
    for (let i = 0; i < 2; i++) this.filter('dilate', dilate);
    this.shared.farol_light.value = this.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.pictureTargets[lightmap]);
  }

  /** Fills what is between charts, and shows the whole. */
  private finish(lightmap: number): void {
    const { shared, renderer } = this;
    shared.farol_light.value = this.totals[lightmap].texture;
    this.pass('rest', copy, { REST: '' }).draw(renderer, this.light[0]);
    for (let i = 0; i <= this.options.padding; i++) this.filter('dilate', dilate);
    shared.farol_light.value = this.light[0].texture;
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.pictureTargets[lightmap]);
    this.pass('picture', copy, { PICTURE: '' }).draw(renderer, this.totals[lightmap]);
  }

  private clearTotals(): void {
    for (const target of [...this.totals, ...this.pictureTargets]) {
      this.renderer.setRenderTarget(target);
      this.renderer.clear();
    }
    for (let lightmap = 0; this.reflected && lightmap < this.totals.length; lightmap++) {
      this.renderer.setRenderTarget(this.reflected, lightmap);
      this.renderer.clear();
    }
  }

  private clearLayer(lightmap: number): void {
    for (const target of [this.radiance, this.nextRadiance]) {
      this.renderer.setRenderTarget(target, lightmap);
      this.renderer.clear();
    }
  }
}

/** One kind of light, gathered at every texel. */
interface Stage {
  readonly pass: FullscreenPass;
  readonly samples: number;
  readonly perDraw: number;
  /** Of the whole work. */
  readonly cost: number;
  /** Irradiance by the mean of the samples. */
  readonly scale: number;
  /** Sets its random numbers apart. */
  readonly stream: number;
  /** Reflected, not shown. */
  readonly isIndirect: boolean;
  readonly isNoisy: boolean;
}
