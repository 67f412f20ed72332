import type { Vector3Tuple } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import { MeshBuilder, type Surface } from '@farol/engine/builders';
import type { MeshMakers } from '../registerMeshes';
import { templePlan, templeSize } from './templePlan';

const FLUTES = 20;

/** Radius of the shaft at v from foot (0) to neck (1): tapered, with a slight swelling. */
const shaftRadius = (v: number): number => {
  const { columnRadius } = templePlan;
  return columnRadius * (1 - 0.2 * v + 0.05 * Math.sin(Math.PI * Math.min(1, v * 1.1)));
};

/** A Doric column, standing on y = 0: shaft of 20 flutes with sharp edges, necking rings, echinus and abacus. */
export function columnMesh(): BufferGeometry {
  const { columnHeight, columnRadius } = templePlan;
  const shaft = columnHeight - 0.62;
  const fluted: Surface = (u, v) => {
    const within = (u * FLUTES) % 1;
    const depth = 0.055 * Math.sqrt(Math.max(0, 1 - (2 * within - 1) ** 2));
    const radius = shaftRadius(v) * (1 - depth);
    const angle = -u * 2 * Math.PI;
    return [radius * Math.cos(angle), shaft * v, radius * Math.sin(angle)];
  };
  const top = shaftRadius(1);
  const half = columnRadius * 1.18;
  return new MeshBuilder()
    .surface(FLUTES * 5, 14, fluted, [3.5, shaft])
    .lathe(
      48,
      8,
      (v) => [top * (1.0 + 0.05 * Math.abs(Math.sin(3 * Math.PI * v)) + 0.02 * v), shaft + 0.14 * v],
      [3, 0.2],
    )
    .lathe(
      48,
      8,
      (v) => [top * 1.03 + (half - top * 1.03) * Math.sin((v * Math.PI) / 2.2) ** 1.2, shaft + 0.14 + 0.24 * v],
      [3, 0.4],
    )
    .box([-half, shaft + 0.38, -half], [half, columnHeight, half], 0.5)
    .build(0.5);
}

/** The three steps, their lowest face on y = 0. */
export function stepsMesh(): BufferGeometry {
  const { steps, stepHeight, stepDepth, columnRadius } = templePlan;
  const builder = new MeshBuilder();
  for (let step = 0; step < steps; step++) {
    const out = columnRadius * 1.45 + stepDepth * (steps - 1 - step);
    const x = templeSize.halfWidth + out;
    const z = templeSize.halfLength + out;
    builder.box([-x, step * stepHeight, -z], [x, (step + 1) * stepHeight, z], 1);
  }
  return builder.build();
}

/** Adds a rectangular band with outer faces at ±x and ±z. */
function band(builder: MeshBuilder, x: number, z: number, thickness: number, from: number, to: number): void {
  builder
    .box([-x, from, z - thickness], [x, to, z], 1)
    .box([-x, from, -z], [x, to, thickness - z], 1)
    .box([x - thickness, from, thickness - z], [x, to, z - thickness], 1)
    .box([-x, from, thickness - z], [thickness - x, to, z - thickness], 1);
}

/** Adds triglyphs over each column and each gap, on a face of the frieze towards +z. */
function triglyphs(builder: MeshBuilder, columns: number, face: number, from: number, to: number): void {
  const { spacing } = templePlan;
  for (let i = 0; i <= (columns - 1) * 2; i++) {
    const centre = (i - (columns - 1)) * (spacing / 2);
    for (const bar of [-1, 0, 1]) {
      const x = centre + bar * 0.2;
      builder.box([x - 0.07, from, face - 0.02], [x + 0.07, to - 0.08, face + 0.09]);
    }
    builder.box([centre - 0.3, to - 0.08, face - 0.02], [centre + 0.3, to, face + 0.1]);
  }
}

/** Architrave, frieze with triglyphs, and cornice; y = 0 is the top of the columns. */
export function entablatureMesh(): BufferGeometry {
  const { architraveHeight, friezeHeight, corniceHeight, cornice, columnRadius, columnsAcross, columnsAlong } =
    templePlan;
  const builder = new MeshBuilder();
  const out = columnRadius * 0.95;
  const x = templeSize.halfWidth + out;
  const z = templeSize.halfLength + out;
  const frieze = architraveHeight + friezeHeight;
  band(builder, x, z, out * 2, 0, architraveHeight - 0.1);
  band(builder, x + 0.06, z + 0.06, out * 2 + 0.06, architraveHeight - 0.1, architraveHeight);
  band(builder, x, z, out * 2, architraveHeight, frieze);
  for (const turn of [0, Math.PI]) {
    builder.at(0, 0, 0, turn);
    triglyphs(builder, columnsAcross, z, architraveHeight, frieze);
    builder.at(0, 0, 0, turn + Math.PI / 2);
    triglyphs(builder, columnsAlong, x, architraveHeight, frieze);
  }
  builder.at(0, 0, 0);
  band(builder, x + cornice * 0.6, z + cornice * 0.6, 1.2, frieze, frieze + corniceHeight * 0.4);
  band(builder, x + cornice, z + cornice, 1.4, frieze + corniceHeight * 0.4, frieze + corniceHeight);
  return builder.build();
}

/** The roof with its tiles, a pediment at each end, and a ceiling; y = 0 is the top of the cornice. */
export function roofMesh(): BufferGeometry {
  const { cornice, columnRadius, pitch } = templePlan;
  const builder = new MeshBuilder();
  const x = templeSize.halfWidth + columnRadius + cornice;
  const z = templeSize.halfLength + columnRadius + cornice;
  const rise = x * pitch;
  const length = Math.hypot(x, rise);
  for (const side of [0, Math.PI]) {
    builder.at(0, 0, 0, side);
    const rows = Math.round(z * 2) * 6;
    const tiled: Surface = (u, v) => {
      const along = z - 2 * z * v;
      const bump = 0.09 * Math.max(0, Math.cos(v * Math.round(z * 2) * 2 * Math.PI)) ** 2;
      const course = 0.05 * ((u * 9) % 1);
      return [x * (1 - u), rise * u + 0.26 + bump - course, -along];
    };
    builder.surface(36, rows, (u, v) => tiled(u, 1 - v), [length, 2 * z]);
    builder.patch([x, 0, z], [0, 0, -2 * z], [0, 0.26, 0], 1, 12);
    const inner = z - 0.75;
    builder.triangle([-x + 0.9, 0.03, inner], [x - 0.9, 0.03, inner], [0, rise - 0.9 * pitch, inner]);
    for (const half of [-1, 1]) rakingCornice(builder, x, z, rise, half);
  }
  builder.at(0, 0, 0).patch([-x, 0, -z], [2 * x, 0, 0], [0, 0, 2 * z], 12, 20);
  return builder.build(0.6);
}

/** Adds the sloping cornice over one half of the pediment that faces +z. */
function rakingCornice(builder: MeshBuilder, x: number, z: number, rise: number, half: number): void {
  const thick = 0.26;
  const back = z - 0.8;
  const foot: Vector3Tuple = [half * x, 0, z];
  const slope: Vector3Tuple = [-half * x, rise, 0];
  const up: Vector3Tuple = [0, thick, 0];
  const under: Vector3Tuple = [0, 0, back - z];
  if (half > 0) {
    builder.patch([0, rise, z], [half * x, -rise, 0], up, 8);
    builder.patch([half * x, 0, z], slope, under, 8);
  } else {
    builder.patch(foot, slope, up, 8);
    builder.patch([0, rise, z], [half * x, -rise, 0], under, 8);
  }
}

/** The inner room's walls with a doorway towards +z; stands on y = 0. */
export function cellaMesh(): BufferGeometry {
  const { columnHeight, spacing } = templePlan;
  const x = templeSize.halfWidth - spacing;
  const z = templeSize.halfLength - spacing * 1.5;
  const thick = 0.6;
  const door = { half: 1.5, height: 4.4 };
  return new MeshBuilder()
    .box([-x, 0, -z], [x, columnHeight, thick - z], 1)
    .box([-x, 0, thick - z], [thick - x, columnHeight, z - thick], 1)
    .box([x - thick, 0, thick - z], [x, columnHeight, z - thick], 1)
    .box([-x, 0, z - thick], [-door.half, columnHeight, z], 1)
    .box([door.half, 0, z - thick], [x, columnHeight, z], 1)
    .box([-door.half, door.height, z - thick], [door.half, columnHeight, z], 1)
    .box([-door.half - 0.25, 0, z], [-door.half, door.height + 0.3, z + 0.12])
    .box([door.half, 0, z], [door.half + 0.25, door.height + 0.3, z + 0.12])
    .box([-door.half, door.height, z], [door.half, door.height + 0.3, z + 0.12])
    .build();
}

/** The temple's parts, by asset name. */
export const templeMeshes: MeshMakers = {
  'temple/column': columnMesh,
  'temple/steps': stepsMesh,
  'temple/entablature': entablatureMesh,
  'temple/roof': roofMesh,
  'temple/cella': cellaMesh,
};
