import type { SceneBuilder } from '../SceneBuilder';

interface LightGrid {
  /** Number of lights from left to right. */
  count: number;
  /** Number of lights from front to back. Default `count`. */
  rows?: number;
  /** Side of the square below the lights (m). */
  side: number;
  /** Height of the lit floor (m). */
  floor: number;
  /** Whether the first four lights cast shadows. Default false. */
  shadows?: boolean;
}

/** Adds `count` × `rows` moving point lights in a grid over a square, about equally bright for any number. */
export function addLightGrid(
  build: SceneBuilder,
  { count, rows = count, side, floor, shadows = false }: LightGrid,
): void {
  const [across, along] = [side / Math.max(count, 1), side / Math.max(rows, 1)];
  const spacing = Math.min(across, along);
  const height = Math.min(2, Math.max(0.45, spacing * 0.3));
  const range = Math.max(1.6, Math.min(spacing * 1.15, 12));
  build.movingLights(count * rows, build.group('Lights'), (i, random) => ({
    position: [
      ((i % count) + 0.5) * across - side / 2,
      floor + height,
      (Math.floor(i / count) + 0.5) * along - side / 2,
    ],
    extent: [across * 0.7, height * 0.3, along * 0.7],
    speed: Math.min(2, spacing) * (0.5 + random()),
    range,
    intensity: 2.6 * height * height,
    castShadow: shadows && i < 4,
  }));
}
