import type { Vector3Tuple } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import { MeshBuilder, type Profile } from '@farol/engine/builders';
import type { MeshMakers } from '../registerMeshes';
import { addArchPanel } from './addArchPanel';
import { atriumPlan, bayWidth } from './atriumPlan';
import { curtainMesh, lampMesh, plantMesh, urnMesh } from './furnitureMeshes';

const { length, bays, nave, outer, storey, spring, upperSpring, thickness, slab } = atriumPlan;

/** A round column of `height` with base and capital; `radius` is the shaft's at its foot. */
function addColumn(builder: MeshBuilder, height: number, radius: number, segments: number): void {
  const base = radius * 0.75;
  const capital = radius * 1.7;
  const wide = radius * 1.42;
  const plinth = base * 0.35;
  builder.box([-wide, 0, -wide], [wide, plinth, wide], 0.4);
  const torus = (v: number): ReturnType<Profile> => {
    const ring = v < 0.55 ? Math.sin((v / 0.55) * Math.PI) * 0.3 : Math.sin(((v - 0.55) / 0.45) * Math.PI) * 0.18;
    return [radius * (1.06 + ring), plinth + (base - plinth) * v];
  };
  builder.lathe(segments, 8, torus, [3, 0.4]);
  const neck = height - capital;
  const shaft = (v: number): ReturnType<Profile> => [
    radius * (1 - 0.16 * v + 0.04 * Math.sin(Math.PI * v)),
    base + (neck - base) * v,
  ];
  builder.lathe(segments, 9, shaft, [radius * 6, neck - base]);
  const leaves = (u: number, v: number): Vector3Tuple => {
    const row = v < 0.5 ? v * 2 : v * 2 - 1;
    const leaf = 0.5 + 0.5 * Math.cos(u * 8 * 2 * Math.PI + (v < 0.5 ? 0 : Math.PI));
    const bell = radius * (0.86 + 0.42 * v * v) + radius * 0.2 * row ** 2 * leaf;
    const angle = -u * 2 * Math.PI;
    return [bell * Math.cos(angle), neck + capital * 0.82 * v, bell * Math.sin(angle)];
  };
  builder.lathe(segments, 3, (v) => [radius * (0.86 + 0.12 * Math.sin(Math.PI * v)), neck - 0.06 + 0.06 * v], [3, 0.1]);
  builder.surface(segments * 2, 9, leaves, [3, 0.6]);
  const top = height - capital * 0.18;
  builder.box([-wide, top, -wide], [wide, height, wide], 0.4);
}

export function lowerColumnMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  addColumn(builder, spring, 0.42, 28);
  return builder.build(0.7);
}

export function upperColumnMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  addColumn(builder, upperSpring, 0.3, 24);
  return builder.build(0.7);
}

/** The wall of a lower bay: one round arch on the columns, with mouldings and a medallion at each side. */
export function lowerArchMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  const top = storey - slab;
  addArchPanel(builder, { width: bayWidth, radius: bayWidth / 2 - 0.6, spring, top, thickness, segments: 32 });
  for (const side of [-1, 1]) {
    for (const face of [-1, 1]) {
      builder.at(side * (bayWidth / 2 - 0.5), top - 0.42, 0, face > 0 ? 0 : Math.PI);
      const rings = (u: number, v: number): Vector3Tuple => {
        const radius = 0.3 * (1 - v);
        const relief = 0.05 * Math.abs(Math.sin(v * 2.5 * Math.PI)) + 0.04 * v;
        return [radius * Math.cos(u * 2 * Math.PI), radius * Math.sin(u * 2 * Math.PI), thickness + relief];
      };
      builder.surface(16, 6, rings, [1, 0.3]);
    }
  }
  return builder.at(0, 0, 0).build(0.7);
}

const baluster: Profile = (v) => [0.05 + 0.05 * Math.sin(Math.PI * Math.min(1, v * 1.35)) ** 2, 0.1 + 0.75 * v];

/** The wall of an upper bay: two small arches on a slender column, over a balustrade. */
export function upperArchMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  const top = storey - 0.5;
  const small = bayWidth / 2;
  for (const side of [-1, 1]) {
    builder.at((side * small) / 2, 0, 0);
    addArchPanel(builder, {
      width: small,
      radius: small / 2 - 0.32,
      spring: upperSpring,
      top,
      thickness: thickness * 0.8,
      segments: 18,
    });
  }
  builder.at(0, 0, 0);
  addColumn(builder, upperSpring, 0.2, 16);
  for (const side of [-1, 1]) {
    for (let i = 0; i < 6; i++) {
      builder.at(side * (0.45 + i * 0.33), 0, 0);
      builder.lathe(8, 7, baluster, [0.5, 0.8]);
    }
    builder.at(0, 0, 0);
    const [from, to] = side > 0 ? [0.2, bayWidth / 2 - 0.25] : [0.25 - bayWidth / 2, -0.2];
    builder.box([from, 0, -0.13], [to, 0.1, 0.13], 0.5).box([from, 0.85, -0.15], [to, 0.98, 0.15], 0.5);
  }
  return builder.build(0.7);
}

/** The outer wall of a long side, facing +z: courses, pilasters and a blind arch with a window in each bay. */
export function longWallMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  const height = storey * 2;
  builder.patch([-length / 2, 0, 0], [length, 0, 0], [0, height, 0], 40, 12);
  for (let bay = 0; bay <= bays; bay++) {
    const x = bay * bayWidth - length / 2;
    for (const floor of [0, storey]) {
      builder.box([x - 0.35, floor, 0], [x + 0.35, floor + 0.5, 0.34], 0.7);
      builder.box([x - 0.28, floor + 0.5, 0], [x + 0.28, floor + storey - 1.1, 0.25], 0.7);
      builder.box([x - 0.38, floor + storey - 1.1, 0], [x + 0.38, floor + storey - slab, 0.36], 0.7);
    }
    if (bay === bays) continue;
    for (const floor of [0, storey]) {
      builder.at(x + bayWidth / 2, floor, 0.12);
      const panel = { width: bayWidth - 0.56, radius: 1.15, spring: 2.6, top: storey - slab, thickness: 0.12 };
      addArchPanel(builder, { ...panel, segments: 14, jambs: true });
    }
    builder.at(0, 0, 0);
  }
  return builder.build(0.7);
}

/** The wall of a short end, facing +z: a great blind arch between smaller ones. */
export function endWallMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  builder.patch([-outer, 0, 0], [2 * outer, 0, 0], [0, storey * 2, 0], 20, 12);
  const arches = [
    { x: 0, floor: 0, width: 6, radius: 1.9, spring: 3.2 },
    { x: -6.4, floor: 0, width: 5, radius: 1.3, spring: 2.6 },
    { x: 6.4, floor: 0, width: 5, radius: 1.3, spring: 2.6 },
    { x: -3, floor: storey, width: 4, radius: 1.1, spring: 2.6 },
    { x: 3, floor: storey, width: 4, radius: 1.1, spring: 2.6 },
    { x: -7.4, floor: storey, width: 4, radius: 1.1, spring: 2.6 },
    { x: 7.4, floor: storey, width: 4, radius: 1.1, spring: 2.6 },
  ];
  for (const { x, floor, ...arch } of arches) {
    builder.at(x, floor, 0.14);
    addArchPanel(builder, { ...arch, top: storey - slab, thickness: 0.14, segments: 18, jambs: true });
  }
  builder.at(0, 0, 0);
  for (const x of [-9.7, -3.5, 3.5, 9.7]) builder.box([x - 0.3, 0, 0], [x + 0.3, storey * 2, 0.36], 1);
  builder.box([-outer, storey - slab, 0], [outer, storey, 0.45], 1);
  return builder.build(0.7);
}

/** Floor of nave and aisles. */
export const floorMesh = (): BufferGeometry =>
  new MeshBuilder().patch([-length / 2, 0, outer], [length, 0, 0], [0, 0, -2 * outer], 40, 20).build();

/** Floor of a gallery, from the nave's edge (z = 0) to the outer wall at -z, with a string course along the nave. */
export function galleryMesh(): BufferGeometry {
  const width = outer - nave + thickness;
  const builder = new MeshBuilder().box([-length / 2, -slab, -width], [length / 2, 0, 0], 1);
  builder
    .box([-length / 2, -0.16, 0], [length / 2, 0.04, 0.22], 0.5)
    .box([-length / 2, -slab, 0], [length / 2, -slab + 0.12, 0.12], 0.5);
  for (let i = 0; i < bays * 12; i++) {
    const x = ((i + 0.5) * length) / (bays * 12) - length / 2;
    builder.box([x - 0.08, -0.28, 0], [x + 0.08, -0.16, 0.17]);
  }
  return builder.build();
}

/** Vault over an aisle, seen from below: groined, one groin to a bay; x along the aisle, z from 0 to -5. */
export function vaultMesh(): BufferGeometry {
  const width = outer - nave;
  const rise = storey - slab - spring - 0.05;
  const builder = new MeshBuilder();
  for (let bay = 0; bay < bays; bay++) {
    const x0 = bay * bayWidth - length / 2;
    const vault = (u: number, v: number): Vector3Tuple => {
      const along = Math.sqrt(Math.max(0, 1 - (2 * u - 1) ** 2));
      const across = Math.sqrt(Math.max(0, 1 - (2 * v - 1) ** 2));
      return [x0 + bayWidth * u, spring + rise * Math.max(along, across), -width * v];
    };
    builder.surface(14, 14, (u, v) => vault(u, 1 - v), [bayWidth, width]);
  }
  for (let bay = 1; bay < bays; bay++) {
    const x = bay * bayWidth - length / 2;
    const rib = (u: number, v: number): Vector3Tuple => {
      const angle = Math.PI * u;
      const around = Math.PI * (v - 0.5);
      const radius = 1 - 0.07 * Math.cos(around);
      const z = -width / 2 + (width / 2) * radius * Math.cos(angle);
      return [x + 0.22 * Math.sin(around), spring + rise * radius * Math.sin(angle), z];
    };
    builder.surface(16, 4, rib, [6, 0.4]);
  }
  return builder.build(0.7);
}

/** Roof over a gallery with its beams below and a cornice along the nave; z from 0 to -5 and beyond. */
export function roofMesh(): BufferGeometry {
  const width = outer - nave + thickness;
  const builder = new MeshBuilder().box([-length / 2, 0, -width], [length / 2, 0.3, 0.1], 2);
  for (let i = 0; i < bays * 4; i++) {
    const x = ((i + 0.5) * length) / (bays * 4) - length / 2;
    builder.box([x - 0.1, -0.25, -width], [x + 0.1, 0, -0.4], 1);
  }
  const slope = (u: number, v: number): Vector3Tuple => {
    const wave = 0.07 * Math.max(0, Math.cos(u * length * 2 * Math.PI));
    return [length * (u - 0.5), 0.42 + wave + 1.5 * v, 0.75 - (width + 0.75) * v];
  };
  return builder.surface(length * 8, 4, slope, [length, 6]).build(0.8);
}

/** Cornice on top of the upper arcade, facing +z. */
export function corniceMesh(): BufferGeometry {
  const builder = new MeshBuilder();
  builder.box([-length / 2, -0.5, -thickness], [length / 2, -0.3, thickness + 0.06], 1);
  builder.box([-length / 2, -0.3, -thickness], [length / 2, 0, thickness], 1);
  builder
    .box([-length / 2, 0, -thickness], [length / 2, 0.16, 0.75], 1)
    .box([-length / 2, 0.16, -thickness], [length / 2, 0.34, 0.88], 1);
  for (let i = 0; i < bays * 8; i++) {
    const x = ((i + 0.5) * length) / (bays * 8) - length / 2;
    builder.box([x - 0.11, -0.22, thickness], [x + 0.11, 0, 0.68]);
  }
  return builder.build();
}

/** The atrium's parts, by asset name. */
export const atriumMeshes: MeshMakers = Object.fromEntries(
  Object.entries({
    'lower-column': lowerColumnMesh,
    'upper-column': upperColumnMesh,
    'lower-arch': lowerArchMesh,
    'upper-arch': upperArchMesh,
    'long-wall': longWallMesh,
    'end-wall': endWallMesh,
    floor: floorMesh,
    gallery: galleryMesh,
    vault: vaultMesh,
    roof: roofMesh,
    cornice: corniceMesh,
    curtain: curtainMesh,
    urn: urnMesh,
    plant: plantMesh,
    lamp: lampMesh,
  }).map(([name, make]) => [`sponza/${name}`, make]),
);
