import { DataUtils, type Mesh } from 'three';
import type { Scene } from '../../core/Scene';
import type { BakeData, LightmapData, LightmappedMesh } from '../../assets/bake/BakeData';
import { bakeSignature } from '../bakeSignature';
import { bakeSources } from '../bakeSources';

/** A lightmap whose brightness grows along x and y. */
export function gradient(width: number, height: number): LightmapData {
  const data = new Uint16Array(4 * width * height);
  for (let y = 0, at = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const light = (x + 0.5) / width;
      for (const value of [light, 0.8 * light, 0.2 + (0.5 * y) / height, 1]) data[at++] = DataUtils.toHalfFloat(value);
    }
  }
  return { width, height, data };
}

/** Lightmap attributes of a mesh whose triangles share no vertices. */
function split(mesh: Mesh): Pick<LightmappedMesh, 'uv1' | 'index' | 'sourceVertex' | 'sourceVertices'> {
  const { geometry } = mesh;
  const sourceVertices = geometry.getAttribute('position').count;
  const corners = geometry.index
    ? Uint32Array.from(geometry.index.array)
    : Uint32Array.from({ length: sourceVertices }, (_, i) => i);
  const uv1 = Float32Array.from({ length: 2 * corners.length }, (_, i) => ((i * 37) % 101) / 100);
  return { sourceVertices, sourceVertex: corners, index: Uint32Array.from(corners.keys()), uv1 };
}

/** Baked light for a scene, without tracing rays. */
export function smallBake(scene: Scene, size = 16): BakeData {
  scene.three.updateMatrixWorld(true);
  const { meshes, lights } = bakeSources(scene);
  return {
    signature: bakeSignature(scene),
    lights: lights.filter(({ mode }) => mode === 'baked').map(({ id }) => id),
    hasSky: false,
    channel: 1,
    lightmaps: [gradient(size, size)],
    meshes: meshes.map(({ mesh, component, part }) => ({ ...split(mesh), component: component.id, part, lightmap: 0 })),
    probes: {
      box: { min: [-1, 0, -1], max: [1, 2, 1], counts: [2, 2, 2] },
      coefficients: Float32Array.from({ length: 27 * 8 }, (_, i) => (i % 27 < 3 ? 1 : 0)),
    },
  };
}
