import { Color, Vector3, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { expect, it } from 'vitest';
import type { SlicedWork, Slices } from '../gpu/Slices';
import type { LightTable } from '../trace/lightTable';
import type { SkySource } from '../trace/SkySource';
import type { TracedScene } from '../trace/TracedScene';
import { LightmapTracer } from './LightmapTracer';
import type { Surfaces } from './Surfaces';

const NOTHING = (): void => {};

/** A renderer that records each clear. Like three, it reads a target's scissor when the target is set, not later. */
function clearingRenderer(): { renderer: WebGLRenderer; clears: { size: number; isWhole: boolean }[] } {
  const clears: { size: number; isWhole: boolean }[] = [];
  let [size, isWhole] = [0, true];
  const renderer = {
    ...{ info: {}, xr: {}, setClearColor: NOTHING, render: NOTHING, getClearAlpha: () => 0 },
    ...{ getRenderTarget: () => null, getActiveCubeFace: () => 0, getActiveMipmapLevel: () => 0 },
    getClearColor: (target: Color) => target,
    setRenderTarget(target: WebGLRenderTarget | null) {
      if (target) [size, isWhole] = [target.width, !target.scissorTest];
    },
    clear: () => clears.push({ size, isWhole }),
  };
  return { renderer: renderer as unknown as WebGLRenderer, clears };
}

/** Draws each batch in two halves, so that the last draw of a stage leaves a scissor over the upper one. */
const halves = {
  wait: () => Promise.resolve(),
  run({ height, batches, draw, onSlice }: SlicedWork) {
    for (let batch = 0; batch < batches; batch++) {
      draw(batch, { first: 0, count: height / 2 });
      draw(batch, { first: height / 2, count: height / 2 });
    }
    onSlice(1, batches);
    return Promise.resolve();
  },
} as unknown as Slices;

it('clears whole targets, though a bake before or a stage before was drawn by rows', async () => {
  const { renderer, clears } = clearingRenderer();
  const surfaces: Partial<Surfaces> = { drawPlaces: NOTHING, drawAlbedo: NOTHING, drawEmission: NOTHING };
  const scene = { uniforms: {}, defines: {}, shines: true } as unknown as TracedScene;
  const options = { size: 8, texelsPerMetre: [1, 1], samples: 16, indirectScale: 0.5, bounces: 2 };
  const tracer = new LightmapTracer(renderer, surfaces as Surfaces, scene, {
    ...{ ...options, padding: 1, denoise: true, seed: 1, hasProbes: true, onSlice: NOTHING },
  });
  const zero = new Vector3();
  const table = { hasSoft: true, hasHard: true, grid: zero, least: zero, scale: zero } as unknown as LightTable;
  const sky: SkySource = { isBlack: false, uniforms: {}, defines: {} };
  const before = clears.length;
  await tracer.run([table, table], [sky, sky], halves);
  // per lightmap: four stages of direct light, four of gathers, and the radiance of direct light and three gathers
  expect(clears.length - before).toBe(2 * 12);
  expect(new Set(clears.map(({ size }) => size))).toEqual(new Set([8, 4]));
  expect(clears.filter(({ isWhole }) => !isWhole)).toEqual([]);
  tracer.dispose();
});
