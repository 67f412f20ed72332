import type { HemisphereLight, Light, PointLight, RectAreaLight, SpotLight } from 'three';

/** Finds lights with a value that is not a finite number: they would make every pixel NaN. */
export class FiniteLights {
  private readonly warned = new WeakSet<Light>();

  /** Returns whether all values of a light are finite; if not, warns once for the light. */
  check(light: Light): boolean {
    const e = light.matrixWorld.elements;
    const l = light as PointLight & SpotLight & RectAreaLight & HemisphereLight;
    let sum = e[12] + e[13] + e[14] + light.color.r + light.color.g + light.color.b + light.intensity;
    if (l.decay !== undefined) sum += l.decay;
    if (l.angle !== undefined) sum += l.angle + l.penumbra;
    if (l.width !== undefined) sum += l.width + l.height + e[1] + e[4];
    if (l.groundColor !== undefined) sum += l.groundColor.r + l.groundColor.g + l.groundColor.b;
    const target = l.target?.matrixWorld.elements;
    if (target !== undefined) sum += target[12] + target[13] + target[14];
    if (Number.isFinite(sum)) return true;
    if (!this.warned.has(light)) {
      this.warned.add(light);
      console.warn(
        `Farol: ${light.type} "${light.name || light.uuid}" is left out: its place, colour or another value is not a finite number; set one.`,
      );
    }
    return false;
  }
}
