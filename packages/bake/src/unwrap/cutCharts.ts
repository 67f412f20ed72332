import type { XAtlasModule } from 'xatlas-wasm';
import type { SurfaceToUnwrap } from './UnwrapRequest';

/** A flattened surface: charts side by side, in metres. */
export interface Charts {
  /** Area of all charts (m²). */
  readonly area: number;
  /** UVs of the vertices, two numbers each (m). */
  readonly uvs: Float32Array;
  /** Vertex indices, three per triangle, in the order of the surface's triangles. */
  readonly index: Uint32Array;
  /** Source vertex in the surface, one per vertex. */
  readonly sourceVertex: Uint32Array;
  /** Chart of each triangle; NO_CHART for those without area. */
  readonly charts: Uint32Array;
}

/** Chart index of triangles that are in no chart. */
export const NO_CHART = 0xffffffff;

/** Number of triangles after which xatlas closes a chart, since growth takes superlinear time. */
const TRIANGLES_OF_A_CHART = 1500;
/** Resolution of a chart layout: texels along the side of a square with the surface's area. */
const RESOLUTION = 1024;

/**
 * Cuts a surface into flat charts with little distortion.
 *
 * @see xatlas, after thekla_atlas; least squares conformal maps, Lévy 2002
 */
export function cutCharts(xatlas: XAtlasModule, { positions, normals, index }: SurfaceToUnwrap): Charts {
  const atlas = xatlas.createAtlas();
  try {
    const error = atlas.addMesh({ positions, indices: index, ...(normals ? { normals } : {}) });
    if (error !== 0)
      throw new Error(`A mesh cannot be unwrapped (${xatlas.addMeshErrorString(error)}): correct its index.`);
    const area = surfaceArea(positions, index);
    const triangles = index.length / 3;
    // growing a chart takes quadratic time in its triangles
    const maxBoundaryLength =
      triangles > TRIANGLES_OF_A_CHART ? 5 * Math.sqrt((area * TRIANGLES_OF_A_CHART) / triangles) : 0;
    atlas.computeCharts({ maxBoundaryLength, maxIterations: 1 });
    const texelsPerUnit = RESOLUTION / Math.sqrt(area);
    atlas.packCharts({ texelsPerUnit, padding: 4, blockAlign: true, rotateCharts: false });
    const { vertices, indices, charts } = atlas.getMesh(0);
    const uvs = new Float32Array(2 * vertices.length);
    const sourceVertex = new Uint32Array(vertices.length);
    vertices.forEach(({ uv, xref }, i) => {
      uvs[2 * i] = uv[0] / texelsPerUnit;
      uvs[2 * i + 1] = uv[1] / texelsPerUnit;
      sourceVertex[i] = xref;
    });
    const chartOf = new Uint32Array(triangles).fill(NO_CHART);
    charts.forEach(({ faces }, chart) => faces.forEach((face) => (chartOf[face] = chart)));
    return { area, uvs, index: Uint32Array.from(indices), sourceVertex, charts: chartOf };
  } finally {
    atlas.destroy();
  }
}

/** Area of a surface (m²). @param positions - three numbers per vertex @param index - three per triangle */
function surfaceArea(positions: Float32Array, index: Uint32Array): number {
  let area = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [3 * index[i], 3 * index[i + 1], 3 * index[i + 2]];
    const [ux, uy, uz] = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    area += 0.5 * Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  }
  return area;
}
