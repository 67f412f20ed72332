import type { Vector3Tuple } from '@farol/editing/fields';
import type { MeshBuilder } from '@farol/engine/builders';

export interface ArchPanel {
  /** Width of the wall (m). */
  width: number;
  /** Radius of the opening (m). */
  radius: number;
  /** Height at which the arch springs (m). */
  spring: number;
  /** Height of the wall (m). */
  top: number;
  /** Half the thickness of the wall (m). */
  thickness: number;
  /** Number of facets of the arch. */
  segments: number;
  /** Whether the wall reaches down to y = 0 beside the opening. */
  jambs?: boolean;
}

/** A wall in the xy plane with a round arch cut out: two faces, each with a moulding round the arch, and the soffit. */
export function addArchPanel(builder: MeshBuilder, panel: ArchPanel): void {
  const { width, radius, spring, top, thickness, segments } = panel;
  const half = width / 2;
  const rim = (u: number, grow = 0): [number, number] => {
    const angle = Math.PI * (1 - u);
    return [(radius + grow) * Math.cos(angle), spring + (radius + grow) * Math.sin(angle)];
  };
  const edge = (u: number): [number, number] => {
    const angle = Math.PI * (1 - u);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const reach = Math.min(half / Math.max(Math.abs(c), 1e-9), (top - spring) / Math.max(s, 1e-9));
    return [reach * c, spring + reach * s];
  };
  for (const face of [1, -1]) {
    const wall = (u: number, v: number): Vector3Tuple => {
      const at = face > 0 ? u : 1 - u;
      const [[ax, ay], [bx, by]] = [rim(at), edge(at)];
      return [ax + (bx - ax) * v, ay + (by - ay) * v, thickness * face];
    };
    builder.surface(segments, 2, wall, [Math.PI * radius, top - spring - radius + 0.5]);
    const moulding = (u: number, v: number): Vector3Tuple => {
      const [x, y] = rim(face > 0 ? u : 1 - u, 0.02 + 0.2 * v);
      const relief = 0.07 * Math.sqrt(Math.max(0, 1 - (2 * v - 1) ** 2)) + 0.02 * Math.sin(v * 3 * Math.PI);
      return [x, y, (thickness + relief) * face];
    };
    builder.surface(segments, 5, moulding, [Math.PI * radius, 0.4]);
  }
  const soffit = (u: number, v: number): Vector3Tuple => [...rim(u), thickness * (2 * v - 1)];
  builder.surface(segments, 2, soffit, [Math.PI * radius, 2 * thickness]);
  if (panel.jambs) addJambs(builder, panel);
}

function addJambs(builder: MeshBuilder, { width, radius, spring, thickness }: ArchPanel): void {
  for (const side of [-1, 1]) {
    const [from, to] = side > 0 ? [radius, width / 2] : [-width / 2, -radius];
    builder.patch([from, 0, thickness], [to - from, 0, 0], [0, spring, 0], 1, 3);
    builder.patch([to, 0, -thickness], [from - to, 0, 0], [0, spring, 0], 1, 3);
    const depth = 2 * thickness;
    if (side > 0) builder.patch([radius, 0, -thickness], [0, 0, depth], [0, spring, 0], 1, 3);
    else builder.patch([-radius, 0, thickness], [0, 0, -depth], [0, spring, 0], 1, 3);
  }
}
