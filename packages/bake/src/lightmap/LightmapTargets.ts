import {
  FloatType,
  HalfFloatType,
  type Texture,
  type WebGLArrayRenderTarget,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { type Grid, gridTargets } from './grid';
import { layersTarget, maskTarget, pictureTarget, texelTarget } from './targets';

export interface LightmapTargetsOptions {
  /** Texels along a side of each lightmap. */
  readonly size: number;
  /** Size of a texel of the coarse grid in texels of the lightmap: 1, 2 or 4. */
  readonly block: number;
  /** Number of lightmaps. */
  readonly layers: number;
  /** Whether any surface is emissive. */
  readonly shines: boolean;
  readonly hasProbes: boolean;
}

/**
 * Render targets for tracing lightmaps. One set of temporary targets serves all lightmaps in turn; per lightmap are
 * kept the sums, the picture, the moved texel positions and two layers of radiance.
 */
export class LightmapTargets {
  /** Present state of each lightmap, for materials to show while light is traced. */
  readonly pictures: WebGLRenderTarget[];
  readonly totals: WebGLRenderTarget[];
  /** Light gathered on the coarse grid so far, with its variance; empty when only the fine grid is used. */
  readonly indirect: WebGLRenderTarget[];
  readonly moves: WebGLRenderTarget[];
  readonly agreements: WebGLRenderTarget;
  readonly fine: Grid;
  /** Coarse grid, for light that was reflected twice or more; the fine grid itself when there is none. */
  readonly coarse: Grid;
  readonly albedo: WebGLRenderTarget;
  readonly emission;
  /**
   * Radiance of all surfaces, one layer per lightmap, in two textures: a gather reads the first and writes the second.
   */
  radiance;
  nextRadiance;
  /** Radiance of all but the last reflection, read by light probes. */
  readonly reflected;

  constructor({ size, block, layers, shines, hasProbes }: LightmapTargetsOptions) {
    const each = <T>(make: () => T): T[] => Array.from({ length: layers }, make);
    this.pictures = each(() => pictureTarget(size));
    this.totals = each(() => texelTarget(size, FloatType));
    this.moves = each(() => texelTarget(size, HalfFloatType));
    this.agreements = maskTarget(size);
    this.fine = { ...gridTargets(size), settled: texelTarget(size, FloatType) };
    this.coarse = block === 1 ? this.fine : { ...gridTargets(size / block), settled: null };
    this.indirect = block === 1 ? [] : each(() => texelTarget(size / block, FloatType));
    this.albedo = texelTarget(size, HalfFloatType);
    this.emission = layersTarget(shines ? size : 1, layers);
    this.radiance = layersTarget(size, layers);
    this.nextRadiance = layersTarget(size, layers);
    this.reflected = hasProbes ? layersTarget(size, layers) : null;
  }

  /**
   * Swaps the two radiance textures: the one written last is read by the next gather.
   * @returns the texture to read
   */
  swapRadiance(): Texture {
    [this.radiance, this.nextRadiance] = [this.nextRadiance, this.radiance];
    return this.radiance.texture;
  }

  /** Clears all targets that accumulate light during a bake. */
  clearTotals(renderer: WebGLRenderer): void {
    for (const target of [...this.totals, ...this.indirect, ...this.pictures]) {
      renderer.setRenderTarget(target);
      renderer.clear();
    }
    for (let lightmap = 0; this.reflected && lightmap < this.totals.length; lightmap++) {
      clearLayer(renderer, this.reflected, lightmap);
    }
  }

  clearNextRadiance(renderer: WebGLRenderer, lightmap: number): void {
    clearLayer(renderer, this.nextRadiance, lightmap);
  }

  dispose(): void {
    const { fine, coarse, totals, indirect, moves, pictures } = this;
    for (const grid of new Set([fine, coarse])) {
      for (const target of [grid.places, grid.sums, ...grid.light]) target.dispose();
      grid.settled?.dispose();
    }
    const single = [this.agreements, this.albedo, this.emission, this.radiance, this.nextRadiance];
    for (const target of [...single, ...totals, ...indirect, ...moves, ...pictures]) target.dispose();
    this.reflected?.dispose();
  }
}

function clearLayer(renderer: WebGLRenderer, target: WebGLArrayRenderTarget, layer: number): void {
  target.scissorTest = false;
  renderer.setRenderTarget(target, layer);
  renderer.clear();
}
