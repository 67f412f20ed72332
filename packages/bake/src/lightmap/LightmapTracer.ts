import { CustomBlending, OneFactor, type Texture, type WebGLRenderer } from 'three';
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
import { LightmapFilters } from './LightmapFilters';
import { LightmapTargets } from './LightmapTargets';
import move from './move.glsl?raw';
import settle from './settle.glsl?raw';
import { directStages, gathersOf, type Stage, type StageSource } from './stages';
import type { Surfaces } from './Surfaces';

export interface LightmapTracerOptions {
  readonly size: number;
  /** Texels per metre, one number per lightmap. */
  readonly texelsPerMetre: readonly number[];
  readonly samples: number;
  /** Resolution of light that was reflected twice or more, as a share of the lightmap's side: 1, 0.5 or 0.25. */
  readonly indirectScale: number;
  readonly bounces: number;
  readonly padding: number;
  readonly denoise: boolean;
  readonly seed: number;
  readonly hasProbes: boolean;
  /**
   * Called after each slice.
   * @param share - share of all work that is done, 0 to 1
   * @param samples - samples of the present stage so far
   */
  onSlice(share: number, samples: number): void;
}

/** Cost (in samples) of moving a texel's point out of walls by settle.glsl: 4 short rays and 8 to 24 long ones. */
const SETTLE_COST = 10;
/** Time between two previews (ms). */
const PREVIEW_MILLISECONDS = 250;

const additive = { transparent: true, blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor } as const;

/**
 * Traces the light of lightmaps: direct light first, then reflected light in gathers. The first gather collects light
 * from the sky, emissive surfaces and the reflection of direct light; each later one the reflection of the gather
 * before. Since that light is smooth, later gathers use a coarser grid.
 */
export class LightmapTracer {
  /** Present state of each lightmap, for materials to show while the tracer runs. */
  readonly pictures: readonly Texture[];
  private readonly targets: LightmapTargets;
  private readonly filters: LightmapFilters;
  private readonly passes: Record<string, FullscreenPass> = {};
  private readonly shared: Record<string, { value: unknown }>;
  /** Index of the lightmap whose texel positions are in the targets; -1 for none. */
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
    const { size, texelsPerMetre, indirectScale, hasProbes } = options;
    const { shines } = scene;
    const block = Math.round(1 / indirectScale);
    const layers = texelsPerMetre.length;
    const targets = new LightmapTargets({ size, block, layers, shines, hasProbes });
    this.targets = targets;
    this.pictures = targets.pictures.map(({ texture }) => texture);
    this.shared = {
      ...scene.uniforms,
      farol_seed: { value: options.seed >>> 0 },
      farol_stride: { value: 1 },
      farol_places: { value: targets.fine.places.textures[0] },
      farol_settled: { value: targets.fine.settled!.texture },
      farol_placeNormals: { value: targets.fine.places.textures[1] },
      farol_placeFaces: { value: targets.fine.places.textures[2] },
      farol_moves: { value: null },
      farol_block: { value: block },
      farol_positions: { value: null },
      farol_texelNormals: { value: null },
      farol_faces: { value: null },
      farol_texelSize: { value: 1 },
      farol_firstSample: { value: 0 },
      farol_sums: { value: null },
      farol_sourceSums: { value: null },
      farol_light: { value: null },
      farol_albedo: { value: targets.albedo.texture },
      farol_agreements: { value: targets.agreements.texture },
      farol_agreedSamples: { value: 0 },
      farol_samples: { value: 1 },
      farol_scale: { value: 1 },
      farol_step: { value: 1 },
      farol_emission: { value: targets.emission.texture },
      farol_radiance: { value: null },
    };
    this.filters = new LightmapFilters(renderer, targets, this.shared, options);
    keepState(renderer, () => targets.clearTotals(renderer));
  }

  /**
   * Traces all lightmaps.
   * @param tables - lights that are baked whole, then lights whose reflected light alone is baked
   * @param skies - ambient and hemisphere light, in the same order
   */
  async run(
    tables: readonly [LightTable, LightTable],
    skies: readonly [SkySource, SkySource],
    slices: Slices,
  ): Promise<void> {
    const { targets, filters } = this;
    const { bounces } = this.options;
    const layers = targets.totals.length;
    const source = this.stageSource();
    const direct = directStages(source, tables);
    const gathers = gathersOf(source, skies);
    const all = [...direct, ...gathers.flatMap(({ stages }) => stages)];
    this.whole = layers * (SETTLE_COST + all.reduce((sum, stage) => sum + stage.cost, 0));
    if (this.scene.shines) {
      keepState(this.renderer, () => targets.totals.forEach((_, i) => this.surfaces.drawEmission(i, targets.emission)));
    }
    for (let lightmap = 0; lightmap < layers; lightmap++) {
      await this.settle(lightmap, slices);
      keepState(this.renderer, () => targets.clearNextRadiance(this.renderer, lightmap));
      for (const stage of direct) {
        await this.runStage(stage, lightmap, slices);
        await this.timed(slices, () => filters.finishDirect(lightmap, stage, bounces > 0));
      }
    }
    for (const { stages, isReflected, probes } of gathers) {
      this.shared.farol_radiance.value = targets.swapRadiance();
      for (let lightmap = 0; lightmap < layers; lightmap++) {
        keepState(this.renderer, () => targets.clearNextRadiance(this.renderer, lightmap));
        for (const stage of stages) {
          await this.runStage(stage, lightmap, slices);
          await this.timed(slices, () => filters.finishGather(lightmap, stage, isReflected, probes));
        }
      }
    }
    for (let lightmap = 0; lightmap < layers; lightmap++) {
      await this.timed(slices, () => {
        this.use(lightmap);
        if (gathers.length > 1 && targets.indirect.length > 0) filters.addIndirect(lightmap);
        filters.finish(lightmap);
      });
    }
  }

  /** Light at points, for probes. Call after a run with `hasProbes`. */
  readProbes(points: Float32Array, table: LightTable, sky: SkySource, slices: Slices): Promise<BakedProbes> {
    this.shared.farol_seed.value = (this.options.seed + 0x51ed270b) >>> 0;
    return traceProbes(this.renderer, slices, {
      ...{ points, table, sky, samples: this.options.samples },
      uniforms: { ...this.shared, farol_reflected: { value: this.targets.reflected!.texture } },
      defines: this.scene.defines,
      onSlice: (_, samples) => this.options.onSlice(1, samples),
    });
  }

  /** Light of a lightmap as floats, four per texel. Call after a run. */
  async read(lightmap: number): Promise<Float32Array> {
    const { size } = this.options;
    const target = this.targets.totals[lightmap];
    const data = new Float32Array(4 * size * size);
    await this.renderer.readRenderTargetPixelsAsync(target, 0, 0, size, size, data);
    return data;
  }

  dispose(): void {
    this.targets.dispose();
    this.filters.dispose();
    Object.values(this.passes).forEach((pass) => pass.dispose());
  }

  private stageSource(): StageSource {
    const { options, scene } = this;
    const { fine, coarse } = this.targets;
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

  private pass(name: string, fragment: string): FullscreenPass {
    return (this.passes[name] ??= new FullscreenPass(name, fragment, this.shared));
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
    this.filters.useGrid(grid, lightmap);
    this.shared.farol_agreedSamples.value = 0;
    // each stage needs a random sequence of its own
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
      keepState(this.renderer, () => this.pass('agree', agree).draw(this.renderer, this.targets.agreements));
      this.shared.farol_agreedSamples.value = firstSamples;
    }
    await draw(first, batches - first);
    measurePhase('trace', begin, { indirectSamples: stage.isGather ? samples * grid.size ** 2 : 0 });
  }

  /** Reports a slice. @param samples - samples of the stage so far */
  private tellSlice(stage: Stage, lightmap: number, samples: number): void {
    if (performance.now() - this.lastPreview > PREVIEW_MILLISECONDS && !stage.isIndirect) {
      this.lastPreview = performance.now();
      keepState(this.renderer, () => this.filters.showSoFar(lightmap, stage, samples));
    }
    this.options.onSlice(Math.min(1, this.done / this.whole), samples);
  }

  /** Computes the positions at which the texels of a lightmap are lit. */
  private async settle(lightmap: number, slices: Slices): Promise<void> {
    const begin = performance.now();
    const { places } = this.targets.fine;
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
      draw: (_, rows) => pass.draw(this.renderer, this.targets.moves[lightmap], 0, rows),
      onSlice: (share) => {
        this.done = before + share * SETTLE_COST;
        this.options.onSlice(Math.min(1, this.done / this.whole), 0);
      },
    });
    keepState(this.renderer, () => this.placeTexels(lightmap));
    measurePhase('trace', begin, { indirectSamples: 0 });
  }

  /** Draws the texel positions of a lightmap into the targets. */
  private use(lightmap: number): void {
    if (this.prepared === lightmap) return;
    this.drawPlaces(lightmap);
    this.placeTexels(lightmap);
  }

  private drawPlaces(lightmap: number): void {
    this.prepared = -1;
    this.surfaces.drawPlaces(lightmap, this.targets.fine.places);
    this.surfaces.drawAlbedo(lightmap, this.targets.albedo);
  }

  private placeTexels(lightmap: number): void {
    const { moves, fine, coarse } = this.targets;
    this.shared.farol_moves.value = moves[lightmap].texture;
    this.pass('move', move).draw(this.renderer, fine.settled!);
    if (coarse !== fine) this.pass('coarsen', coarsen).draw(this.renderer, coarse.places);
    this.prepared = lightmap;
  }

  /** Runs GPU work at the end of a stage, and waits until the GPU has done it. */
  private async timed(slices: Slices, work: () => void): Promise<void> {
    const begin = performance.now();
    keepState(this.renderer, work);
    await slices.wait();
    measurePhase('filter', begin);
  }
}
