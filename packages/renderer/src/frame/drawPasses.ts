import type { FarolEffect } from './FarolEffect';
import type { Frame } from './Frame';
import type { InfoRecorder } from './InfoRecorder';
import type { Pass, Resource } from './Pass';

/** Draws the passes of a technique in their order, with the effects after them or in their place, each with its figures. */
export function drawPasses(
  frame: Frame,
  passes: readonly Pass[],
  effects: readonly FarolEffect[],
  recorder: InfoRecorder,
): void {
  for (const pass of passes) {
    recorder.beginPass(pass.name);
    (replacementOf(pass, effects) ?? pass).render!(frame, pass);
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
    // what draws after passes has its figures already
    if (effect.after === undefined) recorder.beginPass(effect.name);
    effect.end(frame);
    recorder.endPass();
  }
}

function replacementOf(pass: Pass, effects: readonly FarolEffect[]): FarolEffect | null {
  for (const effect of effects) if (effect.replaces === pass.name) return effect;
  return null;
}

function sharesOne(some: readonly Resource[], others: readonly Resource[]): boolean {
  for (const one of some) if (others.includes(one)) return true;
  return false;
}
