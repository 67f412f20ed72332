import type {
  BatchedMesh,
  BufferGeometry,
  InstancedBufferGeometry,
  InstancedMesh,
  Material,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  Texture,
} from 'three';
import { Object3D as AnyObject } from 'three';
import { surfacesOf } from '../../materials/surfacesOf';
import { batchIndices, batchMatrices, batchVisibilityChanged } from '../../three/batchTextures';
import { attributeId, attributeVersion, isOnGPU, type VertexAttribute } from '../../three/vertexData';

type Caster = Mesh & Partial<InstancedMesh> & Partial<BatchedMesh> & { isSkinnedMesh?: boolean };
type CasterMaterial = Material & Partial<MeshStandardMaterial>;

/** Names of uv attributes, by a texture's `channel`. */
const UVS = ['uv', 'uv1', 'uv2', 'uv3'];

let hash = 0;

/** Mixes an integer into the caster's signature (FNV-1a hash). */
function mix(value: number): void {
  hash = Math.imul(hash ^ value, 16777619);
}

function mixFraction(value: number): void {
  mix(value * 65536);
}

/** Mixes a texture, its transform and its uv attribute into the signature. */
function mixTexture(texture: Texture | null | undefined, geometry: BufferGeometry): void {
  if (!texture) return;
  const { id, version, offset, repeat, center, rotation, channel } = texture;
  mix(id);
  mix(version);
  mixFraction(offset.x);
  mixFraction(offset.y);
  mixFraction(repeat.x);
  mixFraction(repeat.y);
  mixFraction(center.x);
  mixFraction(center.y);
  mixFraction(rotation);
  if (!texture.matrixAutoUpdate) texture.matrix.elements.forEach(mixFraction);
  mixAttribute(geometry.attributes[UVS[channel]]);
}

function mixAttribute(attribute: VertexAttribute | null | undefined): void {
  if (!attribute) return;
  mix(attributeId(attribute));
  mix(attributeVersion(attribute));
}

function mixGeometry(geometry: BufferGeometry): void {
  mix(geometry.id);
  mixAttribute(geometry.attributes.position);
  mixAttribute(geometry.index);
  mix(geometry.drawRange.start);
  mix(geometry.drawRange.count);
  mix((geometry as InstancedBufferGeometry).instanceCount ?? 0);
}

function mixGroups({ groups }: BufferGeometry): void {
  for (const { start, count, materialIndex } of groups) {
    mix(start);
    mix(count);
    mix(materialIndex ?? 0);
  }
}

function mixMaterial(m: CasterMaterial, geometry: BufferGeometry): void {
  mix(m.id);
  mix(m.version);
  mix((m.visible ? 1 : 0) + (m.wireframe ? 2 : 0) + (m.alphaToCoverage ? 4 : 0));
  mix(m.side * 8 + (m.shadowSide ?? 7));
  mixFraction(m.alphaTest);
  if (m.alphaTest > 0 || m.alphaToCoverage) {
    mixTexture(m.map, geometry);
    mixTexture(m.alphaMap, geometry);
  }
  if (m.displacementMap) {
    mixTexture(m.displacementMap, geometry);
    mixAttribute(geometry.attributes.normal);
    mixFraction(m.displacementScale ?? 0);
    mixFraction(m.displacementBias ?? 0);
  }
  const surfaces = surfacesOf(m);
  if (surfaces !== undefined && (surfaces.displaces || surfaces.discards)) mixFraction(surfaces.shapeVersion());
}

/**
 * Hash of all that an object's shadow depends on except its world matrix: geometry, instances, and the properties of materials
 * that shadow maps use. Different states collide only by rare coincidence.
 */
export function casterSignature(object: Object3D): number {
  const caster = object as Caster;
  hash = -2128831035;
  const { geometry, material } = caster;
  mixGeometry(geometry);
  if (Array.isArray(material)) {
    mixGroups(geometry);
    for (const one of material) if (one) mixMaterial(one as CasterMaterial, geometry);
  } else mixMaterial(material as CasterMaterial, geometry);
  mix(object.layers.mask);
  if (caster.isInstancedMesh) {
    mixAttribute(caster.instanceMatrix);
    mix(caster.count!);
    mix(caster.morphTexture?.id ?? 0);
    mix(caster.morphTexture?.version ?? 0);
  }
  if (caster.isBatchedMesh) {
    const batch = object as BatchedMesh;
    mix(batchMatrices(batch).version);
    mix(batchIndices(batch).version);
    mix(batchVisibilityChanged(batch) ? 1 : 0);
  }
  return hash;
}

/**
 * True for objects whose shadow may change while matrix and signature do not: skinned, morphed, with own shaders, or with
 * vertices written by the GPU.
 */
export function isAnimatedCaster(object: Object3D): boolean {
  const caster = object as Caster;
  if (isOnGPU(caster.geometry.attributes.position)) return true;
  if (caster.isSkinnedMesh || caster.morphTargetInfluences?.length) return true;
  if (object.customDepthMaterial !== undefined || object.customDistanceMaterial !== undefined) return true;
  if (object.onBeforeShadow !== AnyObject.prototype.onBeforeShadow && !caster.isBatchedMesh) return true;
  const { material } = caster;
  return Array.isArray(material) ? material.some(isAnimatedMaterial) : isAnimatedMaterial(material);
}

/** @param material - null for a group without one, which three does not draw */
function isAnimatedMaterial(material: Material | null): boolean {
  return material?.clipShadows === true && material.clippingPlanes !== null && material.clippingPlanes.length > 0;
}
