import {
  type BufferGeometry,
  type InstancedMesh,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
} from 'three';
import { describe } from './describe';
import type { StaticMesh, Surface } from './StaticMesh';

export interface CollectOptions {
  isStatic(object: Object3D): boolean;
  throwsShadow(object: Object3D): boolean;
  /** Told, in a sentence, what is left out. */
  onWarning(sentence: string): void;
}

/**
 * Meshes of a scene that are seen and stay where they are. World matrices must be up to date.
 *
 * Left out with a warning: meshes without positions or triangles, with positions that are no numbers, or whose vertices a
 * skeleton or a batch moves. Instanced meshes throw shadows, and get no lightmap.
 */
export function collectMeshes(scene: Object3D, options: CollectOptions): StaticMesh[] {
  const found: StaticMesh[] = [];
  const visit = (object: Object3D): void => {
    if (!object.visible) return;
    if ((object as Mesh).isMesh && options.isStatic(object)) {
      const mesh = readMesh(object as Mesh, options);
      if (mesh) found.push(mesh);
    }
    object.children.forEach(visit);
  };
  visit(scene);
  return found;
}

function readMesh(mesh: Mesh, { throwsShadow, onWarning }: CollectOptions): StaticMesh | null {
  const name = describe(mesh);
  const skip = (why: string): null => {
    onWarning(`${name} is not baked: ${why}.`);
    return null;
  };
  if ((mesh as SkinnedMesh).isSkinnedMesh) return skip('its vertices are moved by bones');
  if ('isBatchedMesh' in mesh) return skip('batched meshes have one set of UVs for all their parts; use meshes');
  const { position } = mesh.geometry.attributes;
  if (!position) return skip('its geometry has no positions');
  for (let i = 0; i < position.count; i++) {
    if (Number.isFinite(position.getX(i) + position.getY(i) + position.getZ(i))) continue;
    return skip(`the position of its vertex ${i} is not a number`);
  }
  if (!mesh.matrixWorld.elements.every(Number.isFinite)) return skip('where it stands is not a number');
  const index = readIndex(mesh.geometry);
  if (index.some((vertex) => vertex >= position.count)) return skip('its index names a vertex that is not there');
  const surfaces = readSurfaces(mesh, index.length);
  if (surfaces.length === 0) return skip('it has no triangles');
  const isInstanced = 'isInstancedMesh' in mesh;
  if (isInstanced) {
    onWarning(
      `${name} gets no lightmap: its instances share one set of UVs. They throw shadows; use meshes to have them lit.`,
    );
  }
  const isLit = !isInstanced && surfaces.some(({ material }) => takesLightmap(material));
  return { mesh, name, placements: placementsOf(mesh), index, surfaces, isLit, throwsShadow: throwsShadow(mesh) };
}

/** Whether three draws a material with a lightmap as light that falls on it. Unlit materials would become darker. */
export function takesLightmap(material: Material): boolean {
  return 'lightMap' in material && !('isMeshBasicMaterial' in material);
}

function readIndex({ index, attributes, drawRange }: BufferGeometry): Uint32Array {
  const all = index
    ? Uint32Array.from(index.array)
    : Uint32Array.from({ length: attributes.position.count }, (_, i) => i);
  const end = Math.min(drawRange.start + drawRange.count, all.length);
  // what the draw range leaves out has no area, so that groups keep their places
  all.fill(0, 0, Math.min(drawRange.start, all.length));
  if (end < all.length) all.fill(0, end);
  return all.subarray(0, 3 * Math.floor(all.length / 3));
}

function readSurfaces({ material, geometry }: Mesh, length: number): Surface[] {
  const isSeen = (surface: Surface): boolean => surface.material?.visible && surface.count > 0;
  if (!Array.isArray(material)) return [{ material, start: 0, count: length }].filter(isSeen);
  return geometry.groups
    .map(({ start, count, materialIndex = 0 }) => ({
      material: material[materialIndex],
      start,
      count: 3 * Math.floor(Math.max(0, Math.min(count, length - start)) / 3),
    }))
    .filter(isSeen);
}

function placementsOf(mesh: Mesh): Matrix4[] {
  if (!('isInstancedMesh' in mesh)) return [mesh.matrixWorld.clone()];
  const instanced = mesh as InstancedMesh;
  return Array.from({ length: instanced.count }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(i, matrix);
    return matrix.premultiply(mesh.matrixWorld);
  });
}
