import type { FarolEffect } from '../frame/FarolEffect';
import type { Frame } from '../frame/Frame';
import type { InfoRecorder } from './InfoRecorder';
import type { Pass } from '../frame/Pass';
import type { Resource } from '../frame/Resources';

/** Draws the passes of a technique in order, and the effects that follow or replace a pass; measures each. */
export function drawPasses(
  frame: Frame,
  technique: string,
  passes: readonly Pass[],
  effects: readonly FarolEffect[],
  recorder: InfoRecorder,
): void {
  const { resources } = frame;
  for (const pass of passes) {
    const replacement = replacementOf(pass, effects);
    recorder.beginPass(pass.name, replacement === null && pass.isIdle?.(frame) === true);
    resources.use(technique, pass);
    (replacement ?? pass).render!(frame, pass);
    resources.use(technique, null);
    recorder.endPass();
    for (const effect of effects) {
      if (effect.after === undefined || !sharesOne(effect.after, pass.writes)) continue;
      recorder.beginPass(effect.name);
      effect.render!(frame, pass);
      recorder.endPass();
    }
  }
  for (const effect of effects) {
    if (effect.end === undefined) continue;
    // the time of an effect with `after` was measured above
    if (effect.after === undefined) recorder.beginPass(effect.name);
    effect.end(frame);
    recorder.endPass();
  }
}

function replacementOf(pass: Pass, effects: readonly FarolEffect[]): FarolEffect | null {
  for (const effect of effects)
    if (effect.replaces !== undefined && pass.writes.includes(effect.replaces)) return effect;
  return null;
}

function sharesOne(some: readonly Resource[], others: readonly Resource[]): boolean {
  for (const one of some) if (others.includes(one)) return true;
  return false;
}
