import type { DirectionalLight, Light, SpotLight } from 'three';
import type { LightTable } from '../../lighting/LightTable';

/** Maximum number of lights of a kind compared in a frame; of more lights, each frame compares the next part. */
const LOOKS = 256;

/** Detects lights that changed or moved, by their objects: records in the light table also change with the camera. */
export class LightWatch {
  private readonly known = new WeakMap<Light, number>();
  private next = 0;

  /** Whether a light seen before has changed. With many lights, some are compared only in later frames. */
  changed(lights: Pick<LightTable, 'directionals' | 'unboundeds' | 'boundeds'>): boolean {
    const { boundeds } = lights;
    let changed = this.compare(lights.directionals, 0, LOOKS);
    changed = this.compare(lights.unboundeds, 0, LOOKS) || changed;
    if (this.next >= boundeds.length) this.next = 0;
    changed = this.compare(boundeds, this.next, LOOKS) || changed;
    this.next += LOOKS;
    return changed;
  }

  private compare(lights: readonly Light[], from: number, count: number): boolean {
    let changed = false;
    const end = Math.min(lights.length, from + count);
    for (let i = from; i < end; i++) {
      const now = stateOf(lights[i]);
      const before = this.known.get(lights[i]);
      if (before === now) continue;
      this.known.set(lights[i], now);
      if (before !== undefined) changed = true;
    }
    return changed;
  }
}

function stateOf(light: Light): number {
  const { color, intensity, matrixWorld } = light;
  const { distance = 0, angle = 0, penumbra = 0, target } = light as SpotLight;
  const e = matrixWorld.elements;
  let sum = intensity + color.r * 3 + color.g * 5 + color.b * 7 + distance * 11 + angle * 13 + penumbra * 17;
  for (let i = 0; i < 15; i++) sum += e[i] * (i + 19);
  if ((light as DirectionalLight).isDirectionalLight === true || target !== undefined) {
    const t = target.matrixWorld.elements;
    sum += t[12] * 37 + t[13] * 41 + t[14] * 43;
  }
  return sum;
}
