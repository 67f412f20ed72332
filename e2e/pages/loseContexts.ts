import type { FarolEffect, TechniqueName } from '@farol/renderer';
import { type EffectName, loadEffects } from '@farol/renderer/effects';
import { Decal } from '@farol/renderer/decals';
import * as THREE from 'three';
import { Bench, type PageImage } from './Bench';
import { countGpuObjects, type GpuObjects } from './gpuObjects';
import { shadowScene } from './shadowScene';
import { isSlice } from './techniquesInTurn';

const effectClasses = await loadEffects();

/** Results over several losses of the context. */
export interface LossResults {
  /** Losses after which a picture was not the same, to the bit. */
  readonly changed: number[];
  /** GPU objects after the first frames, and after the last loss. */
  readonly before: GpuObjects;
  readonly after: GpuObjects;
  /** Counts of three (`info.memory`) after the first frames and after the last loss. */
  readonly memory: [object, object];
}

/** Frames in which maps, merged casters and the past of TAA become what they stay. */
const FRAMES = 4;

/**
 * Loses the context again and again, and draws the same frames after each as at first: shadows of each kind of light, a decal,
 * a light's image, in verify glass. The size changes at each loss and back, so that targets of the context that was lost are let go of.
 */
export async function loseContexts(
  technique: TechniqueName,
  losses: number,
  effectNames: readonly EffectName[],
): Promise<LossResults> {
  const count = countGpuObjects();
  const bench = new Bench(96, 64);
  bench.webgl.shadowMap.enabled = true;
  // as a host must: three would delete what it has of a target in a context that it does not belong to
  bench.webgl.domElement.addEventListener('webglcontextlost', () => bench.target.dispose());
  const image = new THREE.DataTexture(new Uint8Array([255, 200, 90, 255, 90, 160, 255, 255]), 2, 1);
  image.needsUpdate = true;
  const { scene, camera } = shadowScene(96, 64, { caster: isSlice ? 'spot' : 'mixed', map: image, few: isSlice });
  const decal = new Decal(new THREE.MeshStandardMaterial({ color: 0x00ff00 }));
  decal.position.set(1, 0, 1.5);
  decal.rotation.x = -Math.PI / 2;
  if (effectNames.includes('decals')) scene.add(decal);
  const list: FarolEffect[] = effectNames.map((name) => new effectClasses[name]());
  const frames = (): PageImage => {
    // with and without: what is switched off holds targets too
    bench.farol.effects = [];
    bench.byTechnique(technique, scene, camera);
    bench.farol.effects = list;
    let picture!: PageImage;
    for (let i = 0; i < FRAMES; i++) picture = bench.byTechnique(technique, scene, camera);
    bench.farol.effects = [];
    return picture;
  };
  const first = frames();
  const resize = (): void => {
    bench.setSize(80, 60);
    frames();
    bench.setSize(96, 64);
  };
  // once before the counts: tables whose size depends on the picture's alternate between textures that are kept
  resize();
  frames();
  const before = count();
  const memory = () => ({ ...bench.webgl.info.memory, programs: bench.programs });
  const memoryBefore = memory();
  const changed: number[] = [];
  for (let loss = 1; loss <= losses; loss++) {
    await bench.loseContext();
    const { data } = frames();
    if (data.some((value, i) => value !== first.data[i])) changed.push(loss);
    resize();
  }
  frames();
  const after = count();
  const memoryAfter = memory();
  bench.farol.dispose();
  for (const effect of list) effect.dispose();
  return { changed, before, after, memory: [memoryBefore, memoryAfter] };
}
