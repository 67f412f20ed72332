import {
  BufferAttribute,
  BufferGeometry,
  Color,
  type InstancedMesh,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Vector3,
} from 'three';
import { describe } from './describe';
import type { StaticMesh, Surface } from './StaticMesh';

export interface CollectOptions {
  isStatic(object: Object3D, instance?: number): boolean;
  throwsShadow(object: Object3D): boolean;
  /** Called with a sentence for each mesh that is left out. */
  onWarning(sentence: string): void;
}

/**
 * Visible static meshes of a scene. World matrices must be up to date.
 *
 * Left out with a warning: BatchedMesh, and meshes without positions or triangles or with positions that are not finite.
 * Instanced and skinned meshes cast shadows and reflect light in their current pose, and get no lightmap.
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

function readMesh(mesh: Mesh, { isStatic, throwsShadow, onWarning }: CollectOptions): StaticMesh | null {
  const name = describe(mesh);
  const skip = (why: string): null => {
    onWarning(`${name} is not baked: ${why}.`);
    return null;
  };
  if ('isBatchedMesh' in mesh) return skip('batched meshes have one set of UVs for all their parts; use meshes');
  const { position } = mesh.geometry.attributes;
  if (!position) return skip('its geometry has no positions; give it some');
  if (!isReadable(mesh)) return skip('its vertices are on the GPU alone; keep their arrays until it is baked');
  for (let i = 0; i < position.count; i++) {
    if (Number.isFinite(position.getX(i) + position.getY(i) + position.getZ(i))) continue;
    return skip(`the position of its vertex ${i} is not a number; correct it`);
  }
  if (!mesh.matrixWorld.elements.every(Number.isFinite)) return skip('its position is not a number; correct it');
  const index = readIndex(mesh.geometry);
  if (index.some((vertex) => vertex >= position.count))
    return skip('its index names a vertex that does not exist; correct it');
  const surfaces = readSurfaces(mesh, index.length);
  if (surfaces.length === 0) return skip('it has no triangles');
  const isInstanced = 'isInstancedMesh' in mesh;
  const isSkinned = (mesh as SkinnedMesh).isSkinnedMesh;
  const copies = isInstanced
    ? Array.from({ length: (mesh as InstancedMesh).count }, (_, i) => i).filter((i) => isStatic(mesh, i))
    : null;
  if (copies?.length === 0) return null;
  if (isInstanced) {
    onWarning(
      `${name} gets no lightmap: its instances share one set of UVs. They cast shadows and reflect light; use single meshes to have them lit.`,
    );
  } else if (isSkinned) {
    onWarning(`${name} gets no lightmap: bones move it. It casts shadows and reflects light in its present pose.`);
  }
  const isLightable = surfaces.some(({ material }) => takesLightmap(material));
  const hasLightmap = !isInstanced && !isSkinned;
  return {
    ...{ mesh, name, index, surfaces },
    geometry: isSkinned ? posedGeometry(mesh) : mesh.geometry,
    placements: copies ? placementsOf(mesh as InstancedMesh, copies) : [mesh.matrixWorld.clone()],
    colours: copies && coloursOf(mesh as InstancedMesh, copies),
    isLit: hasLightmap && isLightable,
    isReflecting: !hasLightmap && isLightable,
    throwsShadow: throwsShadow(mesh),
  };
}

/** False for attributes whose array the host has freed or never provided. */
function isReadable(mesh: Mesh): boolean {
  const { instanceMatrix, instanceColor } = mesh as Partial<Pick<InstancedMesh, 'instanceMatrix' | 'instanceColor'>>;
  const { attributes, index } = mesh.geometry;
  const all = [...Object.values(attributes), index, instanceMatrix, instanceColor];
  return all.every((each) => !each || each.count === 0 || ('array' in each && each.array?.length > 0));
}

/** Geometry of a mesh skinned in its present pose, without normals: face normals are used. */
function posedGeometry(mesh: Mesh): BufferGeometry {
  const { attributes, index, groups, drawRange } = mesh.geometry;
  const posed = new BufferGeometry();
  const { count } = attributes.position;
  const positions = new Float32Array(3 * count);
  const place = new Vector3();
  for (let i = 0; i < count; i++) mesh.getVertexPosition(i, place).toArray(positions, 3 * i);
  for (const [name, attribute] of Object.entries(attributes))
    if (name !== 'normal') posed.setAttribute(name, attribute);
  posed.setAttribute('position', new BufferAttribute(positions, 3));
  posed.setIndex(index);
  posed.groups = groups;
  posed.setDrawRange(drawRange.start, drawRange.count);
  return posed;
}

/** Whether three applies a lightmap to the material as irradiance; unlit materials would become darker. */
export function takesLightmap(material: Material): boolean {
  return 'lightMap' in material && !('isMeshBasicMaterial' in material);
}

function readIndex({ index, attributes, drawRange }: BufferGeometry): Uint32Array {
  const all = index
    ? Uint32Array.from(index.array)
    : Uint32Array.from({ length: attributes.position.count }, (_, i) => i);
  const end = Math.min(drawRange.start + drawRange.count, all.length);
  // triangles outside the draw range are made empty, so that groups keep their index ranges
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

function placementsOf(mesh: InstancedMesh, copies: readonly number[]): Matrix4[] {
  return copies.map((i) => {
    const matrix = new Matrix4();
    mesh.getMatrixAt(i, matrix);
    return matrix.premultiply(mesh.matrixWorld);
  });
}

function coloursOf(mesh: InstancedMesh, copies: readonly number[]): Color[] | null {
  if (mesh.instanceColor === null) return null;
  return copies.map((i) => {
    const colour = new Color();
    mesh.getColorAt(i, colour);
    return colour;
  });
}
