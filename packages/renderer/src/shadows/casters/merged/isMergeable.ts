import { type BufferAttribute, type Material, type Mesh, type MeshStandardMaterial, Object3D } from 'three';
import { surfacesOf } from '../../../materials/surfacesOf';

/**
 * True for casters that a shadow map shows as plain triangles, placed by their matrix alone: no material discards fragments,
 * displaces or clips, and no callback runs on drawing. Call only for casters that have a box (see `casterBox`); animated ones
 * have none.
 */
export function isMergeable(object: Object3D): boolean {
  const { isMesh, geometry, material } = object as Mesh;
  if (!isMesh || Array.isArray(material) || !isPlain(material as MeshStandardMaterial)) return false;
  if (object.onAfterShadow !== Object3D.prototype.onAfterShadow) return false;
  const { start, count } = geometry.drawRange;
  if (start !== 0 || count !== Infinity) return false;
  const position = geometry.attributes.position as BufferAttribute;
  return position.getX !== undefined && position.itemSize === 3;
}

function isPlain(material: Material & Partial<MeshStandardMaterial>): boolean {
  const surfaces = surfacesOf(material as Material);
  const discards = material.alphaTest > 0 || material.alphaToCoverage || surfaces?.discards;
  return material.visible && !material.wireframe && !discards && !surfaces?.displaces;
}
