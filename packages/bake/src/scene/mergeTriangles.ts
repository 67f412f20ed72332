import {
  BackSide,
  type BufferAttribute,
  Color,
  DoubleSide,
  type InterleavedBufferAttribute,
  type Material,
  Matrix3,
  type Matrix4,
  type MeshStandardMaterial,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import type { UnwrappedMesh } from '../unwrap/UnwrapRequest';
import { takesLightmap } from './collectMeshes';
import type { StaticMesh } from './StaticMesh';

/** Contiguous triangles of one lightmap and one material. */
export interface TriangleRange {
  readonly material: Material;
  /** Index of the triangles' lightmap; -1 for none. */
  readonly lightmap: number;
  /** Whether the material reflects and emits light on both sides. */
  readonly isDoubleSided: boolean;
  readonly throwsShadow: boolean;
  /** Index of the range's first triangle. */
  readonly first: number;
  readonly count: number;
}

/** Triangles of all static meshes in world space, each with three corners of its own. */
export interface MergedTriangles {
  readonly count: number;
  /** Positions, nine numbers a triangle (m); counterclockwise seen from the front. */
  readonly positions: Float32Array;
  /** Unit normals, nine numbers per triangle, on its front. */
  readonly normals: Float32Array;
  /** Lightmap UVs (0 to 1), six numbers per triangle. */
  readonly lightmapUVs: Float32Array;
  /** UVs of the colour map and of the emissive map, six numbers each per triangle. */
  readonly mapUVs: Float32Array;
  readonly emissiveUVs: Float32Array;
  /** Linear vertex colours, nine numbers per triangle; null when no material uses vertex colours. */
  readonly colours: Float32Array | null;
  /** Ranges ordered by lightmap; triangles without one are last. */
  readonly ranges: readonly TriangleRange[];
}

interface Piece {
  readonly mesh: StaticMesh;
  readonly unwrapped: UnwrappedMesh | null;
  readonly placement: Matrix4;
  /** Index of the instance, for an instanced mesh. */
  readonly copy: number;
  readonly surface: StaticMesh['surfaces'][number];
}

/** Area (m²) below which a triangle is omitted. */
const NO_AREA = 1e-16;

/**
 * Merges static meshes into one list of triangles.
 *
 * @param unwrapped - lightmap coordinates of each mesh, by the mesh's index; null for meshes without a lightmap
 */
export function mergeTriangles(
  meshes: readonly StaticMesh[],
  unwrapped: readonly (UnwrappedMesh | null)[],
): MergedTriangles {
  const pieces = meshes.flatMap((mesh, i) =>
    mesh.placements.flatMap((placement, copy) =>
      mesh.surfaces.map((surface): Piece => ({ mesh, unwrapped: unwrapped[i], placement, copy, surface })),
    ),
  );
  const lightmapOf = ({ unwrapped, surface }: Piece): number =>
    unwrapped && takesLightmap(surface.material) ? unwrapped.lightmap : -1;
  const order = (piece: Piece): number => (lightmapOf(piece) < 0 ? Infinity : lightmapOf(piece));
  pieces.sort(
    (a, b) => order(a) - order(b) || (order(a) === Infinity ? 0 : a.surface.material.id - b.surface.material.id),
  );

  const most = pieces.reduce((sum, { surface }) => sum + surface.count / 3, 0);
  const hasColours = pieces.some(({ mesh, surface }) => mesh.colours !== null || surface.material.vertexColors);
  const merged = {
    positions: new Float32Array(9 * most),
    normals: new Float32Array(9 * most),
    lightmapUVs: new Float32Array(6 * most),
    mapUVs: new Float32Array(6 * most),
    emissiveUVs: new Float32Array(6 * most),
    colours: hasColours ? new Float32Array(9 * most).fill(1) : null,
  };
  const ranges: TriangleRange[] = [];
  let count = 0;
  for (const piece of pieces) {
    const first = count;
    count = addPiece(piece, merged, count);
    if (count === first) continue;
    const lightmap = lightmapOf(piece);
    const { material } = piece.surface;
    const last = ranges.at(-1);
    const { throwsShadow } = piece.mesh;
    const isSame = last?.material === material && last.lightmap === lightmap && last.throwsShadow === throwsShadow;
    if (last && isSame) {
      ranges[ranges.length - 1] = { ...last, count: last.count + count - first };
    } else {
      const isDoubleSided = material.side === DoubleSide;
      ranges.push({ material, lightmap, isDoubleSided, throwsShadow, first, count: count - first });
    }
  }
  const cut = (array: Float32Array, each: number): Float32Array => array.subarray(0, each * count);
  return {
    count,
    positions: cut(merged.positions, 9),
    normals: cut(merged.normals, 9),
    lightmapUVs: cut(merged.lightmapUVs, 6),
    mapUVs: cut(merged.mapUVs, 6),
    emissiveUVs: cut(merged.emissiveUVs, 6),
    colours: merged.colours && cut(merged.colours, 9),
    ranges,
  };
}

type Lists = Pick<MergedTriangles, 'positions' | 'normals' | 'lightmapUVs' | 'mapUVs' | 'emissiveUVs' | 'colours'>;

const corners = [new Vector3(), new Vector3(), new Vector3()];
const normal = new Vector3();
const faceNormal = new Vector3();
const edge = new Vector3();
const uv = new Vector2();
const normalMatrix = new Matrix3();
const vertexColour = new Color();

/** @returns number of triangles in the lists */
function addPiece({ mesh, unwrapped, placement, copy, surface }: Piece, lists: Lists, count: number): number {
  const { attributes } = mesh.geometry;
  const factor = mesh.colours?.[copy];
  const position = attributes.position as BufferAttribute;
  const material = surface.material as MeshStandardMaterial;
  // the front is the side that receives light
  const isFlipped = placement.determinant() < 0 !== (material.side === BackSide);
  const mapUV = uvReader(attributes, material.map ?? material.alphaMap);
  const emissiveUV = uvReader(attributes, material.emissiveMap);
  const colour = material.vertexColors ? attributes.color : undefined;
  const normals = material.flatShading ? undefined : attributes.normal;
  normalMatrix.getNormalMatrix(placement);
  const sign = material.side === BackSide ? -1 : 1;
  for (let i = surface.start; i < surface.start + surface.count; i += 3) {
    for (let k = 0; k < 3; k++) {
      corners[k].fromBufferAttribute(position, mesh.index[i + k]).applyMatrix4(placement);
    }
    faceNormal.subVectors(corners[1], corners[0]).cross(edge.subVectors(corners[2], corners[0]));
    const doubleArea = faceNormal.length();
    if (!(doubleArea > NO_AREA)) continue;
    faceNormal.multiplyScalar((isFlipped ? -1 : 1) / doubleArea);
    for (let corner = 0; corner < 3; corner++) {
      const k = isFlipped ? 2 - corner : corner;
      const vertex = mesh.index[i + k];
      const at = 3 * count + corner;
      corners[k].toArray(lists.positions, 3 * at);
      normal.copy(faceNormal);
      if (normals) {
        normal.fromBufferAttribute(normals, vertex).applyMatrix3(normalMatrix).multiplyScalar(sign);
        if (normal.lengthSq() > 0) normal.normalize();
        else normal.copy(faceNormal);
      }
      normal.toArray(lists.normals, 3 * at);
      if (unwrapped) {
        const place = unwrapped.index[i + k];
        lists.lightmapUVs[2 * at] = unwrapped.uv1[2 * place];
        lists.lightmapUVs[2 * at + 1] = unwrapped.uv1[2 * place + 1];
      }
      mapUV(vertex).toArray(lists.mapUVs, 2 * at);
      emissiveUV(vertex).toArray(lists.emissiveUVs, 2 * at);
      if (!lists.colours || !(colour || factor)) continue;
      vertexColour.setRGB(1, 1, 1);
      if (colour) vertexColour.fromBufferAttribute(colour as BufferAttribute, vertex);
      if (factor) vertexColour.multiply(factor);
      vertexColour.toArray(lists.colours, 3 * at);
    }
    count++;
  }
  return count;
}

/** Makes a reader of a texture's UVs, with its transform applied. It returns the same vector each time. */
function uvReader(
  attributes: Record<string, BufferAttribute | InterleavedBufferAttribute>,
  texture: Texture | null | undefined,
): (vertex: number) => Vector2 {
  const channel = texture?.channel ?? 0;
  const attribute = attributes[channel === 0 ? 'uv' : `uv${channel}`];
  if (!texture || !attribute) return () => uv.set(0, 0);
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  return (vertex) => uv.fromBufferAttribute(attribute as BufferAttribute, vertex).applyMatrix3(texture.matrix);
}
