import type { FarolEffect } from '../frame/FarolEffect';
import type { Frame } from '../frame/Frame';
import type { MemoryInfo } from './FarolInfo';
import type { LazyViews } from './LazyViews';
import type { LightFinder } from './LightFinder';
import type { SceneDraws } from './SceneDraws';
import type { TechniqueSet } from './TechniqueSet';

/** Writes the bytes that a renderer holds, by their use. @returns their sum */
export function countMemory(
  memory: MemoryInfo,
  frame: Frame,
  set: TechniqueSet,
  { shadows, areas }: LightFinder,
  draws: SceneDraws,
  views: LazyViews,
  effects: readonly FarolEffect[],
): number {
  set.count(memory);
  memory.gbufferPixel = frame.gbufferPixel;
  memory.shadows = shadows?.bytes ?? 0;
  memory.lights = frame.lights.bytes + (areas?.bytes ?? 0) + (frame.fields?.bytes ?? 0);
  memory.targets += views.bytes;
  memory.effects = draws.bytes;
  for (const effect of effects) memory.effects += effect.bytes;
  return memory.gbuffer + memory.targets + memory.lists + memory.shadows + memory.lights + memory.effects;
}
