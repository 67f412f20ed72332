import { Box3, type DataTexture, Vector3 } from 'three';
import type { TracedLight } from '../scene/collectLights';
import { dataTexture } from './dataTexture';

const kinds = { directional: 0, point: 1, spot: 2, rectangle: 3, disc: 4, tube: 5 } as const;
/** Number of texels of a light in the table. */
const TEXELS = 9;
/** Maximum number of cells along the grid's longest side. */
const MOST_CELLS = 32;

/** Lights on the GPU: a table of lights, and a grid whose cells list the lights that reach them. */
export interface LightTable {
  readonly count: number;
  /** Whether any light casts shadows with soft edges, which need more than one sample. */
  readonly hasSoft: boolean;
  /** Whether any light casts hard shadows. */
  readonly hasHard: boolean;
  readonly lights: DataTexture;
  readonly cells: DataTexture;
  readonly cellLights: DataTexture;
  readonly grid: Vector3;
  readonly least: Vector3;
  readonly scale: Vector3;
  /** Number of lights without a range, which come first. */
  readonly endless: number;
  dispose(): void;
}

/** @param bounds - bounds of all surfaces, world space */
export function lightTable(all: readonly TracedLight[], bounds: Box3): LightTable {
  const reach = ({ kind, range }: TracedLight): number => (kind === 'point' || kind === 'spot' ? range : 0);
  const endless = all.filter((light) => reach(light) === 0);
  const lights = [...endless, ...all.filter((light) => reach(light) > 0)];
  const size = bounds.getSize(new Vector3()).addScalar(1e-6);
  const cell = Math.max(size.x, size.y, size.z) / MOST_CELLS;
  const grid = size.clone().divideScalar(cell).ceil().clampScalar(1, MOST_CELLS);
  const scale = grid.clone().divide(size);
  const lists = listsOfCells(lights, endless.length, bounds.min, grid, scale);
  const cells = new Float32Array(4 * lists.length);
  const entries: number[] = [];
  lists.forEach((list, i) => {
    cells[4 * i] = entries.length;
    cells[4 * i + 1] = list.length;
    for (const light of list) entries.push(light);
  });
  const textures = {
    lights: dataTexture(Float32Array.from(lights.flatMap(texelsOf))),
    cells: dataTexture(cells),
    cellLights: dataTexture(Float32Array.from(entries)),
  };
  return {
    ...textures,
    ...{ count: lights.length, grid, least: bounds.min.clone(), scale, endless: endless.length },
    hasSoft: lights.some(isSoft),
    hasHard: !lights.every(isSoft),
    dispose: () => Object.values(textures).forEach((texture) => texture.dispose()),
  };
}

const isSoft = ({ kind, radius }: TracedLight): boolean => radius > 0 || kinds[kind] >= kinds.rectangle;

export function lightUniforms(table: LightTable): Record<string, { value: unknown }> {
  return {
    farol_lights: { value: table.lights },
    farol_cells: { value: table.cells },
    farol_cellLights: { value: table.cellLights },
    farol_grid: { value: table.grid },
    farol_gridLeast: { value: table.least },
    farol_gridScale: { value: table.scale },
    farol_endlessLights: { value: table.endless },
  };
}

function listsOfCells(lights: readonly TracedLight[], first: number, least: Vector3, grid: Vector3, scale: Vector3) {
  const lists: number[][] = Array.from({ length: grid.x * grid.y * grid.z }, () => []);
  const at = new Vector3();
  for (let i = first; i < lights.length; i++) {
    const { position, range } = lights[i];
    const cellOf = (side: number): Vector3 =>
      position
        .clone()
        .addScalar(side * range)
        .sub(least)
        .multiply(scale)
        .floor();
    const [from, to] = [cellOf(-1).max(new Vector3()), cellOf(1).min(grid.clone().subScalar(1))];
    for (let z = from.z; z <= to.z; z++)
      for (let y = from.y; y <= to.y; y++)
        for (let x = from.x; x <= to.x; x++) {
          // the point of the cell nearest to the light
          at.copy(position).sub(least).multiply(scale);
          at.set(nearest(at.x, x), nearest(at.y, y), nearest(at.z, z)).divide(scale).add(least);
          if (at.distanceToSquared(position) <= range * range) lists[x + grid.x * (y + grid.y * z)].push(i);
        }
  }
  return lists;
}

const nearest = (value: number, cell: number): number => Math.min(Math.max(value, cell), cell + 1);

function texelsOf(light: TracedLight): number[] {
  const { position, colour, range, direction, decay, coneCosine, penumbraCosine, radius, spotExponent } = light;
  const { attenuation, ambient, halfWidth, halfHeight } = light;
  const [width, height] = [2 * halfWidth.length(), 2 * halfHeight.length()];
  const area = width * height * (light.kind === 'rectangle' ? 1 : light.kind === 'disc' ? Math.PI / 4 : Math.PI);
  const law =
    attenuation === null
      ? [0, 0, 0, 0]
      : attenuation.kind === 'near-far'
        ? [1, attenuation.near, attenuation.far, 0]
        : [2, attenuation.constant, attenuation.linear, attenuation.quadratic];
  const texels = [
    ...[...position.toArray(), kinds[light.kind]],
    ...[...colour.toArray(), range],
    ...[...direction.toArray(), decay],
    ...[coneCosine, penumbraCosine, radius, spotExponent],
    ...law,
    ...[...ambient.toArray(), 0],
    ...[...halfWidth.toArray(), area],
    ...[...halfHeight.toArray(), 0],
  ];
  return [...texels, ...Array<number>(4 * TEXELS - texels.length).fill(0)];
}
