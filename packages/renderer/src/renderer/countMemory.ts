import type { FarolEffect } from '../frame/FarolEffect';
import type { Frame } from '../frame/Frame';
import type { FarolInfo } from './FarolInfo';
import type { LazyViews } from './LazyViews';
import type { LightFinder } from './LightFinder';
import type { SceneDraws } from './SceneDraws';
import type { TechniqueSet } from './TechniqueSet';

/** Writes the quality of a frame and the bytes that a renderer holds after it, by their use. */
export function countMemory(
  info: FarolInfo,
  frame: Frame,
  set: TechniqueSet,
  { shadows, areas }: LightFinder,
  draws: SceneDraws,
  views: LazyViews,
  effects: readonly FarolEffect[],
): void {
  const { memory } = info;
  info.quality = frame.isLite ? 'lite' : 'full';
  set.count(memory);
  memory.gbufferPixel = frame.gbufferPixel;
  memory.shadows = shadows?.bytes ?? 0;
  memory.lights = frame.lights.bytes + (areas?.bytes ?? 0) + (frame.fields?.bytes ?? 0);
  memory.targets += views.bytes;
  memory.effects = draws.bytes;
  for (const effect of effects) memory.effects += effect.bytes;
  info.targetBytes = memory.gbuffer + memory.targets + memory.lists + memory.shadows + memory.lights + memory.effects;
}
