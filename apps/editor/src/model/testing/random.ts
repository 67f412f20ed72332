import type { GameObject, Scene } from '@farol/engine';

/** Generator of numbers in [0, 1). */
export type Random = () => number;

/** An integer in [0, `count`). */
export const below = (random: Random, count: number): number => Math.floor(random() * count);

export const pick = <T>(random: Random, list: readonly T[]): T => list[below(random, list.length)];

export function objectsOf(scene: Scene): GameObject[] {
  const all: GameObject[] = [];
  scene.traverse((object) => all.push(object));
  return all;
}
