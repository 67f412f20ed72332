import type { RenderTarget } from 'three';

/** three's mark of a target that is drawn like the canvas: tone mapped, in the colour space of its texture. */
interface Marked {
  isXRRenderTarget?: boolean;
}

export function isDrawnAsCanvas(target: RenderTarget): boolean {
  return (target as Marked).isXRRenderTarget ?? false;
}

/** Marks a target of Farol's as drawn like the canvas, or (`does` false) not. */
export function setDrawnAsCanvas(target: RenderTarget, does: boolean): void {
  (target as Marked).isXRRenderTarget = does;
}
